// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <set>

#include <catch2/catch.hpp>

#include "model/file/text_file.h"
#include "playback/interchange/reference_signal.h"
#include "playback/interchange/reference_waves.h"
#include "playback/offline/press_files.h"
#include "playback/offline/resample.h"

using namespace detent;
using namespace detent::playback;

namespace {

constexpr double readRate_Hz = referenceRate_Hz;

ReferenceSignal read(const std::string& text) {
  Result<ReferenceSignal> signal = referenceFromText(text, "file");
  INFO((signal ? std::string() : signal.failure().sentence()));
  REQUIRE(signal.ok());
  return *signal;
}

std::string refusal(const std::string& text) {
  Result<ReferenceSignal> signal = referenceFromText(text, "file");
  REQUIRE_FALSE(signal.ok());
  CHECK(signal.failure().code == FailureCode::unreadableInput);
  CHECK_FALSE(signal.failure().remedies.empty());
  return signal.failure().sentence();
}

/// Largest difference from `expected(time)` between two times; infinite where a sample is no number.
template <class Expected>
double worstSample(const ReferenceSignal& signal, double from_s, double to_s, Expected expected) {
  double most = 0;
  for (auto i = static_cast<std::size_t>(std::ceil(from_s * readRate_Hz));
       i < static_cast<std::size_t>(to_s * readRate_Hz); ++i) {
    const double off =
        std::fabs(static_cast<double>(signal.samples.at(i)) - expected(static_cast<double>(i) / readRate_Hz));
    if (std::isnan(off)) return std::numeric_limits<double>::infinity();
    most = std::fmax(most, off);
  }
  return most;
}

double sine(double cycles) { return std::sin(2 * std::numbers::pi * cycles); }

std::string ahap(const std::string& pattern) { return R"({"Version": 1.0, "Pattern": [)" + pattern + "]}"; }
std::string haptic(const std::string& envelopes) {
  return R"({"version": {"major": 1, "minor": 0, "patch": 0}, "signals": {"continuous": {"envelopes": )" +
         envelopes + "}}}";
}
std::string hjif(const std::string& band, const std::string& rest = R"("timescale": 1000)") {
  return R"({"version": "2023", "profile": "Main", "level": 1, )" + rest +
         R"(, "perceptions": [{"id": 0, "effect_library": [{"id": 7, "effect_type": "Basis", "position": 5, "base_signal": "Sine",
            "keyframes": [{"relative_position": 0, "amplitude_modulation": 0.5, "frequency_modulation": 200}, {"relative_position": 10}]}],
            "channels": [{"gain": 0.5, "bands": [)" +
         band + "]}]}]}";
}

const std::string continuous =
    R"({"Event": {"Time": 0.1, "EventType": "HapticContinuous", "EventDuration": 0.2, "EventParameters": [
       {"ParameterID": "HapticIntensity", "ParameterValue": 0.8}, {"ParameterID": "HapticSharpness", "ParameterValue": 0.4}]}})";

}  // namespace

TEST_CASE("An AHAP event is as strong as the square of its intensity and as high as its sharpness") {
  const ReferenceSignal signal = read(ahap(continuous));
  CHECK(signal.format == ReferenceFormat::ahap);
  CHECK(signal.events == 1);
  CHECK(signal.notes.empty());
  CHECK(worstSample(signal, 0, 0.1, [](double) { return 0.0; }) == 0);
  CHECK(worstSample(signal, 0.1, 0.3, [](double t) { return 0.64 * sine((t - 0.1) * (80 + 150 * 0.4)); }) <
        1e-6);
  CHECK(signal.duration_s() == Approx(0.3).margin(1e-4));
}

