// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include <sndfile.h>

#include "model/staged_file.h"
#include "model/text.h"
#include "playback/offline/press_files.h"

namespace detent::playback {

namespace {

struct CloseSound {
  void operator()(SNDFILE* file) const { sf_close(file); }
};
using SoundFile = std::unique_ptr<SNDFILE, CloseSound>;

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

/// libsndfile's number for it; 0: no such file.
int formatOf(Container container, SampleFormat format, double bytes) {
  const int samples = format == SampleFormat::bits16   ? SF_FORMAT_PCM_16
                      : format == SampleFormat::bits24 ? SF_FORMAT_PCM_24
                                                       : SF_FORMAT_FLOAT;
  if (container == Container::wav) {
    return (bytes > largestWav_bytes ? SF_FORMAT_RF64 : SF_FORMAT_WAV) | samples;
  }
  return container == Container::flac && format != SampleFormat::float32 ? SF_FORMAT_FLAC | samples : 0;
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
  SF_INFO info{};
  info.channels = 1;
  info.samplerate = static_cast<int>(settings.sampleRate_Hz);
  const Container container = containerOf(file);
  const SampleFormat samplesAs = samplesIn(container, settings.format);
  info.format = formatOf(container, samplesAs, expectedSize(trace, settings, file).bytes);
  if (container == Container::flac && info.format == 0) {
    return Failure{FailureCode::wrongUsage, file.string(), "", "FLAC holds no float samples",
                   "Give --bits 16 or 24, or a .wav"};
  }
  if (info.format == 0) {
    return Failure{FailureCode::wrongUsage, file.string(), "", "is neither .wav nor .flac",
                   "Give one of these endings"};
  }
  auto draft = StagedFile::beside(file);
  if (!draft) return draft.failure();
  std::string trouble;
  Result<RenderSummary> summary = Failure{};
  {
    SoundFile out(sf_open(draft->path().c_str(), SFM_WRITE, &info));
    if (!out) return draft->notWritten(sf_strerror(nullptr));
    // No peak chunk: it holds the time of writing, and the same press must give the same file.
    sf_command(out.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
    sf_command(out.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
    summary = renderPress(program, trace, settings, [&](const float* samples, std::size_t count) {
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

}  // namespace detent::playback
