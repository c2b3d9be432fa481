// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Buttons and presses drawn at random, exported, and held against every numeric limit of the format they went
// to.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "model/button.h"
#include "playback/interchange/export_press.h"
#include "playback/offline/render_press.h"
#include "playback/prepare/playback_settings.h"

namespace detent::test {

/// One draw; the same for the same seed.
struct FuzzedExport {
  Button button;
  playback::PlaybackSettings feel;
  std::shared_ptr<const playback::HapticProgram> program;  ///< null where the button cannot be prepared
  std::string refusal;                                     ///< why not
  playback::PressTrace trace;
  playback::ExportSettings settings;
};
FuzzedExport fuzzedExport(std::uint64_t seed);

/// Result of an export.
struct ExportVerdict {
  std::string refusal;                  ///< the sentence; empty where files were written
  std::vector<std::string> violations;  ///< limits of the format that the file exceeds
};
ExportVerdict judged(const FuzzedExport& drawn);
/// The same in two thirds of the time: without the energies of the loss record, on which no limit of a format
/// hangs.
ExportVerdict judgedByLimits(const FuzzedExport& drawn);

/// Limits that files of a format pass: as judged() asks.
std::vector<std::string> violationsOf(playback::ExportFormat format,
                                      const std::vector<playback::ExportedFile>& files);

}  // namespace detent::test
