// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Predicts whether a device can render a button: the margin along the travel, and the nearest button that it
// can render exactly. Formulas and results of simulation: docs/develop/decisions/1101-stability-margin.md.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/button.h"
#include "model/result.h"
#include "playback/prepare/force_device_profile.h"

namespace detent::playback {

/// The reason why a slope is too steep; if there are several, the strictest one.
enum class StabilityBound : std::uint8_t {
  damping,  ///< oscillations of the free handle would grow: the loop limit (loop_limit.h)
  /// K <= 1.4 f / q: one encoder step moves the force by more than friction holds (Abbott and Okamura 2005)
  quantisation,
  device  ///< the steepest slope the device may render
};

struct MarginPoint {
  double displacement_mm = 0;
  double slope_N_per_mm = 0;  ///< slope at the steepest point of both strokes near this displacement
  double allowed_N_per_mm = 0;
  StabilityBound bound = StabilityBound::damping;
  double margin_N_per_mm() const { return allowed_N_per_mm - slope_N_per_mm; }
};

/// A stretch whose slope is not allowed.
struct UnstableStretch {
  std::size_t state = 0;
  double from_mm = 0, to_mm = 0;
  MarginPoint worst;
  bool falling = false;  ///< a falling slope (of a jump); otherwise a rising one
};

struct StabilityMargin {
  std::vector<std::vector<MarginPoint>> states;  ///< per state, at evenly spaced displacements
  std::vector<UnstableStretch> unstable;
  MarginPoint least;
  /// Colgate and Schenkel's bound for any finger, b / (T / 2 + delay) minus the button's own damping. It is
  /// stricter than a hand requires, and negative if the button damps more than the device.
  double anyFinger_N_per_mm = 0;
  bool stable() const { return unstable.empty(); }
};

/// `rate_Hz` > 0. Any thread; allocates.
StabilityMargin stabilityOf(const Button& button, const ForceDeviceProfile& device, double rate_Hz);

/// Changes that were necessary.
struct StabilityChange {
  std::size_t state = 0;
  double largestForceChange_N = 0, changedFrom_mm = 0,
         changedTo_mm = 0;            ///< range; 0 if only damping changed
  double addedDamping_Ns_per_mm = 0;  ///< largest
};
struct StableButton {
  Button button;
  std::vector<StabilityChange> changes;  ///< empty: the button was stable as it is
};

/// The nearest button whose margin is nowhere negative: first damping is added, up to what the device's mass
/// allows, then slopes are limited; a peak keeps its force. Failure wrongUsage: no button is stable on the
/// device (no friction, no damping).
Result<StableButton> nearestStable(const Button& button, const ForceDeviceProfile& device, double rate_Hz);

}  // namespace detent::playback
