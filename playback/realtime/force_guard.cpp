// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_guard.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace detent::playback {

namespace {

// After excess speed, the device must have slowed down to this share of the limit before force returns.
constexpr double calmShare = 0.5;

// Frozen encoder: at least this speed and this many steps over the last three movements, then no step for
// this time, under a force that could startle. Of 20,000 standstills in normal presses none lasted longer
// than 7 ms after 30 mm/s (docs/develop/decisions/1114-dead-encoders.md).
constexpr double swift_mm_per_s = 30, swiftSteps = 4, deadStill_s = 0.008, dangerous_N = 1;
constexpr double frozenRamp_s = 0.005;

// The longest movement assumed during missing readings: a device that comes back farther away has lost its
// position.
constexpr double longestUnseen_mm = 10;
// Tolerances for a late or early reading of a steady movement, for an encoder's noise, and for the rebound
// from a stop.
constexpr double hasteOfPace = 1.5, reboundOfPace = 0.4, noiseSteps = 3;
// This many absurd readings within about this time mean a lost position: an encoder that flickers is as bad
// as one that jumps.
constexpr double mostJumps = 2.5, jumpMemory_s = 0.05;

// This many drop-outs within this time halt the force, because a force that comes and goes shakes the hand.
constexpr double dropOutWindow_s = 1, longAgo_s = -1e9;
// after a drop-out or a pause a handle may still move fast under the finger that pressed it
constexpr double thrown_s = 0.5;
constexpr double longestStall = 4;  // number of periods; applies if they last longer than the stall limit

// Dead encoder: after this time without a step the force is lowered slowly. A handle that merely sticks moves
// at once, because friction carries less than the force; the force then returns before much is felt. If
// nothing moves, not even without force for a moment, the encoder is broken.
constexpr double uncountedFor_s = 0.2, probe_s = 0.11, withoutForce_s = 0.1, probed_s = 0.02;

// Runaway: a correct motor takes energy from a handle that moves against it. Halts when this much work was
// done without it, because it came back as speed, or because the handle passed the end of travel under the
// full force without slowing down, or for too long.
constexpr double wholeShare = 0.95, runawayWork_mJ = 0.7, leastResisting_N = 0.2;
// Within the travel: if the limit is below the button's force, a finger may press through it.
constexpr double leastGain_mJ = 1;
constexpr double gainedAtLimit = 0.2,  // the handle may be heavier than the profile states
    gainedBeyond = 0.8;                // a strong finger may still accelerate just beyond the travel
constexpr double farBeyond_mm = 2, slowing = 0.8, notSlowingFor_s = 0.0015, pinnedFor_s = 0.1,
                 comingBack_mm_per_s = 10;

double kinetic_mJ(double mass_kg, double speed_mm_per_s) {
  return 0.5e-3 * mass_kg * speed_mm_per_s * speed_mm_per_s;
}

}  // namespace

ForceGuard::ForceGuard(const ForceLimits& limits, double period_s, double step_mm)
    : limits_(limits), period_s_(period_s), step_mm_(step_mm), stalledAt_s_(longAgo_s) {
  dropOuts_s_.fill(longAgo_s);
}

void ForceGuard::setLimits(const ForceLimits& limits, double period_s, double step_mm) {
  limits_ = limits;
  period_s_ = period_s;
  step_mm_ = step_mm;
}

// Returns true if the encoder seems to have stopped counting. A hand that stops, or a spring, slows the
// handle down over several readings. An immediate stop means a broken encoder or a handle that hits its stop;
// in the latter case the force returns with the next step.
bool ForceGuard::frozen(double force_N) const {
  const double way_mm = std::abs(paces_mm_[0] + paces_mm_[1] + paces_mm_[2]);
  const auto readings = static_cast<double>(paces_mm_.size());
  return last_mm_ > limits_.deadCountFrom_mm &&
         way_mm >= std::max(swift_mm_per_s * readings * period_s_, swiftSteps * step_mm_) &&
         (unchanged_ + 1) * period_s_ >= deadStill_s - 1e-9 &&
         std::abs(force_N) > std::min(dangerous_N, limits_.deadCountAbove_N);
}

std::uint32_t ForceGuard::held() const {
  return std::min(limits_.heldReadings, static_cast<std::uint32_t>(limits_.longestHold_s / period_s_ + 1e-6));
}

