// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Presses and their sound as files. Apart from render_press.h because what renders a press in a browser has no files.

#include <filesystem>

#include "playback/offline/render_press.h"

namespace detent::playback {

/// A press trace as parsePressTrace reads it, from a file of at most 1 GiB. Failure names the file and the line.
Result<PressTrace> readPressTrace(const std::filesystem::path& file);

/// What a file of this trace will be, at most (FLAC is smaller).
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

}  // namespace detent::playback
