// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Presses and their sound as files, and sound files from other programs. Separate from render_press.h,
// because rendering in a browser has no files.

#include <filesystem>
#include <vector>

#include "playback/offline/render_press.h"

namespace detent::playback {

/// A press trace as parsePressTrace reads it, from a file of at most 1 GiB. Failure names the file and the
/// line.
Result<PressTrace> readPressTrace(const std::filesystem::path& file);

/// Largest size of the file of this trace (FLAC is smaller).
struct ExpectedSize {
  double duration_s = 0;
  double bytes = 0;
};
ExpectedSize expectedSize(const PressTrace& trace, const RenderSettings& settings,
                          const std::filesystem::path& file);

/// Renders into a mono WAV or FLAC file, by the file's extension; a WAV larger than 4 GiB becomes an RF64.
/// Written beside the target and renamed, so that the target is never incomplete. Failure: wrongUsage for
/// another extension, or float samples in a FLAC; unreadableInput if the file cannot be written.
Result<RenderSummary> renderPressToFile(const HapticProgram& program, const PressTrace& trace,
                                        const RenderSettings& settings, const std::filesystem::path& file);

/// Float samples as a mono WAV, or as FLAC of 24 bits, by the file's ending. Written and failing as above.
Result<Done> writeSoundFile(const std::vector<float>& samples, double sampleRate_Hz,
                            const std::filesystem::path& file);

/// One channel of sound.
struct SoundSamples {
  double sampleRate_Hz = 0;
  int channels = 1;  ///< number of channels of the file; `samples` is their mean
  /// from 1: the strongest channel, used alone because channels of opposite sign cancel each other;
  /// otherwise 0
  int onlyChannel = 0;
  std::vector<float> samples;  ///< full scale is 1; at least one, all finite
};

/// Reads WAV, AIFF, AU, CAF, W64, FLAC, Ogg and other formats of libsndfile, at 8000 to 192000 Hz, of at most
/// `longest_s`. Failure unreadableInput: missing, no sound, truncated, too long, or with a sample that is not
/// a number.
Result<SoundSamples> readSoundFile(const std::filesystem::path& file, double longest_s);

}  // namespace detent::playback
