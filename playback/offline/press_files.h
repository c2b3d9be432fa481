// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Presses and their sound as files, and sound files of others. Apart from render_press.h because what renders
// a press in a browser has no files.

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

/// The same into a mono WAV, or FLAC, by the file's ending; a WAV that would pass 4 GiB becomes an RF64.
/// Written beside the target and renamed, so that the target is never half written. Failure: wrongUsage for
/// another ending, or float samples in a FLAC; unreadableInput where the file cannot be written.
Result<RenderSummary> renderPressToFile(const HapticProgram& program, const PressTrace& trace,
                                        const RenderSettings& settings, const std::filesystem::path& file);

/// Float samples as a mono WAV, or as FLAC of 24 bits, by the file's ending. Written and failing as above.
Result<Done> writeSoundFile(const std::vector<float>& samples, double sampleRate_Hz,
                            const std::filesystem::path& file);

/// One channel of sound.
struct SoundSamples {
  double sampleRate_Hz = 0;
  int channels = 1;  ///< of the file; `samples` is their mean
  int onlyChannel =
      0;  ///< from 1: the strongest, kept alone where channels of opposite sign cancel each other; else 0
  std::vector<float> samples;  ///< full scale is 1; at least one, all finite
};

/// WAV, AIFF, AU, CAF, W64, FLAC, Ogg and what else libsndfile reads, at 8000 to 192000 Hz, of at most
/// `longest_s`. Failure unreadableInput: not there, no sound, cut off, longer, or with a sample that is no
/// number.
Result<SoundSamples> readSoundFile(const std::filesystem::path& file, double longest_s);

}  // namespace detent::playback
