// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Presses of 64 simulated fingers on a button's own curve, as a magnetic key takes them: which are lost,
// which count twice, and whether a key that is held lets go. A forecast (docs/reference/press-forecast.md),
// with what the sensor adds.

#include <functional>
#include <optional>
#include <vector>

#include "model/button.h"
#include "playback/magnetic/magnetic_key.h"
#include "playback/magnetic/magnetic_sensor.h"
#include "playback/performance/forecast.h"

namespace detent::playback {

/// Amplitudes of each finger that are pressed: its normal noise cut into equal shares.
inline constexpr int pressesOfFinger = 16;

/// Result of fingerCount * pressesOfFinger presses, and of holding for a minute.
struct MagneticKeyForecast {
  MagneticKeySettings settings;
  double lost_per_1000 = 0;             ///< no key event, though the finger meant one
  double doubled_per_1000 = 0;          ///< more than one
  double letsGo_per_minute = 0;         ///< held at the end of the travel
  double letsGoShallow_per_minute = 0;  ///< held a tenth of a millimetre below the actuation point
};

/// Depths of the planned presses, once for any settings.
class PressedDepths {
 public:
  /// Empty where `cancelled` said so. Failure wrongUsage: the forecast of presses has none, with its reason.
  /// `actuate_mm` is what the fingers believe to be the operating point.
  static std::optional<Result<PressedDepths>> of(const Button& button, double actuate_mm,
                                                 const std::function<bool()>& cancelled = {});
  const std::vector<std::vector<double>>& presses_mm() const {
    return presses_mm_;
  }  ///< a place every plantStep_s

 private:
  std::vector<std::vector<double>> presses_mm_;
};

/// Deterministic: the sensor's noise comes from a fixed seed. Any thread.
MagneticKeyForecast forecastKey(const PressedDepths& presses, const Button& button,
                                const MagneticSensor& sensor, const MagneticKeySettings& settings);

}  // namespace detent::playback
