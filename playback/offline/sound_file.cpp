// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <memory>
#include <random>
#include <system_error>

#include <sndfile.h>

#include "playback/offline/render_press.h"

namespace detent::playback {

namespace {

struct CloseSound {
  void operator()(SNDFILE* file) const { sf_close(file); }
};
using SoundFile = std::unique_ptr<SNDFILE, CloseSound>;

constexpr double largestWav_bytes = 4.0 * 1024 * 1024 * 1024 - 4096;  // its length fields have 32 bits

enum class Container { wav, flac, unknown };

Container containerOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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

/// A file beside the target that disappears unless it is kept.
class Draft {
 public:
  explicit Draft(const std::filesystem::path& target) : target_(target) {
    std::random_device random;
    char suffix[40];
    std::snprintf(suffix, sizeof suffix, ".%08x%08x.part", random(), random());
    path_ = target;
    path_ += suffix;
  }
  ~Draft() {
    std::error_code ignored;
    if (!kept_) std::filesystem::remove(path_, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::error_code keep() {
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    kept_ = !error;
    return error;
  }

 private:
  std::filesystem::path target_, path_;
  bool kept_ = false;
};

Failure cannotWrite(const std::filesystem::path& file, const std::string& why) {
  return {FailureCode::unreadableInput, file.string(), "", "cannot be written (" + why + ")",
          "Check the folder, its rights and the free space"};
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
  Draft draft(file);
  std::string trouble;
  Result<RenderSummary> summary = Failure{};
  {
    SoundFile out(sf_open(draft.path().c_str(), SFM_WRITE, &info));
    if (!out) return cannotWrite(file, sf_strerror(nullptr));
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
  if (!trouble.empty()) return cannotWrite(file, trouble);
  if (const std::error_code error = draft.keep()) return cannotWrite(file, error.message());
  return summary;
}

}  // namespace detent::playback
