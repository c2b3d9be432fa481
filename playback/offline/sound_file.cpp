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

int formatOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".wav") return SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  if (ending == ".flac") return SF_FORMAT_FLAC | SF_FORMAT_PCM_24;
  return 0;
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

Result<RenderSummary> renderPressToFile(const HapticProgram& program, const PressTrace& trace,
                                        const RenderSettings& settings, const std::filesystem::path& file) {
  SF_INFO info{};
  info.channels = 1;
  info.samplerate = static_cast<int>(settings.sampleRate_Hz);
  info.format = formatOf(file);
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