TEST_CASE("An AHAP curve multiplies the intensity and is kept behind its last point; a transient falls") {
  const ReferenceSignal signal = read(ahap(continuous + R"(,
    {"ParameterCurve": {"ParameterID": "HapticIntensityControl", "Time": 0.1, "ParameterCurveControlPoints": [
       {"Time": 0, "ParameterValue": 0}, {"Time": 0.1, "ParameterValue": 0.5}]}},
    {"Event": {"Time": 0.5, "EventType": "HapticTransient", "EventParameters": [
       {"ParameterID": "HapticIntensity", "ParameterValue": 7}, {"ParameterID": "HapticSharpness", "ParameterValue": -3}]}})"));
  const auto level = [](double t) { return std::pow(0.8 * std::fmin(0.5, 5 * (t - 0.1)), 2); };
  CHECK(worstSample(signal, 0.1, 0.3, [&](double t) { return level(t) * sine((t - 0.1) * 140); }) < 1e-4);
  CHECK(worstSample(signal, 0.5, 0.522,
                    [](double t) { return 0.25 * (1 - (t - 0.5) / 0.022) * sine((t - 0.5) * 80); }) < 1e-6);
}

namespace {

/// Four seconds at full intensity, shaped by the rest of the pattern.
std::string shaped(const std::string& rest) {
  return ahap(
      R"({"Event": {"Time": 0, "EventType": "HapticContinuous", "EventDuration": 4, "EventParameters": [
     {"ParameterID": "HapticIntensity", "ParameterValue": 1}, {"ParameterID": "HapticSharpness", "ParameterValue": 0.4}]}},)" +
      rest);
}
std::string curveAt(double time_s, const std::vector<std::pair<double, double>>& points) {
  std::string text;
  for (const auto& [at_s, value] : points)
    text += (text.empty() ? "" : ",") + std::string(R"({"Time": )") + std::to_string(at_s) +
            R"(, "ParameterValue": )" + std::to_string(value) + "}";
  return R"({"ParameterCurve": {"ParameterID": "HapticIntensityControl", "Time": )" + std::to_string(time_s) +
         R"(, "ParameterCurveControlPoints": [)" + text + "]}}";
}
std::string parameterAt(double time_s, double value) {
  return R"({"Parameter": {"ParameterID": "HapticIntensityControl", "Time": )" + std::to_string(time_s) +
         R"(, "ParameterValue": )" + std::to_string(value) + "}}";
}
double worstLevel(const std::string& text, double (*intensity)(double time_s)) {
  return worstSample(read(text), 0, 4,
                     [&](double t) { return std::pow(intensity(t), 2) * sine(t * (80 + 150 * 0.4)); });
}

}  // namespace

TEST_CASE("AHAP: parts that are not played are reported") {
  const ReferenceSignal signal =
      read(ahap(continuous + R"(, {"Event": {"Time": 0, "EventType": "AudioCustom"}})"));
  REQUIRE(signal.notes.size() == 1);
  CHECK(english(signal.notes[0]).find("AudioCustom") != std::string::npos);
}

TEST_CASE("Between two AHAP curves the first one's last value stays") {
  const auto falls = [](double t) { return t < 3 ? std::fmax(0.2, 1 - 0.8 * t) : 1; };
  const std::string first = curveAt(0, {{0, 1}, {1, 0.2}}), second = curveAt(3, {{0, 1}, {1, 1}});
  CHECK(worstLevel(shaped(first + "," + second), falls) < 1e-4);
  CHECK(worstLevel(shaped(second + "," + first), falls) < 1e-4);  // the order of a pattern means nothing
}

