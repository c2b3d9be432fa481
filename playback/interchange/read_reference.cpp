// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "model/file/json_place.h"
#include "model/file/text_file.h"
#include "playback/interchange/reference_signal.h"
#include "playback/interchange/reference_waves.h"
#include "playback/offline/press_files.h"
#include "playback/offline/resample.h"

namespace detent::playback {

namespace {

constexpr std::size_t largestText = std::size_t{16} << 20;
// duration of all waves together, limited so that reading takes well under a second
constexpr double mostSounding_s = 1200;
constexpr std::size_t longestName = 60, mostNotes = 16;

Failure unreadable(const std::string& name, Message place, Message problem, const Message& remedy) {
  return {FailureCode::unreadableInput, Subject(name), std::move(place), std::move(problem), remedy};
}

Message anyOfThem() { return Message("Give an AHAP, .haptic or HJIF file, or a sound file such as a WAV"); }

/// Shortens a text from the file for a note to people.
std::string shortened(std::string text) {
  if (text.size() > longestName) text = text.substr(0, longestName) + "...";
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  return text;
}

/// Lowers samples that exceed full scale.
void turnDown(std::vector<double>& samples, ReferenceSignal& signal) {
  double peak = 0;
  for (const double sample : samples) peak = std::fmax(peak, std::fabs(sample));
  const double gain = peak > 1 ? 1 / peak : 1;
  // Excess caused by rounding is not reported.
  if (peak > 1 + 1e-6)
    signal.notes.emplace_back(
        Message("the signal exceeds full scale by a factor of %1 and is turned down", peak));
  signal.samples.reserve(samples.size());
  for (const double sample : samples) signal.samples.push_back(static_cast<float>(sample * gain));
  signal.peak = peak * gain;
}

Result<ReferenceSignal> played(const ReferenceWaves& read, ReferenceFormat format, const std::string& name) {
  double end_s = 0, sounding_s = 0;
  for (const PlayedWave& wave : read.waves) {
    if (wave.points.empty()) continue;
    end_s = std::fmax(end_s, wave.points.back().time_s);
    sounding_s += wave.points.back().time_s - wave.points.front().time_s;
  }
  if (!(end_s > 0))
    return unreadable(name, {}, Message("the file contains nothing to play"),
                      Message("Give a file with events"));
  if (end_s > longestReference_s)
    return unreadable(name, {}, Message("the file lasts %1 s", end_s),
                      Message("Give a file of at most %1 s", longestReference_s));
  if (sounding_s > mostSounding_s)
    return unreadable(name, {}, Message("the events of the file overlap and last %1 s in total", sounding_s),
                      Message("Give a file whose events last at most %1 s in total", mostSounding_s));
  std::vector<double> samples(static_cast<std::size_t>(std::ceil(end_s * referenceRate_Hz)) + 1, 0);
  addTo(samples, read.waves, referenceRate_Hz);
  ReferenceSignal signal;
  signal.format = format;
  signal.events = read.events;
  signal.notes = read.notes;
  turnDown(samples, signal);
  return signal;
}

using Head = std::array<char, 24>;

std::string_view wordOf(const Head& head, std::size_t at) { return {head.data() + at, 4}; }

bool isSound(const Head& head) {
  constexpr std::array kinds{"RIFF", "RIFX", "RF64", "riff", "fLaC", "FORM", "OggS", "caff", ".snd"};
  return std::ranges::find(kinds, wordOf(head, 0)) != kinds.end();
}

std::uint64_t bigEndian(const Head& head, std::size_t at, std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | static_cast<unsigned char>(head[at + i]);
  return value;
}

std::uint64_t littleEndian(const Head& head, std::size_t at, std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes; i-- > 0;) value = value << 8 | static_cast<unsigned char>(head[at + i]);
  return value;
}

/// Size that the file's own header states; 0 if none. Streams of unknown length contain 0 or the largest
/// number.
std::uint64_t statedSize(const Head& head) {
  const std::string_view kind = wordOf(head, 0);
  constexpr std::uint64_t unknown = 0xFFFFFFFF, chunkHead = 8;
  const auto known = [](std::uint64_t size, std::uint64_t before) {
    return size == 0 || size == unknown ? 0 : size + before;
  };
  if (kind == "RIFF") return known(littleEndian(head, 4, 4), chunkHead);
  if (kind == "RIFX" || kind == "FORM") return known(bigEndian(head, 4, 4), chunkHead);
  if (kind == ".snd") return known(bigEndian(head, 8, 4), bigEndian(head, 4, 4));
  return kind == "riff" ? littleEndian(head, 16, 8) : 0;
}

bool isCutOff(const Head& head, const std::filesystem::path& file) {
  std::error_code unknown;
  const std::uint64_t size = std::filesystem::file_size(file, unknown);
  return !unknown && statedSize(head) > size;
}

Result<ReferenceSignal> soundReference(const Head& head, const std::filesystem::path& file) {
  if (isCutOff(head, file))
    return unreadable(file.string(), {}, Message("the file is cut off"),
                      Message("Export or copy the file again"));
  Result<SoundSamples> sound = readSoundFile(file, longestReference_s);
  if (!sound) return sound.failure();
  ReferenceSignal signal;
  signal.format = ReferenceFormat::sound;
  if (sound->onlyChannel > 0)
    signal.notes.emplace_back(
        Message("only channel %1 of %2 is played, because the channels would cancel each other out",
                static_cast<std::size_t>(sound->onlyChannel), static_cast<std::size_t>(sound->channels)));
  else if (sound->channels > 1)
    signal.notes.emplace_back(
        Message("the mean of its %1 channels is played", static_cast<std::size_t>(sound->channels)));
  const std::vector<float> even = resampled(sound->samples, sound->sampleRate_Hz, referenceRate_Hz);
  std::vector<double> samples(even.begin(), even.end());
  turnDown(samples, signal);
  return signal;
}

/// The text without commas before a closing bracket, which occur in Apple's own AHAP samples.
std::string withoutClosingCommas(std::string_view text) {
  std::string kept;
  kept.reserve(text.size());
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    const std::size_t next =
        c == ',' && !quoted ? text.find_first_not_of(" \t\r\n", i + 1) : std::string_view::npos;
    if (next == std::string_view::npos || (text[next] != '}' && text[next] != ']')) kept += c;
    if (c == '\\' && i + 1 < text.size()) kept += text[++i];
  }
  return kept;
}