// Returns true if a movement from the last good position leads here: it keeps its speed, gains speed up to
// the limit, stops at once, or turns as fast as it may gain. Missing readings give it time to gain more
// speed; positions that jumped do not, and neither do positions that follow from a jump.
bool ForceGuard::reachable(double position_mm) const {
  const double way_mm = position_mm - last_mm_;
  if (settling()) return std::abs(way_mm) <= limits_.speed_mm_per_s * period_s_ * std::max(1.0, since_);
  const double perPeriod_mm = limits_.acceleration_mm_per_s2 * period_s_ * period_s_;
  const double noise_mm = noiseSteps * step_mm_, blind = 1 + unseen_;
  const bool onward = way_mm * pace_mm_ >= 0;
  const double paced_mm = onward ? hasteOfPace * since_ : reboundOfPace;
  const double reach_mm = paced_mm * std::abs(pace_mm_) + perPeriod_mm * blind * (blind + 1) / 2 + noise_mm;
  const double most_mm = longestUnseen_mm + hasteOfPace * std::abs(pace_mm_);
  if (std::abs(way_mm) > std::min(reach_mm, most_mm)) return false;
  if (!jumpedTo_mm_) return true;
  const double fromJump_mm = std::abs(position_mm - *jumpedTo_mm_ - pace_mm_),
               fromHere_mm = std::abs(way_mm - pace_mm_ * since_);
  return fromHere_mm <= fromJump_mm;
}

ReadingVerdict ForceGuard::verdictOn(double position_mm, bool fresh) const {
  if (!fresh) return ReadingVerdict::missing;
  if (!std::isfinite(position_mm)) return ReadingVerdict::notFinite;
  if (displaced_) return ReadingVerdict::displaced;
  if (position_mm < limits_.lowest_mm || position_mm > limits_.highest_mm ||
      (started_ && !reachable(position_mm))) {
    return ReadingVerdict::absurd;
  }
  return ReadingVerdict::good;
}

void ForceGuard::count(ReadingVerdict verdict) {
  ++counts_.readings;
  switch (verdict) {
    case ReadingVerdict::good:
      return;
    case ReadingVerdict::missing:
      ++counts_.missing;
      return;
    case ReadingVerdict::notFinite:
      ++counts_.notFinite;
      return;
    case ReadingVerdict::absurd:
      ++counts_.absurd;
      return;
    case ReadingVerdict::displaced:
      return;
  }
}

void ForceGuard::follow(double position_mm) {
  if (started_ && position_mm == last_mm_) {
    unchanged_ += unchanged_ < std::numeric_limits<std::uint32_t>::max() ? 1 : 0;
    return;
  }
  if (unchanged_ > 0) paces_mm_.fill(0);
  std::rotate(paces_mm_.begin(), paces_mm_.end() - 1, paces_mm_.end());
  paces_mm_[0] = started_ ? pace_mm_ : 0;
  unchanged_ = 0;
  last_mm_ = position_mm;
  started_ = true;
}

void ForceGuard::followJumps(ReadingVerdict verdict, double position_mm, double periods) {
  jumps_ *= std::exp(-periods * period_s_ / jumpMemory_s);
  if (verdict == ReadingVerdict::absurd) {
    if (settling()) return forgetPlace();  // no force has resulted from it, so another position is accepted
    jumpedTo_mm_ = position_mm;
    ++jumps_;
    if (bad_ > held() || (bad_ == 1 && jumps_ > mostJumps)) displace();
  } else if (verdict == ReadingVerdict::good) {
    jumpedTo_mm_.reset();
  } else {
    unseen_ += 1;
  }
}

ReadingVerdict ForceGuard::judge(double position_mm, bool fresh, double periods) {
  elapsed_s_ = periods * period_s_;
  time_s_ += elapsed_s_;
  moved_mm_ = 0;
  if (running_ && elapsed_s_ > std::max(limits_.stall_s, longestStall * period_s_)) {
    ++counts_.stalled;
    stalledAt_s_ = time_s_;
    interrupted_ = true;
    riseAnew();
  }
  since_ += periods;
  unseen_ += std::max(0.0, periods - 1);  // during a delay of the loop no readings were taken
  const ReadingVerdict verdict = verdictOn(position_mm, fresh);
  count(verdict);
  if (verdict == ReadingVerdict::good) {
    if (started_ && since_ > 0) pace_mm_ = (position_mm - last_mm_) / since_;
    if (started_) moved_mm_ = position_mm - last_mm_;
    follow(position_mm);
    since_ = unseen_ = 0;
    bad_ = 0;
    if (good_ <= limits_.heldReadings) ++good_;
    if (settled_ <= limits_.heldReadings) ++settled_;
  } else {
    good_ = 0;
    bad_ += bad_ < std::numeric_limits<std::uint32_t>::max() ? 1 : 0;
  }
  followJumps(verdict, position_mm, periods);
  return verdict;
}