TEST_CASE("AHAP parameters and curves take over by their times, not by their order in the file") {
  const auto steps = [](double t) { return t < 1 ? 1 : t < 2 ? 0.2 : t < 3 ? 0.8 : 0.8 - 0.5 * (t - 3); };
  const std::vector<std::string> entries{parameterAt(1, 0.2), parameterAt(2, 0.8),
                                         curveAt(3, {{0, 0.8}, {1, 0.3}})};
  std::vector<std::size_t> order{0, 1, 2};
  do {
    CAPTURE(order);
    CHECK(worstLevel(shaped(entries[order[0]] + "," + entries[order[1]] + "," + entries[order[2]]), steps) <
          1e-4);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("All points of an AHAP curve are played, however many") {
  std::vector<std::pair<double, double>> zigzag;
  for (int i = 0; i <= 400; ++i) zigzag.emplace_back(0.01 * i, i % 20 < 10 ? 1 - 0.09 * (i % 20) : 0.1);
  const ReferenceSignal signal = read(shaped(curveAt(0, zigzag)));
  CHECK(signal.notes.empty());
  CHECK(worstSample(signal, 0, 4, [&](double t) {
          const auto i = static_cast<std::size_t>(t / 0.01);
          const double share = t / 0.01 - static_cast<double>(i);
          return std::pow(zigzag[i].second + share * (zigzag[i + 1].second - zigzag[i].second), 2) *
                 sine(t * 140);
        }) < 1e-3);
}

TEST_CASE(
    "AHAP control points count from their curve's time; a file that seems to mean another is reported") {
  const ReferenceSignal plain = read(shaped(curveAt(1, {{0, 0.5}, {0.9, 0.5}})));
  CHECK(plain.notes.empty());
  const ReferenceSignal doubtful = read(shaped(curveAt(1, {{1.5, 0.5}, {1.9, 0.5}})));
  REQUIRE(doubtful.notes.size() == 1);
  CHECK(worstSample(doubtful, 0, 4, [](double t) { return (t < 2.5 ? 1 : 0.25) * sine(t * 140); }) < 1e-4);
}

TEST_CASE("A .haptic envelope runs straight; an emphasis ducks it and stands on it") {
  const ReferenceSignal plain =
      read(haptic(R"({"amplitude": [{"time": 0, "amplitude": 0}, {"time": 1, "amplitude": 1}],
                      "frequency": [{"time": 0, "frequency": 0.25}]})"));
  CHECK(plain.format == ReferenceFormat::haptic);
  CHECK(worstSample(plain, 0, 1, [](double t) { return t * sine(t * (80 + 150 * 0.5)); }) < 1e-5);
  const ReferenceSignal emphasis = read(haptic(
      R"({"amplitude": [{"time": 0, "amplitude": 0.5, "emphasis": {"amplitude": 0.6, "frequency": 1}}, {"time": 1, "amplitude": 0.5}]})"));
  CHECK(worstSample(emphasis, 0, 0.022, [](double t) {
          return (0.32 + 0.18 * t) * sine(t * 80) + 0.6 * (1 - t / 0.022) * sine(t * 230);
        }) < 1e-5);
}

TEST_CASE("Points closer than any clock resolves are a step, not NaN") {
  for (const char* brief : {"0", "1e-320", "5e-324", "1e-200", "1e-12"}) {
    INFO(brief);
    const ReferenceSignal signal =
        read(haptic(R"({"amplitude": [{"time": 0, "amplitude": 0.5}, {"time": 0.3, "amplitude": 0.5}],
                   "frequency": [{"time": 0, "frequency": 0.2}, {"time": )" +
                    std::string(brief) + R"(, "frequency": 1}]})"));
    CHECK(worstSample(signal, 0, 0.3, [](double t) { return 0.5 * sine(t * 230); }) < 1e-5);
  }
}

TEST_CASE("HJIF bands are evaluated as the reference software does") {
  const std::string two =
      R"("keyframes": [{"relative_position": 0, "amplitude_modulation": 1, "frequency_modulation": 100},
                                           {"relative_position": 20, "amplitude_modulation": 0, "frequency_modulation": 300}])";
  const auto effect = [&](const std::string& shape) {
    return R"({"band_type": "VectorialWave", "lower_frequency_limit": 0, "upper_frequency_limit": 1000, "effects": [
              {"effect_type": "Basis", "position": 10, "phase": 0, "base_signal": ")" +
           shape + "\", " + two + "}]}";
  };
  const auto cycles = [](double t) { return (t - 0.01) * (100 + 200 * (t - 0.01) / 0.04); };
  const auto level = [](double t) { return 0.5 * (1 - (t - 0.01) / 0.02); };
  CHECK(worstSample(read(hjif(effect("Sine"))), 0.01, 0.03,
                    [&](double t) { return level(t) * sine(cycles(t)); }) < 1e-6);
  // The formulas of the reference software's base signals.
  CHECK(worstSample(read(hjif(effect("Triangle"))), 0.01, 0.03, [&](double t) {
          const double x = cycles(t) - 0.25;
          return level(t) * (1 - 4 * std::fabs(std::round(x) - x));
        }) < 1e-6);
  CHECK(worstSample(read(hjif(effect("SawToothUp"))), 0.0101, 0.03, [&](double t) {
          return level(t) * 2 * (cycles(t) - std::floor(cycles(t) + 0.5));
        }) < 1e-6);
  // At 48000 ticks the same numbers are shorter, not higher.
  const ReferenceSignal fast = read(hjif(effect("Sine"), R"("timescale": 48000)"));
  CHECK(fast.duration_s() < 0.002);
  const ReferenceSignal transient =
      read(hjif(R"({"band_type": "Transient", "effects": [{"effect_type": "Basis", "position": 10,
      "keyframes": [{"relative_position": 0, "amplitude_modulation": 1, "frequency_modulation": 10}]}]})"));
  CHECK(worstSample(transient, 0.01, 0.032, [](double t) { return 0.5 * sine(2 * (t - 0.01) / 0.022); }) <
        1e-6);
  const ReferenceSignal line =
      read(hjif(R"({"band_type": "Curve", "curve_type": "Linear", "effects": [{"effect_type": "Basis",
      "position": 0, "keyframes": [{"relative_position": 0, "amplitude_modulation": 0}, {"relative_position": 10, "amplitude_modulation": 1}]}]})"));
  CHECK(worstSample(line, 0, 0.01, [](double t) { return 50 * t; }) < 1e-6);
  const ReferenceSignal library = read(hjif(
      R"({"band_type": "VectorialWave", "effects": [{"effect_type": "Reference", "id": 7, "position": 20}]})"));
  CHECK(worstSample(library, 0.02, 0.03, [](double t) { return 0.25 * sine(200 * (t - 0.02)); }) < 1e-6);
}

