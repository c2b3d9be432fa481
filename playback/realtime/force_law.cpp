// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_law.h"

#include <algorithm>
#include <cmath>

namespace detent::playback {

namespace {

// A finger that moves less than one step in this time counts as slow. Half a step of lag is then not
// compensated, so that a tremor across the edge of a step does not change the force.
constexpr double slowStep_s = 0.02;
constexpr double faded_N = 1e-4;
constexpr double sameForce = 1.1;  // a smaller rise is hardly felt and needs no prediction
constexpr double calm_mm_per_s = 10, calmFor_s = 0.005;

double between(double low, double high, double share) { return low + share * (high - low); }

}  // namespace

ForceLaw::ForceLaw(const ForceProgram& program)
    : program_(&program),
      fadeFactor_(std::exp(-program.period_s / program.law.crossFade_s)),
      leadSpeed_mm_per_s_(program.step_mm / slowStep_s) {
  restart(program.stateCount > 0 ? program.states[0].first_mm : 0);
}

void ForceLaw::restart(double position_mm, double pressShare) {
  state_ = 0;
  actuated_ = false;
  caught_ = true;
  fading_N_ = fadeLeft_mJ_ = stateEnergy_mJ_ = 0;
  play_.restart(position_mm, program_->law.playRadius_mm, pressShare);
  pressShare_ = pressShare;
}

double ForceLaw::Place::between(float ForceRow::*column) const {
  const ForceRow &low = table->rows[below], &high = table->rows[above];
  return playback::between(static_cast<double>(low.*column), static_cast<double>(high.*column), share);
}

double ForceLaw::Place::curve_N(float ForceCurveRow::*stroke, std::uint32_t speed) const {
  if (speed == 0) return between(stroke);
  const auto& rows = table->faster[speed - 1];
  return playback::between(static_cast<double>(rows[below].*stroke), static_cast<double>(rows[above].*stroke),
                           share);
}

double ForceLaw::Place::force_N(float ForceCurveRow::*stroke, double speed_mm_per_s) const {
  const ForceStateTable& t = *table;
  if (t.speedCount < 2 || !(speed_mm_per_s > t.speeds_mm_per_s[0])) return force_N(stroke);
  std::uint32_t i = 1;
  while (i + 1 < t.speedCount && speed_mm_per_s > t.speeds_mm_per_s[i]) ++i;
  const double from = t.speeds_mm_per_s[i - 1], to = t.speeds_mm_per_s[i];
  const double part = speed_mm_per_s < to ? (speed_mm_per_s - from) / (to - from) : 1;
  return playback::between(curve_N(stroke, i - 1), curve_N(stroke, i), part) + bottomOut_N;
}

ForceLaw::Place ForceLaw::placeAt(double position_mm) const {
  const ForceStateTable& t = table();
  const double place = (position_mm - t.first_mm) / t.spacing_mm;
  const double last = static_cast<double>(t.rowCount - 1);
  if (!(place > 0)) return {&t, 0, 0, 0, 0};
  if (place >= last)
    return {&t, t.rowCount - 1, t.rowCount - 1, 0, t.bottomOutSlope_N_per_mm * (place - last) * t.spacing_mm};
  const auto i = static_cast<std::uint32_t>(place);
  return {&t, i, i + 1, place - i, 0};
}

double ForceLaw::stored_mJ(double position_mm) const {
  const ForceStateTable& t = table();
  const auto held = pending() ? &ForceRow::pendingStored_mJ : &ForceRow::stored_mJ;
  const auto force = pending() ? &ForceCurveRow::pending_N : &ForceCurveRow::release_N;
  const double place = (position_mm - t.first_mm) / t.spacing_mm, last = static_cast<double>(t.rowCount - 1);
  if (place >= last) {
    const double above_mm = (place - last) * t.spacing_mm;
    const ForceRow& end = t.rows[t.rowCount - 1];
    // If the force pulls at the end, the least energy is at the start of the end stop; negative values are
    // the table's rounding.
    return std::max(0.0, end.*held + above_mm * (end.*force + 0.5 * t.bottomOutSlope_N_per_mm * above_mm)) +
           playStored_mJ(position_mm);
  }
  const auto i = static_cast<std::uint32_t>(std::max(place, 0.0));
  return between(t.rows[i].*held, t.rows[i + 1].*held, std::max(place, 0.0) - i) + playStored_mJ(position_mm);
}

// Energy stored in the play. Between press and release curve the force is above the latter: the result is 2r
// times the integral over the share u of (press - release) u, by Simpson's rule.
double ForceLaw::playStored_mJ(double position_mm) const {
  if (pending() || !table().hysteresis) return 0;
  const double radius_mm = program_->law.playRadius_mm;
  const double share = std::clamp(play_.pressShare(position_mm, radius_mm), 0.0, 1.0);
  const auto apart_N = [&](double at_mm) {
    const Place place = placeAt(at_mm);  // after interpolation, equal curves differ by rounding
    return std::max(0.0, place.force_N(&ForceRow::press_N) - place.force_N(&ForceRow::release_N));
  };
  return radius_mm * share * share / 3 *
         (2 * apart_N(position_mm - radius_mm * share) + apart_N(position_mm));
}

double ForceLaw::curveForce_N(const Place& place, double pressShare, double velocity_mm_per_s) const {
  if (pending()) return place.force_N(&ForceRow::pending_N, velocity_mm_per_s);
  const double press_N = place.force_N(&ForceRow::press_N, velocity_mm_per_s);
  return table().hysteresis
             ? between(place.force_N(&ForceRow::release_N, -velocity_mm_per_s), press_N, pressShare)
             : press_N;
}

// A sampled force acts late. Of the force at the present position and that at the predicted position, returns
// the one that takes more energy: a spring rendered this way gives back no more than was put in, even if the
// device has little damping.
double ForceLaw::movingForce_N(double position_mm, double velocity_mm_per_s, double pressShare) const {
  const Place here = placeAt(position_mm);
  double force_N = curveForce_N(here, pressShare, velocity_mm_per_s);
  if (velocity_mm_per_s == 0) return force_N;
  const double lead_mm =
      velocity_mm_per_s * program_->law.holdLead_s +
      0.5 * program_->step_mm * std::clamp(velocity_mm_per_s / leadSpeed_mm_per_s_, -1.0, 1.0);
  // The prediction stops at the operating point, because the actuation comes before the force behind it.
  const double farthest_mm = pending() ? std::max(position_mm, table().operating_mm) : position_mm + lead_mm;
  const double aheadShare = std::clamp(pressShare + 0.5 * lead_mm / program_->law.playRadius_mm, 0.0, 1.0);
  const double ahead_N =
      curveForce_N(placeAt(std::min(position_mm + lead_mm, farthest_mm)), aheadShare, velocity_mm_per_s);
  force_N = velocity_mm_per_s > 0 ? std::max(force_N, ahead_N) : std::min(force_N, ahead_N);
  return table().damped ? force_N + here.damping_Ns_per_mm() * velocity_mm_per_s : force_N;
}

double ForceLaw::step(double position_mm, double velocity_mm_per_s) {
  const double radius_mm = program_->law.playRadius_mm;
  if (program_->stateCount > 1)
    followState(position_mm, std::max(0.0, velocity_mm_per_s * program_->law.holdLead_s), velocity_mm_per_s);
  pressShare_ = 1;
  if (table().hysteresis && !pending()) {
    play_.update(position_mm, radius_mm);
    pressShare_ = play_.pressShare(position_mm, radius_mm);
  }
  if (fading_N_ != 0) fade(position_mm, velocity_mm_per_s);
  const double force_N = movingForce_N(position_mm, velocity_mm_per_s, pressShare_) + fading_N_;
  return caught_ ? force_N : force_N + caughtBy_N(velocity_mm_per_s);
}

// A handle that falls into its latch would bounce, and a bounce is no press. It is damped, and nothing
// actuates until it has been calm for a moment that is longer than the turns of a bounce.
double ForceLaw::caughtBy_N(double velocity_mm_per_s) {
  calm_s_ = std::abs(velocity_mm_per_s) < calm_mm_per_s ? calm_s_ + program_->period_s : 0;
  caught_ = calm_s_ >= calmFor_s;
  return program_->law.catchDamping_Ns_per_mm * velocity_mm_per_s;
}

// The cross-fade may give at most the energy that the previous state still held; beyond that it ends at once.
void ForceLaw::fade(double position_mm, double velocity_mm_per_s) {
  const double given_mJ = std::max(0.0, fading_N_ * (fadedAt_mm_ - position_mm));
  fadedAt_mm_ = position_mm;
  stateEnergy_mJ_ += given_mJ;
  fadeLeft_mJ_ = std::max(0.0, fadeLeft_mJ_ - given_mJ);
  fading_N_ *= fadeFactor_;
  const double next_mJ = -fading_N_ * velocity_mm_per_s * program_->period_s;
  if (next_mJ > fadeLeft_mJ_) fading_N_ *= fadeLeft_mJ_ / next_mJ;
  if (std::abs(fading_N_) < faded_N) fading_N_ = 0;
}

// Changes the state. Before the operating point a press can only be reversed, along its own curve. After it,
// the release curve applies, and where that comes to rest the next state begins.
void ForceLaw::followState(double position_mm, double lead_mm, double velocity_mm_per_s) {
  if (!actuated_) {
    if (!caught_ || position_mm + lead_mm < table().operating_mm) return;
    const double at_mm = std::max(position_mm, table().operating_mm);
    // If the force increases at the actuation, the state changes early, so that the new force acts when the
    // handle arrives; otherwise the handle would do less work than the new state stores. If the force does
    // not increase, the change waits for the handle.
    const Place acts = placeAt(at_mm);
    if (position_mm < at_mm &&
        acts.force_N(&ForceRow::press_N) <= sameForce * acts.force_N(&ForceRow::pending_N))
      return;
    const double held_mJ = stored_mJ(at_mm);
    actuated_ = true;
    play_.setPressing(at_mm, program_->law.playRadius_mm);
    stateEnergy_mJ_ += stored_mJ(at_mm) - held_mJ;
    return;
  }
  if (position_mm > table().rest_mm + program_->law.settle_mm) return;
  play_.update(position_mm, program_->law.playRadius_mm);
  const double held_mJ = stored_mJ(position_mm);
  const double before_N = curveForce_N(
      placeAt(position_mm), play_.pressShare(position_mm, program_->law.playRadius_mm), velocity_mm_per_s);
  state_ = (state_ + 1) % program_->stateCount;
  actuated_ = caught_ = false;
  calm_s_ = 0;
  const double change_mJ = stored_mJ(position_mm) - held_mJ;
  stateEnergy_mJ_ += change_mJ;
  fadeLeft_mJ_ = std::max(0.0, -change_mJ);
  fadedAt_mm_ = position_mm;
  fading_N_ += before_N - placeAt(position_mm).force_N(&ForceRow::pending_N, velocity_mm_per_s);
}

}  // namespace detent::playback
