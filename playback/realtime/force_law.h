// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The force of a button at a position and a velocity: F = F(x, v) + b(x) v, with press and release joined by
// a play operator and the states of a self-locking button. Shrestha, "Basic Model", with measured curves in
// the place of k(x) x. Where there are graphs at several speeds, the press curve follows the speed of
// pressing and the release curve that of releasing: at rest and where the handle turns both are those of the
// lowest speed, so that no force jumps with a velocity's sign.

#include <cstdint>

#include "playback/realtime/force_program.h"
#include "playback/realtime/play_operator.h"

namespace detent::playback {

/// Runs one program. The program must outlive it. No allocation, lock, clock or exception.
class ForceLaw {
 public:
  explicit ForceLaw(const ForceProgram& program);

  /// Starts at rest in the first state at a position; between release (0) and press curve (1) at a share.
  void restart(double position_mm, double pressShare = 0);
  /// Share of the last step between release (0) and press curve (1).
  double pressShare() const { return pressShare_; }

  /// Force in N, before any limit. `position_mm` is free of flicker (force_engine.h), finite.
  double step(double position_mm, double velocity_mm_per_s);

  std::uint32_t state() const { return state_; }
  /// The press of this actuation has passed the operating point (self-locking buttons).
  bool actuated() const { return actuated_; }
  /// Energy held at a position, with the memory the law has now (mJ, >= 0).
  double stored_mJ(double position_mm) const;
  /// Increase of the stored energy by actuations and changes of state since `restart` (mJ): the energy that
  /// they may give.
  double stateEnergy_mJ() const { return stateEnergy_mJ_; }

 private:
  /// Between two rows, or in the end stop behind the last. Properties that a button does not have are not
  /// read from them.
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
  /// `lead_mm` >= 0: how far on the handle is when the force acts.
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
  bool caught_ = true;   ///< the handle has been calm since the state changed: a press may actuate
  double calm_s_ = 0;    ///< for so long it has been
  double fading_N_ = 0;  ///< of the state before, cross-fading
  double fadeLeft_mJ_ = 0,
         fadedAt_mm_ = 0;  ///< what the cross-fade may still give; where it was counted last
  double fadeFactor_ = 0;
  double leadSpeed_mm_per_s_ = 0;
  double stateEnergy_mJ_ = 0;
};

}  // namespace detent::playback