TEST_CASE("Amplitudes beyond full scale are turned down, and reported") {
  const ReferenceSignal signal = read(ahap(continuous + "," + continuous + "," + continuous));
  CHECK(signal.peak == Approx(1).margin(1e-6));
  REQUIRE(signal.notes.size() == 1);
  CHECK(english(signal.notes[0]).find("1.9") != std::string::npos);
}

TEST_CASE("Files that leave out or add parts of their format are read, and this is reported") {
  const ReferenceSignal wanted = read(ahap(continuous));
  const ReferenceSignal bare =
      read(R"({"Pattern": [)" + continuous + "]}");  // Apple: a missing entry has its default
  CHECK(bare.samples == wanted.samples);
  CHECK(bare.notes.empty());
  const ReferenceSignal commas =
      read(R"({"Metadata": {"Project": "a,] \",}",}, "Version": 1.0, "Pattern": [)" + continuous + " ,\n]}");
  CHECK(commas.samples == wanted.samples);
  REQUIRE(commas.notes.size() == 1);
  CHECK(english(commas.notes[0]).find("commas") != std::string::npos);
  CHECK(refusal(R"({"Pattern": [1,,]})").find("line 1") != std::string::npos);

  const std::string band =
      R"({"band_type": "VectorialWave", "lower_frequency_limit": 0, "upper_frequency_limit": 1000,
    "effects": [{"effect_type": "Basis", "position": 0, "base_signal": "Sine", "keyframes": [
      {"relative_position": 0, "amplitude_modulation": 0.5, "frequency_modulation": 125},
      {"relative_position": 8, "amplitude_modulation": 0.5, "frequency_modulation": 125}]}]})";
  std::string draft = hjif(band);
  const ReferenceSignal standard = read(draft);
  draft.replace(draft.find("2023"), 4, "1");
  const ReferenceSignal drafted = read(draft);
  CHECK(drafted.samples == standard.samples);
  REQUIRE(drafted.notes.size() == 1);
  CHECK(english(drafted.notes[0]).find("draft") != std::string::npos);
}

