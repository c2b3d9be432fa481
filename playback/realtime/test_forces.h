// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The forces of a ForceExcitation, one per period. No allocation, lock or clock.

#include "playback/realtime/force_program.h"

namespace detent::playback {

class TestForces {
 public:
  explicit TestForces(const ForceProgram& program)
      : excitation_(program.excitation),
        period_s_(program.period_s),
        step_mm_(program.step_mm),
        fastest_mm_per_s_(program.excitation.fastest_mm_per_s) {}

  bool present() const { return excitation_.kind != ForceExcitation::Kind::none; }
  /// Returns true if the handle moved against the first push: motor or encoder are reversed, and there is no
  /// force any more.
  bool reversed() const { return reversed_; }
  /// Returns true if the encoder counted nothing while the handle was pushed with the full force, in and out;
  /// there is no force any more.
  bool unmoved() const { return unmoved_; }
  /// Force in the direction of decreasing displacement, as everywhere here; at most `largest_N`.
  double step_N(double position_mm, double velocity_mm_per_s);

 private:
  double relay_N(double position_mm, double velocity_mm_per_s);
  double chirp_N(double position_mm, double velocity_mm_per_s);
  double firstMove_N(double position_mm);
  void beginPush(double position_mm);
  void keepInside(double beyond_mm);

  ForceExcitation excitation_;
  double period_s_, step_mm_;
  bool begun_ = false, moving_ = false, reversed_ = false, unmoved_ = false;
  double from_mm_ = 0;       ///< position of the handle at the start of the push
  double pushed_s_ = 0;      ///< duration since then
  int sense_ = 1;            ///< direction of the push, as in `direction_`
  bool counted_ = false;     ///< the encoder has counted
  int strongest_ = 0;        ///< number of pushes with the full force
  double relay_N_ = 0;       ///< strength of a push; increases from push to push until the handle moves
  int direction_ = 1;        ///< 1: towards growing displacement
  std::uint32_t turns_ = 0;  ///< number of turns since the handle moves
  double fastest_mm_per_s_;
  double time_s_ = 0, phase_rad_ = 0;
};

}  // namespace detent::playback
