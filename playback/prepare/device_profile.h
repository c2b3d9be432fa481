// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Properties of one vibrating device and its sensor: measured by `detent-play sweep` and `calibrate`, stored
// in a text file (study/profile_file.h, docs/reference/device-profile.md), and used when a button is prepared
// for the device.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "playback/realtime/haptic_program.h"
#include "playback/realtime/sensor_calibration.h"

namespace detent::playback {

/// A peak of the frequency response.
struct Resonance {
  double frequency_Hz = 0;
  double q = 1;
  double gain_dB = 0;  ///< height above the response around it
};

/// The actuator that turns the signal into movement, and its limits.
struct Transducer {
  double power_W = 0;  ///< continuous power that it tolerates; 0: unknown, no limit
  double impedance_ohm = 8;
  double fullScale_V = 0;  ///< voltage at its terminals for a signal at full scale

  /// Share of full scale that even a square wave may have continuously: amplitude^2 / impedance <= power.
  double highestLevel() const {
    if (!(power_W > 0) || !(fullScale_V > 0)) return 1;
    const double level = std::sqrt(power_W * impedance_ohm) / fullScale_V;
    return level < 1 ? level : 1;
  }
};

/// Measured delay from sensor to vibration. Kim & Lee (UIST 2013) state theirs: 51.12 ms (N = 50, SD 1.65).
struct MeasuredLatency {
  std::size_t n = 0;
  double mean_s = 0, sd_s = 0, p95_s = 0;
};

/// Plain value. An empty profile is an ideal device: flat response, gain 1, newtons from the sensor.
struct DeviceProfile {
  std::string name;
  double gain = 1;                       ///< > 0, <= 10; applied before the limiter
  std::vector<Resonance> resonances;     ///< strongest first
  std::vector<EqualizerBand> equalizer;  ///< at most maxEqualizerBands
  Transducer transducer;
  SensorCalibration sensor;
  std::optional<MeasuredLatency> latency;
  /// Felt level of a sine of full scale at 250 Hz, without the resonances, dB above the threshold of a
  /// fingertip; empty: not measured.
  std::optional<double> fullScale_dB;
};

}  // namespace detent::playback