TEST_CASE("Foreign files that cannot be are refused with the place") {
  CHECK(refusal("{").find("line 1") != std::string::npos);
  CHECK(refusal("{}").find("not a haptic file") != std::string::npos);
  CHECK(refusal(std::string(1000000, '[')).find("JSON") != std::string::npos);
  CHECK(refusal(ahap("")).find("nothing to play") != std::string::npos);
  CHECK(refusal(R"({"Version": 2.0, "Pattern": []})").find("Version") != std::string::npos);
  CHECK(refusal(ahap(R"({"Event": {"Time": 1e300, "EventType": "HapticTransient"}})"))
            .find("Pattern[0].Event.Time") != std::string::npos);
  CHECK(refusal(ahap(R"({"Event": {"Time": "x", "EventType": "HapticTransient"}})")).find("not a number") !=
        std::string::npos);
  CHECK(refusal(ahap(R"({"Event": {"Time": 0, "EventType": "HapticContinuous", "EventDuration": 31}})"))
            .find("31") != std::string::npos);
  CHECK(refusal(R"({"Version": 1e999, "Pattern": []})").find("number") != std::string::npos);
  CHECK(refusal(haptic(R"({"amplitude": []})")).find("amplitude") != std::string::npos);
  CHECK(refusal(haptic(R"({"amplitude": [{"time": 0, "amplitude": 1.5}]})")).find("amplitude[0].amplitude") !=
        std::string::npos);
  CHECK(refusal(haptic(R"({"amplitude": [{"time": 1, "amplitude": 1}, {"time": 0, "amplitude": 1}]})"))
            .find("amplitude[1].time") != std::string::npos);
  CHECK(refusal(R"({"version": {"major": 2}, "signals": {}})").find("version") != std::string::npos);
  CHECK(refusal(hjif(R"({"band_type": "Quantum", "effects": []})")).find("Quantum") != std::string::npos);
  CHECK(refusal(hjif("", R"("timescale": 0)")).find("timescale") != std::string::npos);
  CHECK(refusal(R"({"version": "2031", "perceptions": []})").find("2031") != std::string::npos);
  CHECK(
      refusal(
          hjif(
              R"({"band_type": "VectorialWave", "effects": [{"effect_type": "Reference", "id": 9, "position": 0}]})"))
          .find("effects[0].id") != std::string::npos);
  std::string many = continuous;
  for (int i = 0; i < 7000; ++i) many += "," + continuous;
  CHECK(refusal(ahap(many)).find("overlap and last") != std::string::npos);
}

TEST_CASE("Cut-off and changed reference files are refused or played within full scale") {
  std::mt19937 chance(28);
  const std::vector<std::string> whole{
      ahap(
          continuous +
          R"(, {"ParameterCurve": {"ParameterID": "HapticSharpnessControl", "Time": 0, "ParameterCurveControlPoints": [{"Time": 0, "ParameterValue": 0.5}, {"Time": 0.4, "ParameterValue": -1}]}})"),
      haptic(
          R"({"amplitude": [{"time": 0, "amplitude": 0.5, "emphasis": {"amplitude": 0.6, "frequency": 1}}, {"time": 1, "amplitude": 0.5}],
                 "frequency": [{"time": 0, "frequency": 0.2}, {"time": 0.7, "frequency": 1}]})"),
      hjif(
          R"({"band_type": "Curve", "effects": [{"position": 3, "keyframes": [{"relative_position": 0, "amplitude_modulation": 0}, {"relative_position": 10, "amplitude_modulation": 1}]}]})")};
  const std::vector<std::string> numbers{"-1", "1e308",      "-1e308", "1e-320", "0",    "null",
                                         "[]", "2147483648", "\"1\"",  "NaN",    "1e999"};
  std::size_t accepted = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = whole[static_cast<std::size_t>(i) % whole.size()];
    const auto within = [&](std::size_t size) {
      return std::uniform_int_distribution<std::size_t>(0, size - 1)(chance);
    };
    switch (chance() % 3) {
      case 0:
        text.resize(within(text.size()));
        break;
      case 1:
        text[within(text.size())] = static_cast<char>(chance() % 256);
        break;
      default: {
        const std::size_t at = text.find_first_of("0123456789", within(text.size()));
        if (at != std::string::npos) text.replace(at, 1, numbers[within(numbers.size())]);
      }
    }
    Result<ReferenceSignal> signal = referenceFromText(text, "changed");
    if (!signal) {
      CHECK(signal.failure().code == FailureCode::unreadableInput);
      continue;
    }
    ++accepted;
    CHECK_FALSE(signal->samples.empty());
    for (const float sample : signal->samples) {
      if (!(std::fabs(sample) <= 1)) FAIL(text);
    }
  }
  CHECK(accepted > 50);
}

