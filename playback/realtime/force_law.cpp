// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_law.h"

#include <algorithm>
#include <cmath>

namespace detent::playback {

namespace {

// A finger that makes less than one step in this time counts as slow: half a step of lag is then not led away, so that a
// tremor across one step's edge moves no force.
constexpr double slowStep_s = 0.02;
constexpr double faded_N = 1e-4;

double between(double low, double high, double share) { return low + share * (high - low); }

}  // namespace

ForceLaw::ForceLaw(const ForceProgram& program)
    : program_(&program),
      fadeFactor_(std::exp(-program.period_s / program.law.crossFade_s)),
      leadSpeed_mm_per_s_(program.step_mm / slowStep_s) {
  restart(program.stateCount > 0 ? program.states[0].first_mm : 0);
}

void ForceLaw::restart(double position_mm) {
  state_ = 0;
  actuated_ = false;
  fading_N_ = stateEnergy_mJ_ = 0;
  play_.restart(position_mm, program_->law.playRadius_mm);
}

ForceLaw::Strokes ForceLaw::at(double position_mm) const {
  const ForceStateTable& t = table();
  const double place = (position_mm - t.first_mm) / t.spacing_mm;
  const double last = static_cast<double>(t.rowCount - 1);
  if (!(place > 0)) return strokesOf(t.rows[0], 0);
  if (place >= last)
    return strokesOf(t.rows[t.rowCount - 1], t.wallSlope_N_per_mm * (place - last) * t.spacing_mm);
  const auto i = static_cast<std::uint32_t>(place);
  const double share = place - i;
  const ForceRow &a = t.rows[i], &b = t.rows[i + 1];
  return {between(a.press_N, b.press_N, share), between(a.release_N, b.release_N, share),
          between(a.pending_N, b.pending_N, share), between(a.damping_Ns_per_mm, b.damping_Ns_per_mm, share)};
}

ForceLaw::Strokes ForceLaw::strokesOf(const ForceRow& row, double wall_N) {
  return {row.press_N + wall_N, row.release_N + wall_N, row.pending_N + wall_N, row.damping_Ns_per_mm};
}

double ForceLaw::stored_mJ(double position_mm) const {
  const ForceStateTable& t = table();
  const double place =
      std::clamp((position_mm - t.first_mm) / t.spacing_mm, 0.0, static_cast<double>(t.rowCount - 1));
  return t.rows[static_cast<std::uint32_t>(place)].stored_mJ;
}

double ForceLaw::curveForce_N(const Strokes& strokes, double pressShare) const {
  return pending() ? strokes.pending_N : between(strokes.release_N, strokes.press_N, pressShare);
}

// A sampled force acts late. Of the force here and the force where the finger will be when it acts, the one that takes more
// energy: a spring rendered this way gives back no more than was put in, whatever damping the device lacks.
double ForceLaw::movingForce_N(double position_mm, double velocity_mm_per_s, double pressShare) const {
  const Strokes here = at(position_mm);
  double force_N = curveForce_N(here, pressShare);
  if (velocity_mm_per_s == 0) return force_N;
  const double lead_mm =
      velocity_mm_per_s * program_->law.holdLead_s +
      0.5 * program_->step_mm * std::clamp(velocity_mm_per_s / leadSpeed_mm_per_s_, -1.0, 1.0);
  const double ahead_N = curveForce_N(at(position_mm + lead_mm), pressShare);
  force_N = velocity_mm_per_s > 0 ? std::max(force_N, ahead_N) : std::min(force_N, ahead_N);
  return table().damped ? force_N + here.damping_Ns_per_mm * velocity_mm_per_s : force_N;
}

double ForceLaw::step(double position_mm, double velocity_mm_per_s) {
  const double radius_mm = program_->law.playRadius_mm;
  if (program_->stateCount > 1) followState(position_mm);
  double pressShare = 1;
  if (table().hysteresis && !pending()) {
    play_.update(position_mm, radius_mm);
    pressShare = play_.pressShare(position_mm, radius_mm);
  }
  const double force_N = movingForce_N(position_mm, velocity_mm_per_s, pressShare) + fading_N_;
  if (fading_N_ != 0) {
    fading_N_ *= fadeFactor_;
    if (std::abs(fading_N_) < faded_N) fading_N_ = 0;
  }
  return force_N;
}

// Before the operating point a press can only be taken back, on its own curve. After it the release curve counts, and where
// that comes to rest the other state begins.
void ForceLaw::followState(double position_mm) {
  if (!actuated_) {
    if (position_mm < table().operating_mm) return;
    actuated_ = true;
    stateEnergy_mJ_ += table().actuationEnergy_mJ;
    play_.setPressing(position_mm, program_->law.playRadius_mm);
    return;
  }
  if (position_mm > table().rest_mm + program_->law.settle_mm) return;
  play_.update(position_mm, program_->law.playRadius_mm);
  const double before_N =
      curveForce_N(at(position_mm), play_.pressShare(position_mm, program_->law.playRadius_mm));
  state_ = (state_ + 1) % program_->stateCount;
  actuated_ = false;
  fading_N_ += before_N - at(position_mm).pending_N;
}

}  // namespace detent::playback