void ForceGuard::forgetPlace() {
  started_ = interrupted_ = false;
  settled_ = unchanged_ = 0;
  pace_mm_ = since_ = unseen_ = jumps_ = 0;
  paces_mm_.fill(0);
  jumpedTo_mm_.reset();
}

void ForceGuard::emergencyStop() {
  counts_.stopped += stopped_ ? 0 : 1;
  stopped_ = true;
}

void ForceGuard::displace() {
  counts_.displaced += displaced_ ? 0 : 1;
  displaced_ = true;
}

void ForceGuard::riseAnew() {
  running_ = false;
  gain_ = output_N_ = 0;
  good_ = 0;
}

void ForceGuard::latch(ForceHalt reason) {
  if (latched_ == ForceHalt::none) latched_ = reason;
}

void ForceGuard::home() {
  displaced_ = false;
  riseAnew();
  forgetPlace();
}

void ForceGuard::rearm() {
  home();
  stopped_ = false;
  latched_ = ForceHalt::none;
  uncounted_s_ = 0;
  believed_ = 1;
  resisting_ = false;
  stalledAt_s_ = longAgo_s;
  dropOuts_s_.fill(longAgo_s);
}

ForceHalt ForceGuard::halt() const {
  if (stopped_) return ForceHalt::stopped;
  if (latched_ != ForceHalt::none) return latched_;
  if (displaced_) return ForceHalt::displaced;
  return held_ ? ForceHalt::none : ForceHalt::notHeld;
}

void ForceGuard::countDropOut() {
  double& oldest_s = dropOuts_s_[counts_.faded % dropOuts_s_.size()];
  if (time_s_ - oldest_s <= dropOutWindow_s) latch(ForceHalt::dropOuts);
  oldest_s = time_s_;
}

bool ForceGuard::droppedOutLately() const {
  return std::ranges::any_of(dropOuts_s_, [&](double at_s) { return time_s_ - at_s <= thrown_s; });
}

bool ForceGuard::pausedLately() const { return time_s_ - stalledAt_s_ <= thrown_s; }

bool ForceGuard::mayRise() const {
  return started_ && !stopping_ && !tooFast_ && halt() == ForceHalt::none && bad_ <= held() &&
         (running_ || (speedKnown_ && good_ > limits_.heldReadings));
}

// A finger that lost its force throws the handle far beyond the travel. A force that came back there would
// throw it out again.
void ForceGuard::haltThrown() {
  if (!mayRise() || running_ || !std::exchange(interrupted_, false)) return;
  if (last_mm_ <= limits_.travelEnd_mm + farBeyond_mm) return;
  if (droppedOutLately()) {
    latch(ForceHalt::dropOuts);
  } else {
    displace();
  }
}

void ForceGuard::moveGain() {
  haltThrown();
  if (mayRise()) {
    running_ = true;
    gain_ = std::min(1.0, gain_ + period_s_ / limits_.startRamp_s);
    return;
  }
  if (running_ && (bad_ > held() || displaced_)) {
    ++counts_.faded;
    interrupted_ = true;
    countDropOut();
  }
  running_ = false;
  gain_ -= period_s_ / (stopped_ || !held_ ? limits_.emergencyRamp_s : limits_.stopRamp_s);
  if (gain_ < 1e-9) gain_ = 0;
}

/// Reduces the force while the encoder does not count. Under a hand that holds still, a working encoder
/// changes as soon as the force does.
double ForceGuard::watchedCount(double force_N) {
  const bool watched = std::abs(force_N) > limits_.deadCountAbove_N && last_mm_ > limits_.deadCountFrom_mm;
  const bool stoppedDead = moved_mm_ == 0 && frozen(force_N);
  const double before_s = uncounted_s_;
  uncounted_s_ = moved_mm_ != 0 || (!watched && !stoppedDead) ? 0 : uncounted_s_ + elapsed_s_;
  if (stoppedDead) {
    ++counts_.frozen;
    believed_ = std::max(0.0, believed_ - elapsed_s_ / frozenRamp_s);
  } else if (uncounted_s_ >= uncountedFor_s) {
    counts_.probed += before_s < uncountedFor_s ? 1 : 0;
    believed_ = std::max(0.0, believed_ - elapsed_s_ / probe_s);
  } else if (running_) {  // a force that is fading out must not come back
    believed_ = std::min(1.0, believed_ + elapsed_s_ / probed_s);
  }
  if (believed_ == 0 && watched && uncounted_s_ >= uncountedFor_s + probe_s + withoutForce_s)
    latch(ForceHalt::deadCount);
  return believed_ * force_N;
}

