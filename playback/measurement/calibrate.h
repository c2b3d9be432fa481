// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sensor calibration with known weights: weighted least squares with error bars.

#include <string>
#include <vector>

#include "model/result.h"
#include "playback/realtime/sensor_calibration.h"

namespace detent::playback {

/// One reading under a known force.
struct KnownWeight {
  double force_N = 0;
  double raw = 0;  ///< as sent by the sensor (mean over about a second)
};

struct CalibrationSettings {
  SensorCircuit circuit = SensorCircuit::divider;
  double fullScale_counts = 1023;
  unsigned highestDegree = 3;  ///< 1..3; lower if the weights do not support more
  /// relative error of one reading (FSR 400: +-2 % single part); weights the fit; >= 0
  double relativeError = 0.02;
  double absoluteError_N = 0.01;  ///< > 0
};

/// Chooses the polynomial degree with the lowest AICc among the curves that increase over the range of the
/// weights. Failure unreadableInput: fewer than 3 different weights, readings that are not numbers, or a
/// sensor whose reading does not increase with force.
Result<SensorCalibration> calibrate(const std::vector<KnownWeight>& weights,
                                    const CalibrationSettings& settings);

/// `force_N,raw` or `mass_g,raw` with header. Failure names the line.
Result<std::vector<KnownWeight>> parseWeights(const std::string& text, const std::string& name);

inline constexpr double standardGravity_m_per_s2 = 9.80665;

}  // namespace detent::playback
