// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Presses of 64 simulated fingers on a button's own curve, as a magnetic key registers them: how many are
// lost, how many count twice, and how often a held key opens. A forecast (docs/reference/press-forecast.md),
// with the sensor's errors added.

#include <functional>
#include <optional>
#include <vector>

#include "model/button.h"
#include "playback/magnetic/magnetic_key.h"
#include "playback/magnetic/magnetic_sensor.h"
#include "playback/performance/forecast.h"

namespace detent::playback {

/// Number of amplitudes of each finger that are pressed: quantiles of its normal noise.
inline constexpr int pressesOfFinger = 16;

/// Result of fingerCount * pressesOfFinger presses, and of holding for a minute.
struct MagneticKeyForecast {
  MagneticKeySettings settings;
  double lost_per_1000 = 0;             ///< no key event although the finger intended one
  double doubled_per_1000 = 0;          ///< more than one
  double letsGo_per_minute = 0;         ///< while held at the end of the travel
  double letsGoShallow_per_minute = 0;  ///< while held a tenth of a millimetre below the actuation point
};

/// Depths of the planned presses, computed once and usable with any settings.
class PressedDepths {
 public:
  /// Empty after `cancelled` returned true. Failure wrongUsage: no forecast of presses is possible, with the
  /// reason. `actuate_mm` is the operating point that the fingers expect.
  static std::optional<Result<PressedDepths>> of(const Button& button, double actuate_mm,
                                                 const std::function<bool()>& cancelled = {});
  const std::vector<std::vector<double>>& presses_mm() const {
    return presses_mm_;
  }  ///< one depth every plantStep_s

 private:
  std::vector<std::vector<double>> presses_mm_;
};

/// Deterministic: the sensor's noise comes from a fixed seed. Any thread.
MagneticKeyForecast forecastKey(const PressedDepths& presses, const Button& button,
                                const MagneticSensor& sensor, const MagneticKeySettings& settings);

}  // namespace detent::playback