TEST_CASE("A sound file is read at the reference's rate, several channels as their mean") {
  const auto path = std::filesystem::temp_directory_path() / "detent-reference-test.wav";
  std::vector<float> tone;
  for (int i = 0; i < 22050; ++i) tone.push_back(static_cast<float>(0.5 * sine(390 * i / 44100.0)));
  REQUIRE(writeSoundFile(tone, 44100, path).ok());
  Result<ReferenceSignal> signal = readReference(path);
  REQUIRE(signal.ok());
  CHECK(signal->format == ReferenceFormat::sound);
  CHECK(signal->duration_s() == Approx(0.5).margin(1e-4));
  CHECK(worstSample(*signal, 0.01, 0.49, [](double t) { return 0.5 * sine(390 * t); }) < 1e-4);
  // Cut off in its samples, and in its head.
  const auto size = std::filesystem::file_size(path);
  std::filesystem::resize_file(path, size / 2);
  REQUIRE_FALSE(readReference(path).ok());
  CHECK(readReference(path).failure().sentence().find("cut off") != std::string::npos);
  std::filesystem::resize_file(path, 20);
  CHECK_FALSE(readReference(path).ok());
  std::filesystem::remove(path);
  CHECK(readReference(path).failure().code == FailureCode::unreadableInput);
}

namespace {

std::string bigEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes; i-- > 0;) text += static_cast<char>(value >> (8 * i) & 0xFF);
  return text;
}
std::string littleEndian(std::uint64_t value, int bytes) {
  const std::string text = bigEndian(value, bytes);
  return {text.rbegin(), text.rend()};
}

/// A quarter of a second at 48000 Hz, 16 bits, big-endian; the second channel is `second` times the first
/// one.
std::string toneBytes(double second) {
  std::string bytes;
  for (int i = 0; i < 12000; ++i)
    for (const double factor : {1.0, second})
      bytes += bigEndian(
          static_cast<std::uint64_t>(std::lround(16384 * factor * sine(200 * i / 48000.0))) & 0xFFFF, 2);
  return bytes;
}
std::string swapped(std::string bytes) {
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
  return bytes;
}
std::string auFile(const std::string& data) {
  return ".snd" + bigEndian(24, 4) + bigEndian(data.size(), 4) + bigEndian(3, 4) + bigEndian(48000, 4) +
         bigEndian(2, 4) + data;
}
std::string rifxFile(const std::string& data) {
  return "RIFX" + bigEndian(36 + data.size(), 4) + "WAVEfmt " + bigEndian(16, 4) + bigEndian(1, 2) +
         bigEndian(2, 2) + bigEndian(48000, 4) + bigEndian(192000, 4) + bigEndian(4, 2) + bigEndian(16, 2) +
         "data" + bigEndian(data.size(), 4) + data;
}
std::string cafFile(const std::string& data) {
  return "caff" + bigEndian(1, 2) + bigEndian(0, 2) + "desc" + bigEndian(32, 8) +
         bigEndian(0x40E7700000000000, 8) + "lpcm" + bigEndian(0, 4) + bigEndian(4, 4) + bigEndian(1, 4) +
         bigEndian(2, 4) + bigEndian(16, 4) + "data" + bigEndian(4 + data.size(), 8) + bigEndian(0, 4) + data;
}
std::string w64File(const std::string& data) {
  const std::string tail("\xF3\xAC\xD3\x11\x8C\xD1\x00\xC0\x4F\x8E\xDB\x8A", 12);
  const std::string riff("\x2E\x91\xCF\x11\xA5\xD6\x28\xDB\x04\xC1\x00\x00", 12);
  const std::uint64_t size = 40 + 40 + 24 + data.size();
  return "riff" + riff + littleEndian(size, 8) + "wave" + tail + "fmt " + tail + littleEndian(40, 8) +
         littleEndian(1, 2) + littleEndian(2, 2) + littleEndian(48000, 4) + littleEndian(192000, 4) +
         littleEndian(4, 2) + littleEndian(16, 2) + "data" + tail + littleEndian(24 + data.size(), 8) +
         swapped(data);
}

}  // namespace

