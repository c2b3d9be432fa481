// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A simulated force device: mass, Coulomb and viscous friction, encoder steps, held and delayed force,
// saturation, and a simulated finger. One exchange is one period of its own time, independent of the clock;
// deterministic.

#include <cstddef>
#include <vector>

#include "playback/device/force_device.h"
#include "playback/device/simulated_finger.h"

namespace detent::playback {

struct SimulatedDeviceSettings {
  double mass_kg = 0.05;
  double friction_N = 0.05;
  double damping_Ns_per_mm = 0.001;
  double step_mm = 0.001;
  double period_s = 0.001;
  double delay_s = 0.001;  ///< time from a reading to the force computed from it
  double lag_s = 0;        ///< time constant of the motor
  double force_N = 10;     ///< the motor saturates here
  double start_mm = 0;
  double lowest_mm = -3, highest_mm = 150;  ///< hard, inelastic stops
};

class SimulatedForceDevice : public ForceDevice {
 public:
  SimulatedForceDevice(const SimulatedDeviceSettings& settings, SimulatedFinger finger);

  ForceReading exchange(const ForceCommand& command) override;

  /// The true position, between the encoder's steps. Work that the finger has done on the device so far (mJ):
  /// the energy that a person would feel.
  double fingerWork_mJ() const { return fingerWork_mJ_; }

 private:
  void advance(double motor_N);
  double stepped_mm() const;

  SimulatedDeviceSettings settings_;
  SimulatedFinger finger_;
  std::size_t substeps_ = 1, delaySubsteps_ = 0;
  double dt_s_ = 0;
  /// force of a motor with lag, and the factor by which its error decreases per substep
  double lagged_N_ = 0, lagKept_ = 0;
  double position_mm_ = 0, velocity_mm_per_s_ = 0, fingerWork_mJ_ = 0;
  std::vector<double> waiting_N_;  ///< forces on their way to the motor, a ring of periods
  std::size_t newest_ = 0;
};

}  // namespace detent::playback
