// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A press as everything it makes felt, in order: what all export formats are written from.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/result.h"
#include "playback/offline/render_press.h"
#include "playback/prepare/playback_settings.h"
#include "playback/realtime/haptic_engine.h"
#include "playback/realtime/haptic_program.h"

namespace detent::playback {

/// One burst of a press as the engine plays it.
struct PlannedBurst {
  EventKind kind = EventKind::grain;  ///< grain, pressJump, releaseJump or bottomOut
  std::int64_t frame = 0;             ///< sample at which it begins
  Burst burst;                        ///< amplitude > 0, before the filters
  double displacement_mm = 0;
  std::uint32_t grains = 0;  ///< grain positions merged into it; 0 for a jump or bottom-out
};

/// A press, burst by burst, and the samples that the engine makes of it.
struct PressPlan {
  std::string button;       ///< its name
  std::string press;        ///< what pressed: "human-like press of 120 ms", a file's name
  Feel feel = Feel::paper;  ///< how the program was prepared
  double sampleRate_Hz = 48000;
  std::int64_t turn_frame =
      0;  ///< of the strongest (deepest) reading: what begins later belongs to the release
  std::vector<PlannedBurst> bursts;  ///< by rising frame; at least one
  double slopeUnderJump = 1;         ///< level of the grains while a burst sounds that quietens the slope
  std::vector<float> samples;        ///< `detent-play render` of the same press
  std::vector<float> unlimited;  ///< the same without the limiter, where that had anything to do; else empty

  double time_s(std::int64_t frame) const { return static_cast<double>(frame) / sampleRate_Hz; }
  double duration_s() const { return time_s(static_cast<std::int64_t>(samples.size())); }
};

/// Longest press that is exported: AHAP holds no longer event, and nothing pressed by hand lasts longer.
inline constexpr double longestExport_s = 30;

/// Plays the press. Failure: as renderPress; wrongUsage for a press longer than `longestExport_s`, or one
/// under which nothing is felt. Any thread; allocates.
Result<PressPlan> planPress(const Button& button, const HapticProgram& program, const PressTrace& trace,
                            const std::string& pressName, const RenderSettings& settings);

}  // namespace detent::playback
