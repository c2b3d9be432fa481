// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The press that represents a person's if none was recorded: for displays, exports, studies and predictions.

#include "model/result.h"
#include "playback/offline/render_press.h"
#include "playback/realtime/finger_profile.h"
#include "playback/realtime/haptic_program.h"

namespace detent::playback {

/// A human-like press: minimum-jerk rise to the peak, hold with physiological tremor, minimum-jerk fall.
struct StandardPress {
  double peak_N = 0;      ///< 0: a quarter more than the button's bottom-out needs
  double press_s = 0.12;  ///< > 0
  double hold_s = 0.08;   ///< >= 0
  double release_s = 0.10;
  double sensor_Hz = 425;  ///< K&L, Apparatus
};

/// Force of a full press: a quarter more than the button's bottom-out needs, and well above the sensor's
/// noise.
double standardPeak_N(const HapticProgram& program);

/// The readings of such a press.
PressTrace standardPress(const HapticProgram& program, const StandardPress& press = {});

/// A standard press as samples for a waveform view; about a millisecond of work.
Result<RenderedPress> renderStandardPress(const HapticProgram& program, double sampleRate_Hz = 48000,
                                          const StandardPress& press = {});

}  // namespace detent::playback
