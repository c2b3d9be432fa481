// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Properties of one force-feedback device: mechanics, encoder, timing and limits. There are presets for the
// simulated devices; a real one starts from the most similar preset (docs/guide/force-feedback.md).

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "playback/realtime/force_program.h"

namespace detent::playback {

/// Plain value. Damping and friction are the device's own, without any button.
struct ForceDeviceProfile {
  std::string name;
  double mass_kg = 0.05;             ///< > 0; moved with the finger
  double friction_N = 0.05;          ///< >= 0; Coulomb
  double damping_Ns_per_mm = 0.001;  ///< >= 0; viscous
  double step_mm = 0.01;             ///< > 0; encoder, at the finger
  double rate_Hz = 1000;             ///< 50..20000; steps of the law
  /// >= 0; from a reading to the force computed from it, beyond the hold of one period
  double delay_s = 0.001;
  double lag_s = 0;                  ///< >= 0; time constant with which the force follows after that
  double largestSlope_N_per_mm = 2;  ///< > 0; steepest slope that it may render
  ForceLimits limits;
  ForceGuide guide;  ///< present on three-axis devices
  /// Mass, friction, damping, delay and lag were measured on this device (detent-play identify-device);
  /// otherwise they are those of a preset.
  bool measured = false;
  bool provesDirection =
      false;  ///< its user wired it: motor and encoder are checked against each other before any force
  bool watchesEncoder =
      false;  ///< its encoder may fail: one that does not count under force is reported as broken
  /// >= 0; additional delay of a force beyond `delay_s` that may occur and that the law does not know.
  double jitter_s = 0;

  /// Total lateness of a force, beyond the hold of one period.
  double late_s() const { return delay_s + lag_s; }
};

/// 1 µm encoder, 50 g: a good device on a bench.
ForceDeviceProfile simulatedDevice();
/// Novint Falcon: 38 µm at the knee, 8 N, 1 kHz, three axes. Mass, friction and damping are assumed.
ForceDeviceProfile falconDevice();
/// Voice coil with a 10 µm linear encoder.
ForceDeviceProfile voiceCoilRig();

}  // namespace detent::playback
