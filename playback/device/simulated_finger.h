// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A finger for devices without hardware: a mass that follows an intended movement through its own stiffness
// and damping, has tremor, and pushes but never pulls. Deterministic.

#include <cstdint>
#include <variant>
#include <vector>

namespace detent::playback {

/// Mechanics of a pressing fingertip. Sources and uncertainties:
/// docs/develop/decisions/1102-simulated-finger.md.
struct FingerMechanics {
  double mass_kg = 0.008;
  double stiffness_N_per_mm = 0.3;
  double damping_Ns_per_mm = 0.002;
  double pulpStiffness_N_per_mm = 2;  ///< stiffness of the fingertip's contact
  double pulpDamping_Ns_per_mm = 0.001;
  double reaction_s = 0.12;  ///< time from feeling the bottom to turning back
  double tremor_mm = 0.006;  ///< peak
};

/// Moves to a position, stiffened as people are when they aim, and corrects its error. Once the handle is
/// there (or after 0.8 s, as inside a steep snap) it relaxes, carries the present force, and corrects nothing
/// any more.
struct FingerHold {
  double at_mm = 0;
  double force_N = 0;       ///< the button's force at that position, which the finger has to carry
  double approach_s = 0.4;  ///< > 0
};
/// Presses repeatedly: down until the bottom is felt, back after the reaction time, then a pause.
struct FingerPresses {
  double travel_mm = 4;  ///< displacement of the bottom
  double force_N = 1;    ///< strongest force of the button; the finger aims beyond the travel to overcome it
  double press_s = 0.12, release_s = 0.1, pause_s = 0.25;
};
/// Intended positions over time, linear between points; the last one is held.
struct FingerPath {
  std::vector<double> time_s, position_mm;  ///< same length >= 1, times increasing
};
/// Forces over time, without stiffness of its own; the last one is held.
struct FingerForcePath {
  std::vector<double> time_s, force_N;
};
using FingerPlan = std::variant<FingerHold, FingerPresses, FingerPath, FingerForcePath>;

class SimulatedFinger {
 public:
  SimulatedFinger(const FingerMechanics& mechanics, FingerPlan plan);

  /// Force of the finger on a device (N, >= 0, in the direction of pressing); then advances its own state by
  /// one time step. Semi-implicit; `dt_s` at most 50 µs for the stiffness above.
  double push_N(double device_mm, double device_mm_per_s, double dt_s);

 private:
  double intended_mm(double device_mm, double dt_s);
  bool aiming() const { return std::holds_alternative<FingerHold>(plan_) && !arrived_; }
  double intended(const FingerHold& plan, double device_mm, double dt_s);
  double intended(const FingerPresses& plan, double device_mm, double dt_s);
  double intended(const FingerPath& plan, double device_mm, double dt_s);
  double intended(const FingerForcePath&, double device_mm, double) { return device_mm; }
  void relaxAt(const FingerHold& plan, double device_mm, double device_mm_per_s, double muscle_N);
  double contact_N(double device_mm, double device_mm_per_s) const;
  double tremor_mm() const;

  FingerMechanics mechanics_;
  FingerPlan plan_;
  double time_s_ = 0, tip_mm_, tip_mm_per_s_ = 0, wantedBefore_mm_ = 0;
  bool started_ = false;
  std::size_t next_ = 0;  ///< next point of a path
  double correction_mm_ = 0,
         relaxed_mm_ = 0;  ///< for a hold: offset added to the aim before arrival, and the aim after it
  bool arrived_ = false;
  double phaseStart_s_ = 0, turned_mm_ = 0, felt_s_ = -1;
  enum class Phase : std::uint8_t { pause, down, back } phase_ = Phase::pause;
};

}  // namespace detent::playback
