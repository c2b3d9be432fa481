// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button under many fingers: the excitation of presses from quick to slow, and the rest of it after
// masking. Made once per button, compared with many.

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

/// Lengths of the presses that are averaged; people press in 60 to 300 ms.
inline constexpr std::array<double, 4> pressLengths_s{0.06, 0.10, 0.17, 0.30};

/// One hand for all buttons: how hard it presses at least, by the lengths above; a quick press is a hard one.
/// A button that asks for more gets a quarter more than its strongest force.
/// docs/reference/predicted-confusion.md has the range over hands.
struct Hand {
  std::array<double, pressLengths_s.size()> least_N{3, 2, 1.5, 1};
};

/// One stroke of one press.
struct FeltStroke {
  std::vector<float> samples;  ///< at perceptionRate_Hz, as the surface moves
  Excitation excitation;       ///< after masking
  std::size_t grains = 0;      ///< steps of travel that were felt
  double meanForce_N = 0;      ///< over the travel, of the button's curve
  double length_s = 0;         ///< of the finger's movement; it begins at sample 0
};

/// One press of the lengths above, with its movements down and up.
struct FeltPress {
  FeltStroke press, release;
};

/// Plain value, any thread.
struct FeltButton {
  std::string name;
  /// [state][length]; one state for a momentary button, two for a self-locking one.
  std::vector<std::array<FeltPress, pressLengths_s.size()>> states;
};

/// The mock-up of K&L's participants: resonances at 260, 390 and 780 Hz (Apparatus). How strong and how sharp
/// is a picture in the paper; 12 dB and Q = 8 are our assumption.
DeviceProfile kimLeeApparatus();

/// Model of perception. Every number has its source in docs/reference/predicted-confusion.md; none is tuned.
struct PerceptionSettings {
  DeviceProfile device = kimLeeApparatus();
  PlaybackSettings playback = usualSettings();
  ThresholdSettings thresholds;
  MaskingSettings masking;
  Hand hand;
};

/// Renders and feels the presses; some ten milliseconds. Failure: wrongUsage "was cancelled", or what
/// prepareProgram and renderPress say.
Result<FeltButton> feel(const Button& button, const PerceptionSettings& settings = {},
                        const std::function<bool()>& cancelled = {});

}  // namespace detent::playback
