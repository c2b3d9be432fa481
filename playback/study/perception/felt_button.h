// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button under many fingers: the excitation of presses from quick to slow, after masking. Made once per
// button, compared with many.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/result.h"
#include "playback/prepare/device_profile.h"
#include "playback/prepare/playback_settings.h"
#include "playback/study/perception/excitation.h"

namespace detent::playback {

/// Durations of the presses that are averaged; people press in 60 to 300 ms.
inline constexpr std::array<double, 4> pressLengths_s{0.06, 0.10, 0.17, 0.30};

/// Force of a hand, the same for all buttons: the least force of a press for each of the durations above (a
/// quick press is a hard one). A button that needs more is pressed with a quarter more than its strongest
/// force. docs/reference/predicted-confusion.md has the range over hands.
struct Hand {
  std::array<double, pressLengths_s.size()> least_N{3, 2, 1.5, 1};
};

/// One stroke of one press.
struct FeltStroke {
  std::vector<float> samples;  ///< movement of the surface, at perceptionRate_Hz
  Excitation excitation;       ///< after masking
  std::size_t grains = 0;      ///< steps of travel that were felt
  double meanForce_N = 0;      ///< mean of the button's curve over the travel
  double length_s = 0;         ///< duration of the finger's movement, which begins at sample 0
};

/// A press of one of the durations above, with its movements down and up.
struct FeltPress {
  FeltStroke press, release;
};

/// Plain value, any thread.
struct FeltButton {
  std::string name;
  /// By state and duration; one state for a momentary button, two for a self-locking one.
  std::vector<std::array<FeltPress, pressLengths_s.size()>> states;
};

/// The mock-up that K&L's participants pressed: resonances at 260, 390 and 780 Hz (Apparatus). The paper
/// shows their strength and sharpness only in a picture; 12 dB and Q = 8 are our assumption.
DeviceProfile kimLeeApparatus();

/// Model of perception. docs/reference/predicted-confusion.md states the source of every number; none is
/// tuned.
struct PerceptionSettings {
  DeviceProfile device = kimLeeApparatus();
  PlaybackSettings playback = usualSettings();
  ThresholdSettings thresholds;
  MaskingSettings masking;
  Hand hand;
};

/// Renders the presses and computes their excitation; some ten milliseconds. Failure: wrongUsage "was
/// cancelled", or the failure of prepareProgram or renderPress.
Result<FeltButton> feel(const Button& button, const PerceptionSettings& settings = {},
                        const std::function<bool()>& cancelled = {});

}  // namespace detent::playback