/// Throws nlohmann's parse_error, with the position in `text`. `closingCommas`: the text is JSON except for
/// such commas.
nlohmann::json jsonOf(std::string_view text, bool& closingCommas) {
  const std::string kept = withoutClosingCommas(text);
  closingCommas = kept.size() < text.size();
  if (closingCommas)
    if (nlohmann::json json = nlohmann::json::parse(kept, nullptr, false); !json.is_discarded()) return json;
  return nlohmann::json::parse(text.begin(), text.end());
}

ReferenceSignal playedOrThrown(const nlohmann::json& json, const std::string& name) {
  const JsonPlace file(json, "", name);
  const auto give = [&](const ReferenceWaves& waves, ReferenceFormat format) {
    Result<ReferenceSignal> signal = played(waves, format, name);
    if (!signal) throw signal.failure();
    return *std::move(signal);
  };
  if (file.has("Pattern")) return give(ahapWaves(file), ReferenceFormat::ahap);
  if (file.has("signals")) return give(hapticWaves(file), ReferenceFormat::haptic);
  if (file.has("perceptions")) return give(hjifWaves(file), ReferenceFormat::hjif);
  file.refuse(Message("the file is JSON, but not a haptic file"), anyOfThem());
}

}  // namespace

void ReferenceWaves::note(Message message) {
  const std::string said = english(message);
  const bool known =
      std::any_of(notes.begin(), notes.end(), [&](const Message& n) { return english(n) == said; });
  if (!known && notes.size() < mostNotes) notes.push_back(std::move(message));
}

JsonPlace JsonPlace::at(const char* key) const {
  const std::string place = place_.empty() ? key : place_ + "." + key;
  if (!has(key)) refuse(Message("the field %1 is missing", key), anyOfThem());
  return {value_.at(key), place, file_};
}

std::vector<JsonPlace> JsonPlace::elements() const {
  if (!value_.is_array()) refuse(Message("the value is not a list"), anyOfThem());
  std::vector<JsonPlace> list;
  list.reserve(value_.size());
  for (std::size_t i = 0; i < value_.size(); ++i)
    list.emplace_back(value_[i], place_ + "[" + std::to_string(i) + "]", file_);
  return list;
}

double JsonPlace::number(double low, double high) const {
  if (!value_.is_number()) refuse(Message("the value is not a number"), Message("Correct the value"));
  const double number = value_.get<double>();
  if (!(number >= low && number <= high))
    refuse(Message("the value is %1", number), Message("Give a number from %1 to %2", low, high));
  return number;
}

double JsonPlace::numberOr(const char* key, double otherwise, double low, double high) const {
  return has(key) ? at(key).number(low, high) : otherwise;
}

std::string JsonPlace::text() const {
  if (!value_.is_string()) refuse(Message("the value is not text"), Message("Correct the value"));
  return shortened(value_.get<std::string>());
}

std::string JsonPlace::textOr(const char* key, const std::string& otherwise) const {
  return has(key) ? at(key).text() : otherwise;
}

void JsonPlace::refuse(Message problem, const Message& remedy) const {
  throw unreadable(file_, Message(place_), std::move(problem), remedy);
}

Result<ReferenceSignal> referenceFromText(std::string_view text, const std::string& name) {
  if (text.size() > largestText)
    return unreadable(name, {}, Message("the file is larger than %1 MB", largestText >> 20),
                      Message("Give a shorter file"));
  try {
    bool closingCommas = false;
    const nlohmann::json json = jsonOf(text, closingCommas);
    ReferenceSignal signal = playedOrThrown(json, name);
    if (closingCommas)
      signal.notes.emplace_back(
          Message("commas before a closing bracket are not valid JSON; they are ignored"));
    return signal;
  } catch (const Failure& failure) {
    return failure;
  } catch (const nlohmann::json::parse_error& error) {
    return unreadable(name, placeOfByte(text, error.byte), notJson(text, error.byte),
                      Message("Export the file again: it may have been cut off"));
  } catch (const nlohmann::json::out_of_range& error) {
    return unreadable(name, {},
                      Message("the file holds a number that is too large: %1", numberIn(error.what())),
                      Message("Correct the number"));
  }
}

Result<ReferenceSignal> readReference(const std::filesystem::path& file) {
  Head head{};
  std::ifstream(file, std::ios::binary).read(head.data(), head.size());
  if (isSound(head)) return soundReference(head, file);
  Result<std::string> text = readTextFile(file.string());
  if (!text) return text.failure();
  const std::size_t first = text->find_first_not_of(" \t\r\n");
  if (first == std::string::npos)
    return unreadable(file.string(), {}, Message("the file is empty"), anyOfThem());
  if (std::string_view(head.data(), 4) == "MIHS" || (*text)[first] != '{')
    return unreadable(file.string(), {},
                      Message("the file is neither JSON nor a sound file that can be read"), anyOfThem());
  return referenceFromText(*text, file.string());
}

}  // namespace detent::playback
