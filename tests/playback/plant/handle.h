// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The independent world around the force engine: a handle with a motor, and a finger on it. Written from the
// papers and the public headers, without sight of the engine, so that what it finds is evidence. Reading
// order: handle.h (mechanics), finger.h (who presses), transport.h (what lies between), closed_loop.h (engine
// and world together), faults.h, *_emulator.h (devices on a pty).
//
// Signs as in the product: displacement in mm grows with pressing, the motor's force in N acts against
// pressing. Energies in mJ.

#include <cstddef>
#include <functional>

namespace detent::test {

/// One degree of freedom: mass, viscous damping, Coulomb and static friction, hard stops, and a motor that
/// lags and saturates.
struct HandleSettings {
  double mass_kg = 0.05;
  double damping_Ns_per_mm = 0.001;
  double coulomb_N = 0.05;   ///< sliding friction, N
  double static_N = 0.06;    ///< friction at rest, >= coulomb_N
  double motorLag_s = 0;     ///< time constant from a command to its force, 0: at once
  double motorLimit_N = 20;  ///< saturation, both signs
  double lowest_mm = -20, highest_mm = 200;
};

/// Fingertip: effective mass behind a pulp, moved by a muscle. Effective mass 3 to 9 g, 0.2 to 0.8 N/mm and
/// 0.002 to 0.005 N·s/mm are the range Hajian and Howe give for the index finger (J. Biomech. Eng. 1997); the
/// pulp's force grows exponentially with displacement (Pawluk and Howe, J. Biomech. Eng. 1999), here 0.6 N/mm
/// at the first touch and 3 N/mm at 1 N; physiological tremor 8 to 12 Hz of 2 % of the force; a muscle
/// follows its nerve with about 40 ms. Numbers from memory of these papers, not read off them.
struct FingerSettings {
  double mass_kg = 0.006;
  double stiffness_N_per_mm = 0.3, damping_Ns_per_mm = 0.003;  ///< of the finger's joint, towards its aim
  double pulpForce_N = 0.25, pulpRate_per_mm = 2.5;            ///< F = force (exp(rate d) - 1)
  double pulpLoss_s_per_mm = 0.003;                            ///< Hunt and Crossley: F (1 + loss d')
  double muscleLag_s = 0.04;
  double tremorShare = 0;  ///< amplitude as a share of the force pressed with
  double tremor_Hz = 9.5;
};

/// Command of the nerve: a target position reached through the joint's stiffness, plus a force.
struct Intent {
  double aim_mm = 0, push_N = 0;
};
using Plan = std::function<Intent(double time_s)>;

/// Energy flows since the start. The energy put in equals the stored and lost energy, to rounding.
struct EnergyAccount {
  double muscle_mJ = 0;  ///< work of the muscle on the fingertip
  double motor_mJ = 0;   ///< work of the motor on the handle
  double finger_mJ =
      0;  ///< work of the fingertip on the handle: the person's contribution to button and device
  double viscous_mJ = 0, friction_mJ = 0, pulp_mJ = 0, stops_mJ = 0;  ///< lost, each >= 0
  double stored_mJ = 0;  ///< kinetic and in the pulp, less the energy at the start
  double residual_mJ() const {
    return muscle_mJ + motor_mJ - viscous_mJ - friction_mJ - pulp_mJ - stops_mJ - stored_mJ;
  }
  double turnover_mJ = 0;  ///< sum of the sizes of all flows: the scale of the residual
};

/// A handle with a finger on it. Implicit midpoint with the pulp's exact mean force over a step, so that
/// energy is conserved to rounding; a slide that ends, ends within a step, and friction only ever takes.
/// Deterministic; no clock.
class HandleAndFinger {
 public:
  static constexpr double step_s = 1.0 / 40000;

  HandleAndFinger(const HandleSettings& handle, const FingerSettings& finger, Plan plan, double start_mm = 0);

  /// One integration step. `command_N`: force last requested from the motor.
  void advance(double command_N);
  /// Removes the finger and resets the energy counts.
  void takeFingerAway();
  /// The tip flies at a speed, `gap_mm` before the handle.
  void throwTip(double gap_mm, double speed_mm_per_s);

  double time_s() const { return static_cast<double>(steps_) * step_s; }
  double position_mm() const { return x_mm_; }
  double velocity_mm_per_s() const { return v_mm_per_s_; }
  double tip_mm() const { return tip_mm_; }
  double fingerForce_N() const { return pulp_N_; }  ///< mean over the last step
  double motorForce_N() const { return motor_N_; }
  const EnergyAccount& energy() const { return energy_; }

 private:
  struct Move {
    double to_mm = 0, to_mm_per_s = 0, way_mm = 0, friction_mJ = 0, viscous_mJ = 0, stops_mJ = 0;
  };
  Move slide(double push_N, bool breaksAway) const;
  double pulpEnergy_mJ(double depth_mm) const;
  double pulpElastic_N(double fromDepth_mm, double toDepth_mm) const;
  double meanMotor_N(double command_N);
  Intent intent();
  double storedNow_mJ() const;

  HandleSettings handle_;
  FingerSettings finger_;
  Plan plan_;
  Intent followed_;
  bool present_ = true;  ///< a finger is there
  std::size_t steps_ = 0;
  double x_mm_, v_mm_per_s_ = 0, tip_mm_, tip_mm_per_s_ = 0;
  double motor_N_ = 0, pulp_N_ = 0, storedAtStart_mJ_ = 0;
  double push_N_ = 0;  ///< on the handle over the last step: whether it breaks away is decided by it
  EnergyAccount energy_;
};

}  // namespace detent::test
