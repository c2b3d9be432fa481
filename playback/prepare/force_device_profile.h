// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Properties of one force-feedback device: mechanics, encoder, timing and limits. Presets of the simulated
// devices; a real one starts from the preset nearest to it (docs/guide/force-feedback.md).

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
  double delay_s = 0.001;  ///< >= 0; from a reading to the force it causes, beyond the hold of one period
  double lag_s = 0;        ///< >= 0; time constant with which the force follows after that
  double largestSlope_N_per_mm = 2;  ///< > 0; steepest slope it may render
  ForceLimits limits;
  ForceGuide guide;  ///< present on three-axis devices
  /// Mass, friction, damping, delay and lag were measured on this device (detent-play identify-device); else
  /// they are a preset's.
  bool measured = false;
  bool provesDirection =
      false;  ///< wired by its user: motor and encoder are checked against each other before any force
  bool watchesEncoder =
      false;  ///< has an encoder that can break: one that does not count under force is given up
  /// >= 0; by how much a force may act later than `delay_s` says, without the law knowing it.
  double jitter_s = 0;

  /// Lateness of a force, beyond the hold of one period.
  double late_s() const { return delay_s + lag_s; }
};

/// 1 µm encoder, 50 g: a good device on a bench.
ForceDeviceProfile simulatedDevice();
/// Novint Falcon: 38 µm at the knee, 8 N, 1 kHz, three axes. Mass, friction and damping are not measured.
ForceDeviceProfile falconDevice();
/// Voice coil with a 10 µm linear encoder.
ForceDeviceProfile voiceCoilRig();

}  // namespace detent::playback
