// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The force of a button at a position and a velocity: F = F(x, v) + b(x) v, with press and release joined by
// a play operator, and the states of a self-locking button. Shrestha, "Basic Model", with measured curves in
// place of k(x) x. With graphs at several speeds, the press curve follows the speed of pressing and the
// release curve that of releasing. At rest, and where the handle turns, both are those of the lowest speed,
// so that no force jumps when the velocity changes its sign.

#include <cstdint>

#include "playback/realtime/force_program.h"
#include "playback/realtime/play_operator.h"

namespace detent::playback {

/// Evaluates one program, which must outlive it. No allocation, lock, clock or exception.
class ForceLaw {
 public:
  explicit ForceLaw(const ForceProgram& program);

  /// Starts at rest in the first state at a position; `pressShare`: between release (0) and press curve (1).
  void restart(double position_mm, double pressShare = 0);
  /// Position of the last step between release (0) and press curve (1).
  double pressShare() const { return pressShare_; }

  /// Force in N, before any limit. `position_mm` is finite and without flicker (force_engine.h).
  double step(double position_mm, double velocity_mm_per_s);

  std::uint32_t state() const { return state_; }
  /// Returns true if the present press has passed the operating point (self-locking buttons).
  bool actuated() const { return actuated_; }
  /// Energy stored at a position in the law's present state (mJ, >= 0).
  double stored_mJ(double position_mm) const;
  /// Increase of the stored energy by actuations and changes of state since `restart` (mJ): energy that these
  /// may give.
  double stateEnergy_mJ() const { return stateEnergy_mJ_; }

 private:
  /// A position between two rows, or in the end stop behind the last. Table columns of properties that the
  /// button does not have are not read.
  struct Place {
    const ForceStateTable* table;
    std::uint32_t below, above;
    double share, bottomOut_N;

    /// Force at the lowest speed.
    double force_N(float ForceCurveRow::*stroke) const { return between(stroke) + bottomOut_N; }
    double force_N(float ForceCurveRow::*stroke, double speed_mm_per_s) const;
    double damping_Ns_per_mm() const { return between(&ForceRow::damping_Ns_per_mm); }

   private:
    double between(float ForceRow::*column) const;
    double curve_N(float ForceCurveRow::*stroke, std::uint32_t speed) const;
  };
  Place placeAt(double position_mm) const;
  double curveForce_N(const Place& place, double pressShare, double velocity_mm_per_s) const;
  bool pending() const { return program_->stateCount > 1 && !actuated_; }
  double movingForce_N(double position_mm, double velocity_mm_per_s, double pressShare) const;
  /// `lead_mm` >= 0: distance that the handle moves until the force acts.
  void followState(double position_mm, double lead_mm, double velocity_mm_per_s);
  double playStored_mJ(double position_mm) const;
  void fade(double position_mm, double velocity_mm_per_s);
  double caughtBy_N(double velocity_mm_per_s);
  const ForceStateTable& table() const { return program_->states[state_]; }

  const ForceProgram* program_;
  PlayOperator play_;
  double pressShare_ = 0;
  std::uint32_t state_ = 0;
  bool actuated_ = false;
  bool caught_ = true;   ///< the handle has been calm since the state changed, so a press may actuate
  double calm_s_ = 0;    ///< duration of the calm so far
  double fading_N_ = 0;  ///< force difference to the previous state, which fades out
  double fadeLeft_mJ_ = 0,
         /// energy that the cross-fade may still give, and the position where it was last counted
      fadedAt_mm_ = 0;
  double fadeFactor_ = 0;
  double leadSpeed_mm_per_s_ = 0;
  double stateEnergy_mJ_ = 0;
};

}  // namespace detent::playback