TEST_CASE("Sound files of other containers are read, and refused where they are cut off") {
  const auto path = std::filesystem::temp_directory_path() / "detent-reference-container";
  const std::string data = toneBytes(1);
  for (const std::string& bytes : {auFile(data), rifxFile(data), cafFile(data), w64File(data)}) {
    INFO(bytes.substr(0, 4));
    std::ofstream(path, std::ios::binary) << bytes;
    Result<ReferenceSignal> signal = readReference(path);
    INFO((signal ? std::string() : signal.failure().sentence()));
    REQUIRE(signal.ok());
    CHECK(signal->duration_s() == Approx(0.25));
    CHECK(worstSample(*signal, 0, 0.25, [](double t) { return 0.5 * sine(200 * t); }) < 1e-4);
    if (bytes.starts_with("caff")) continue;  // its data chunk is looked for by the library alone
    std::ofstream(path, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    CHECK_FALSE(readReference(path).ok());
  }
  std::filesystem::remove(path);
}

TEST_CASE("Channels that cancel each other are no silence: the strongest is played, and reported") {
  const auto path = std::filesystem::temp_directory_path() / "detent-reference-channels.au";
  struct Case {
    double second, level;
    const char* note;
  };
  const Case cases[] = {{-1, 0.5, "channel 1"}, {-0.9, 0.5, "channel 1"}, {1, 0.5, "mean"},
                        {0, 0.25, "mean"},      {-0.1, 0.225, "mean"},    {0.5, 0.375, "mean"}};
  for (const Case& c : cases) {
    CAPTURE(c.second);
    std::ofstream(path, std::ios::binary) << auFile(toneBytes(c.second));
    Result<ReferenceSignal> signal = readReference(path);
    REQUIRE(signal.ok());
    CHECK(worstSample(*signal, 0, 0.25, [&](double t) { return c.level * sine(200 * t); }) < 1e-4);
    REQUIRE(signal->notes.size() == 1);
    CHECK(english(signal->notes[0]).find(c.note) != std::string::npos);
  }
  std::filesystem::remove(path);
}

// Pairs of Meta's haptics SDK (core/haptic_data/test_files): a .haptic and what its makers' converter made of
// it. At the breakpoints alone: between them the converter's curves run straight in the root of the
// amplitude, the makers' own renderer in the amplitude.
TEST_CASE("Pairs of .haptic and .ahap made by others say the same") {
  const char* const folder = std::getenv("DETENT_HAPTIC_PAIRS");
  if (folder == nullptr) return;
  std::size_t pairs = 0;
  for (const char* name : {"2_points", "3_points", "16_points", "17_points", "long_clip"}) {
    const auto text = [&](const char* ending) {
      return nlohmann::json::parse(readTextFile(std::string(folder) + "/" + name + ending).value());
    };
    const std::string file = name;
    const nlohmann::json hapticJson = text(".haptic"), ahapJson = text(".ahap");
    const ReferenceWaves mine = hapticWaves({hapticJson, "", file}),
                         otherWaves = ahapWaves({ahapJson, "", file});
    double furthest = 0, furthest_Hz = 0;
    std::size_t points = 0;
    for (const WavePoint& point : mine.waves.front().points) {
      // At a step both sides have this time; the nearer one counts.
      double nearest = 1, nearest_Hz = 1000;
      for (const PlayedWave& other : otherWaves.waves) {
        for (const WavePoint& there : other.points) {
          if (std::fabs(there.time_s - point.time_s) > 1e-6) continue;
          nearest = std::fmin(nearest, std::fabs(there.amplitude - point.amplitude));
          nearest_Hz = std::fmin(nearest_Hz, std::fabs(there.frequency_Hz - point.frequency_Hz));
        }
      }
      furthest = std::fmax(furthest, nearest);
      furthest_Hz = std::fmax(furthest_Hz, nearest_Hz);
      ++points;
    }
    CAPTURE(name, points);
    CHECK(points > 1);
    CHECK(furthest <= 1e-6);
    CHECK(furthest_Hz <= 150e-6);
    ++pairs;
  }
  CHECK(pairs == 5);
}
