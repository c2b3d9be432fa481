// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Conversion of a force sensor's readings to newtons. The coefficients come from known weights
// (study/calibrate.h) and are stored in the device profile; the reader thread applies them.

#include <array>
#include <cstddef>
#include <limits>

namespace detent::playback {

/// Conversion of the raw reading before the polynomial.
enum class SensorCircuit {
  newtons,  ///< the sensor sends newtons already; the coefficients correct them
  linear,   ///< counts proportional to force (load cell, FSR with current-to-voltage amplifier)
  divider   ///< FSR to the supply, fixed resistor to 0 V: conductance ~ counts / (fullScale - counts) ~
            ///< force (Interlink FSR integration guide: resistance ~ 1 / force)
};

/// force_N = c0 + c1 u + c2 u^2 + c3 u^3, u from the circuit. Plain value, any thread.
struct SensorCalibration {
  static constexpr std::size_t maxCoefficients = 4;

  SensorCircuit circuit = SensorCircuit::newtons;
  double fullScale_counts = 1023;  ///< largest reading of the converter; > 0
  std::size_t coefficientCount = 2;
  std::array<double, maxCoefficients> coefficients{0, 1, 0, 0};
  /// standard errors of the coefficients; 0 if unknown
  std::array<double, maxCoefficients> standardErrors{};
  double noise_N = 0;                   ///< SD of the readings at rest; 0: not measured
  double residual_N = 0;                ///< SD of the weights around the curve
  double lowest_N = 0, highest_N = 12;  ///< range covered by the weights
  std::size_t weights = 0;              ///< how many readings it came from; 0: never calibrated

  /// SD of the readings for a still finger: measured, or at worst the scatter of the weights; 0: unknown.
  double knownNoise_N() const { return noise_N > 0 ? noise_N : residual_N; }

  /// The quantity that is linear in force for the circuit. NaN for a saturated divider (at or above full
  /// scale).
  double linearised(double raw) const {
    switch (circuit) {
      case SensorCircuit::newtons:
        return raw;
      case SensorCircuit::linear:
        return raw / fullScale_counts;
      case SensorCircuit::divider:
        break;
    }
    return raw < fullScale_counts ? raw / (fullScale_counts - raw) : std::numeric_limits<double>::quiet_NaN();
  }

  double force_N(double raw) const {
    const double u = linearised(raw);
    double force = 0;
    for (std::size_t i = coefficientCount; i-- > 0;) force = coefficients[i] + u * force;
    return force;
  }
};

}  // namespace detent::playback