void ForceGuard::watchRunaway(std::optional<double> velocity_mm_per_s) {
  const double most_N = gain_ * limits_.force_N, against = std::copysign(1.0, output_N_);
  const bool whole = std::abs(output_N_) >= std::max(leastResisting_N, wholeShare * most_N);
  const double beyond_mm = last_mm_ - limits_.travelEnd_mm;
  if (!whole && !(beyond_mm > 0 && output_N_ > leastResisting_N)) {
    resisting_ = false;
    return;
  }
  const double read_mm_per_s = elapsed_s_ > 0 ? moved_mm_ / elapsed_s_ : 0;
  // Two readings give a speed only as accurately as they are timed; a late reading would appear as energy
  // that the handle brought with it.
  const double speed_mm_per_s = against * velocity_mm_per_s.value_or(read_mm_per_s);
  const double now_mJ = speed_mm_per_s > 0 ? kinetic_mJ(limits_.movedMass_kg, speed_mm_per_s) : 0;
  if (!resisting_) {
    resisting_ = true;
    resisted_mJ_ = beyond_s_ = pinned_s_ = fastest_mm_per_s_ = 0;
    entered_mJ_ = now_mJ;
  }
  resisted_mJ_ += output_N_ * moved_mm_;
  fastest_mm_per_s_ = std::max(fastest_mm_per_s_, speed_mm_per_s);
  const bool far = whole && output_N_ > 0 && beyond_mm > farBeyond_mm;
  pinned_s_ = far && speed_mm_per_s > -comingBack_mm_per_s ? pinned_s_ + elapsed_s_ : 0;
  beyond_s_ = far && speed_mm_per_s > slowing * fastest_mm_per_s_ ? beyond_s_ + elapsed_s_ : 0;
  const double gained_mJ = now_mJ - entered_mJ_;
  const bool gained = resisted_mJ_ >= runawayWork_mJ &&
                      gained_mJ >= (whole ? gainedAtLimit : gainedBeyond) * resisted_mJ_ &&
                      (beyond_mm > 0 || gained_mJ >= leastGain_mJ);
  if (!gained && beyond_s_ < notSlowingFor_s && pinned_s_ < pinnedFor_s) return;
  // A force that came and went, or a pause, has thrown the handle there.
  if (droppedOutLately()) {
    latch(ForceHalt::dropOuts);
  } else if (pausedLately()) {
    displace();
  } else {
    latch(ForceHalt::runaway);
  }
  riseAnew();  // without delay, because each millisecond of such a force adds speed
}

double ForceGuard::limit(double force_N, std::optional<double> velocity_mm_per_s) {
  speedKnown_ = velocity_mm_per_s.has_value();
  const double speed_mm_per_s = std::abs(velocity_mm_per_s.value_or(std::nan("")));
  if (!tooFast_ && speed_mm_per_s > limits_.speed_mm_per_s) {
    tooFast_ = true;
    ++counts_.tooFast;
  } else if (tooFast_ && speed_mm_per_s < calmShare * limits_.speed_mm_per_s) {
    tooFast_ = false;
  }
  if (bad_ == 0) watchRunaway(velocity_mm_per_s);
  moveGain();
  if (gain_ == 0 || !std::isfinite(force_N)) return output_N_ = 0;
  if (std::abs(force_N) > limits_.force_N) {
    force_N = std::copysign(limits_.force_N, force_N);
    ++counts_.forceLimited;
  }
  double wanted_N = gain_ * force_N;
  wanted_N = watchedCount(wanted_N);
  const double largestChange_N = limits_.slew_N_per_s * period_s_;
  const double change_N = wanted_N - output_N_;
  if (std::abs(change_N) > largestChange_N) {
    wanted_N = output_N_ + std::copysign(largestChange_N, change_N);
    ++counts_.slewLimited;
  }
  const double most_N = gain_ * limits_.force_N;  // a low slew limit must not keep a force that has to vanish
  return output_N_ = std::clamp(wanted_N, -most_N, most_N);
}

}  // namespace detent::playback
