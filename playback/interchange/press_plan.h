// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A press as the sequence of everything that is felt, from which all export formats are written.

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
  std::int64_t frame = 0;             ///< sample at which the burst begins
  Burst burst;                        ///< amplitude > 0, before the filters
  double displacement_mm = 0;
  std::uint32_t grains = 0;  ///< grain positions merged into it; 0 for a jump or bottom-out
};

/// A press, burst by burst, and the samples that the engine makes of it.
struct PressPlan {
  std::string button;       ///< its name
  std::string press;        ///< description of the press: "human-like press of 120 ms", a file's name
  Feel feel = Feel::paper;  ///< how the program was prepared
  double sampleRate_Hz = 48000;
  std::int64_t turn_frame =
      0;  ///< frame of the strongest (deepest) reading: sounds that begin later belong to the release
  std::vector<PlannedBurst> bursts;  ///< by rising frame; at least one
  double slopeUnderJump = 1;         ///< level of the grains during a burst that lowers the slope
  std::vector<float> samples;        ///< `detent-play render` of the same press
  /// the same without the limiter, if the limiter changed anything; otherwise empty
  std::vector<float> unlimited;

  double time_s(std::int64_t frame) const { return static_cast<double>(frame) / sampleRate_Hz; }
  double duration_s() const { return time_s(static_cast<std::int64_t>(samples.size())); }
};

/// Longest press that is exported: AHAP allows no longer event, and no press by hand lasts longer.
inline constexpr double longestExport_s = 30;

/// Plays the press. Failure: as renderPress; wrongUsage for a press longer than `longestExport_s`, or one in
/// which nothing is felt. Any thread; allocates.
Result<PressPlan> planPress(const Button& button, const HapticProgram& program, const PressTrace& trace,
                            const std::string& pressName, const RenderSettings& settings);

}  // namespace detent::playback
