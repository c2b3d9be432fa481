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
  /// The handle moved against the first push: motor or encoder are reversed, and there is no force any more.
  bool reversed() const { return reversed_; }
  /// The encoder counted nothing while the handle was pushed with the whole force, in and out, and there is no force any more.
  bool unmoved() const { return unmoved_; }
  /// Against growing displacement, as all forces here; at most `largest_N`.
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
  double from_mm_ = 0;       ///< where the handle stood when the push began
  double pushed_s_ = 0;      ///< since then
  int sense_ = 1;            ///< of the push, like `direction_`
  bool counted_ = false;     ///< the encoder
  int strongest_ = 0;        ///< pushes with the whole force
  double relay_N_ = 0;       ///< strength: grows from push to push until the handle moves
  int direction_ = 1;        ///< 1: towards growing displacement
  std::uint32_t turns_ = 0;  ///< since it moves
  double fastest_mm_per_s_;
  double time_s_ = 0, phase_rad_ = 0;
};

}  // namespace detent::playback
