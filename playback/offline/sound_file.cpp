// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <sndfile.h>

#include "model/staged_file.h"
#include "model/text.h"
#include "playback/offline/press_files.h"
#include "playback/realtime/felt_meter.h"

namespace detent::playback {

namespace {

struct CloseSound {
  void operator()(SNDFILE* file) const { sf_close(file); }
};
using SoundFile = std::unique_ptr<SNDFILE, CloseSound>;

constexpr int mostChannels = 16;
constexpr double largestWav_bytes = 4.0 * 1024 * 1024 * 1024 - 4096;  // its length fields have 32 bits

enum class Container { wav, flac, unknown };

Container containerOf(const std::filesystem::path& file) {
  const std::string ending = lowered(file.extension().string());
  if (ending == ".wav") return Container::wav;
  return ending == ".flac" ? Container::flac : Container::unknown;
}

SampleFormat samplesIn(Container container, SampleFormat format) {
  if (format != SampleFormat::standard) return format;
  return container == Container::flac ? SampleFormat::bits24 : SampleFormat::float32;
}

int bytesOf(SampleFormat format) {
  if (format == SampleFormat::bits16) return 2;
  return format == SampleFormat::bits24 ? 3 : 4;
}

/// libsndfile's number for the format; 0: there is none.
int formatOf(Container container, SampleFormat format, double bytes) {
  const int samples = format == SampleFormat::bits16   ? SF_FORMAT_PCM_16
                      : format == SampleFormat::bits24 ? SF_FORMAT_PCM_24
                                                       : SF_FORMAT_FLOAT;
  if (container == Container::wav) {
    return (bytes > largestWav_bytes ? SF_FORMAT_RF64 : SF_FORMAT_WAV) | samples;
  }
  return container == Container::flac && format != SampleFormat::float32 ? SF_FORMAT_FLAC | samples : 0;
}

/// Writes one channel, completely or not at all. `produce` receives a function for passing its samples, and
/// continues while that returns true.
template <class Summary>
Result<Summary> written(const std::filesystem::path& file, double sampleRate_Hz, SampleFormat format,
                        double bytes, const std::function<Result<Summary>(const SampleSink&)>& produce) {
  SF_INFO info{};
  info.channels = 1;
  info.samplerate = static_cast<int>(sampleRate_Hz);
  const Container container = containerOf(file);
  info.format = formatOf(container, samplesIn(container, format), bytes);
  if (container == Container::flac && info.format == 0) {
    return Failure{FailureCode::wrongUsage, file.string(), "",
                   Message("FLAC cannot store floating-point samples"),
                   Message("Give --bits 16 or 24, or a .wav file")};
  }
  if (info.format == 0) {
    return Failure{FailureCode::wrongUsage, file.string(), "",
                   Message("the file name ends in neither .wav nor .flac"),
                   Message("Give a file that ends in .wav or .flac")};
  }
  auto draft = StagedFile::beside(file);
  if (!draft) return draft.failure();
  std::string trouble;
  Result<Summary> summary = Failure{};
  {
    SoundFile out(sf_open(draft->path().c_str(), SFM_WRITE, &info));
    if (!out) return draft->notWritten(sf_strerror(nullptr));
    // Without a peak chunk, which contains the time of writing: the same press must give the same file.
    sf_command(out.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
    sf_command(out.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
    summary = produce([&](const float* samples, std::size_t count) {
      if (sf_writef_float(out.get(), samples, static_cast<sf_count_t>(count)) ==
          static_cast<sf_count_t>(count)) {
        return true;
      }
      trouble = sf_strerror(out.get());
      return false;
    });
    if (!summary) return summary;
    sf_write_sync(out.get());
    if (sf_error(out.get()) != SF_ERR_NO_ERROR) trouble = sf_strerror(out.get());
    const int closed = sf_close(out.release());
    if (closed != 0) trouble = sf_error_number(closed);
  }
  if (!trouble.empty()) return draft->notWritten(trouble);
  if (const auto kept = draft->commit(); !kept) return kept.failure();
  return summary;
}

}  // namespace

ExpectedSize expectedSize(const PressTrace& trace, const RenderSettings& settings,
                          const std::filesystem::path& file) {
  ExpectedSize size;
  if (trace.readings.empty()) return size;
  double last_s = 0;
  for (const PressReading& r : trace.readings) {
    if (r.time_s > last_s) last_s = r.time_s;
  }
  size.duration_s = last_s - std::min(0.0, trace.readings.front().time_s) + settings.tail_s;
  size.bytes =
      size.duration_s * settings.sampleRate_Hz * bytesOf(samplesIn(containerOf(file), settings.format));
  return size;
}

Result<RenderSummary> renderPressToFile(const HapticProgram& program, const PressTrace& trace,
                                        const RenderSettings& settings, const std::filesystem::path& file) {
  if (Result<Done> ok = checkRendering(trace, settings); !ok) return ok.failure();
  const double bytes = expectedSize(trace, settings, file).bytes;
  FeltMeter felt;
  felt.use(program, settings.sampleRate_Hz);
  Result<RenderSummary> summary = written<RenderSummary>(
      file, settings.sampleRate_Hz, settings.format, bytes, [&](const SampleSink& put) {
        return renderPress(program, trace, settings, [&](const float* samples, std::size_t count) {
          felt.add(samples, count);
          return put(samples, count);
        });
      });
  if (summary) summary->felt_dB = felt.take_dB();
  return summary;
}

Result<Done> writeSoundFile(const std::vector<float>& samples, double sampleRate_Hz,
                            const std::filesystem::path& file) {
  const double bytes = static_cast<double>(samples.size() * sizeof(float));
  return written<Done>(file, sampleRate_Hz, SampleFormat::standard, bytes, [&](const SampleSink& put) {
    put(samples.data(), samples.size());
    return Result<Done>(Done{});
  });
}

namespace {

/// The library's reason for not opening a file, without its own name and full stop.
Message whyNotRead() {
  std::string why = sf_strerror(nullptr);
  if (why.find("nternal error") != std::string::npos)
    return Message("this is not a readable sound file: its header is damaged");
  while (why.ends_with('.')) why.pop_back();
  return Message("this is not a readable sound file: %1", why);
}

// share of the energy that the mean would have if only the strongest channel had sound
constexpr double cancelledShare = 0.5;

/// 0, or the number of the strongest channel if the mean of the channels has clearly less energy than that
/// channel alone would give it.
int onlyChannelOf(const std::vector<float>& interleaved, std::size_t channels) {
  std::vector<double> energies(channels, 0);
  double ofMean = 0;
  for (std::size_t i = 0; i < interleaved.size(); i += channels) {
    double sum = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      const auto sample = static_cast<double>(interleaved[i + c]);
      sum += sample;
      energies[c] += sample * sample;
    }
    ofMean += sum * sum;  // without division by the number of channels, like the value it is compared with
  }
  const auto strongest = std::ranges::max_element(energies);
  return ofMean < cancelledShare * *strongest ? static_cast<int>(strongest - energies.begin()) + 1 : 0;
}

}  // namespace

Result<SoundSamples> readSoundFile(const std::filesystem::path& file, double longest_s) {
  const auto refuse = [&](Message problem, const Message& remedy) {
    return Failure{FailureCode::unreadableInput, Subject(file.string()), {}, std::move(problem), remedy};
  };
  SF_INFO info{};
  SoundFile in(sf_open(file.c_str(), SFM_READ, &info));
  if (!in) return refuse(whyNotRead(), Message("Give a WAV file"));
  if (info.samplerate < 8000 || info.samplerate > 192000)
    return refuse(Message("the sound file has %1 samples a second", info.samplerate),
                  Message("Give a rate from 8000 to 192000"));
  if (info.channels < 1 || info.channels > mostChannels)
    return refuse(Message("the sound file has %1 channels", info.channels),
                  Message("Give at most %1", mostChannels));
  const auto frames = static_cast<double>(info.frames);
  if (!(frames >= 1)) return refuse(Message("the sound file holds no sample"), Message("Give a longer file"));
  if (frames > longest_s * info.samplerate)
    return refuse(Message("the file lasts %1 s", frames / info.samplerate),
                  Message("Give a file of at most %1 s", longest_s));
  std::vector<float> interleaved(static_cast<std::size_t>(info.frames) *
                                 static_cast<std::size_t>(info.channels));
  if (sf_readf_float(in.get(), interleaved.data(), info.frames) != info.frames)
    return refuse(Message("the file is cut off"), Message("Export the file again"));
  const auto channels = static_cast<std::size_t>(info.channels);
  for (std::size_t i = 0; i < interleaved.size(); ++i)
    if (!(std::fabs(interleaved[i]) < 1e9F))
      return refuse(Message("sample %1 of the sound file is not a number", i / channels + 1),
                    Message("Export the file again"));
  SoundSamples sound{
      static_cast<double>(info.samplerate), info.channels, onlyChannelOf(interleaved, channels), {}};
  for (std::size_t i = 0; i < interleaved.size(); i += channels) {
    double sum = 0;
    for (std::size_t c = 0; c < channels; ++c) sum += static_cast<double>(interleaved[i + c]);
    const float mean = static_cast<float>(sum / static_cast<double>(channels));
    sound.samples.push_back(
        sound.onlyChannel > 0 ? interleaved[i + static_cast<std::size_t>(sound.onlyChannel) - 1] : mean);
  }
  return sound;
}

}  // namespace detent::playback
