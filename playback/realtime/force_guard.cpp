// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_guard.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace detent::playback {

namespace {

// After too fast a movement the device must have slowed to this share of the limit before force comes back.
constexpr double calmShare = 0.5;

// Frozen: so far within so short a time, then not one step for so long, under a force that could surprise. The turn of a finger on
// the steepest wall keeps within 38 um for 5 ms and has gone 0.3 mm in the 4 ms before; with 0.4 mm, 8 of 10,000 presses at 1 m/s
// passed for broken.
constexpr double swiftWay_mm = 1, swiftSteps = 5, swift_s = 0.004, deadStill_s = 0.010, dangerous_N = 1;

// No stroke is longer than this unseen: a device that comes back farther away is somewhere else.
constexpr double longestUnseen_mm = 10;
// A late or early reading of a steady movement; an encoder's noise; a stop's rebound.
constexpr double hasteOfPace = 1.5, reboundOfPace = 0.4, noiseSteps = 3;
// An encoder that flickers is as bad as one that jumps: so many absurd readings within about this time.
constexpr double mostJumps = 2.5, jumpMemory_s = 0.05;
constexpr double longestHold_s = 0.003;

}  // namespace

ForceGuard::ForceGuard(const ForceLimits& limits, double period_s, double step_mm)
    : limits_(limits), period_s_(period_s), step_mm_(step_mm) {}

void ForceGuard::setLimits(const ForceLimits& limits, double period_s, double step_mm) {
  limits_ = limits;
  period_s_ = period_s;
  step_mm_ = step_mm;
}

// A hand that stops, or a wall, slows the handle down first; only a broken encoder goes on at one value.
bool ForceGuard::frozenAt(double position_mm) const {
  return position_mm == last_mm_ && way_mm_ >= std::max(swiftWay_mm, swiftSteps * step_mm_) &&
         (unchanged_ + 1) * period_s_ >= deadStill_s && std::abs(output_N_) >= (bad_ == 0 ? dangerous_N : 0);
}

std::uint32_t ForceGuard::held() const {
  return std::min(limits_.heldReadings, static_cast<std::uint32_t>(longestHold_s / period_s_ + 1e-6));
}

// A movement goes on with its pace, may gain speed as fast as the limit says, may stop at once, and turns no faster than it gains. Bad readings
// that say nothing give it time to gain more; those that jump give it none, and what goes on from a jump belongs to the jump.
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
  return frozenAt(position_mm) ? ReadingVerdict::frozen : ReadingVerdict::good;
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
    case ReadingVerdict::frozen:
      ++counts_.frozen;
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
  if (started_)
    way_mm_ =
        way_mm_ * std::exp(-(unchanged_ + 1.0) * period_s_ / swift_s) + std::abs(position_mm - last_mm_);
  unchanged_ = 0;
  last_mm_ = position_mm;
  started_ = true;
}

void ForceGuard::followJumps(ReadingVerdict verdict, double position_mm, double periods) {
  jumps_ *= std::exp(-periods * period_s_ / jumpMemory_s);
  if (verdict == ReadingVerdict::absurd) {
    if (settling()) return forgetPlace();  // no force has come of it: another place is taken on trust
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
  since_ += periods;
  unseen_ += std::max(0.0, periods - 1);  // a loop that was late saw nothing meanwhile
  const ReadingVerdict verdict = verdictOn(position_mm, fresh);
  count(verdict);
  if (verdict == ReadingVerdict::good) {
    if (started_ && since_ > 0) pace_mm_ = (position_mm - last_mm_) / since_;
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
  started_ = false;
  settled_ = unchanged_ = 0;
  pace_mm_ = since_ = unseen_ = jumps_ = way_mm_ = 0;
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

void ForceGuard::home() {
  displaced_ = running_ = false;
  gain_ = output_N_ = 0;
  good_ = 0;
  forgetPlace();
}

void ForceGuard::rearm() {
  home();
  stopped_ = false;
}

ForceHalt ForceGuard::halt() const {
  if (stopped_) return ForceHalt::stopped;
  if (displaced_) return ForceHalt::displaced;
  return held_ ? ForceHalt::none : ForceHalt::notHeld;
}

bool ForceGuard::mayRise() const {
  return started_ && !stopping_ && !tooFast_ && halt() == ForceHalt::none && bad_ <= held() &&
         (running_ || (speedKnown_ && good_ > limits_.heldReadings));
}

void ForceGuard::moveGain() {
  if (mayRise()) {
    running_ = true;
    gain_ = std::min(1.0, gain_ + period_s_ / limits_.startRamp_s);
    return;
  }
  if (running_ && (bad_ > held() || displaced_)) ++counts_.faded;
  running_ = false;
  gain_ -= period_s_ / (stopped_ || !held_ ? limits_.emergencyRamp_s : limits_.stopRamp_s);
  if (gain_ < 1e-9) gain_ = 0;
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
  moveGain();
  if (gain_ == 0 || !std::isfinite(force_N)) return output_N_ = 0;
  if (std::abs(force_N) > limits_.force_N) {
    force_N = std::copysign(limits_.force_N, force_N);
    ++counts_.forceLimited;
  }
  double wanted_N = gain_ * force_N;
  const double largestChange_N = limits_.slew_N_per_s * period_s_;
  const double change_N = wanted_N - output_N_;
  if (std::abs(change_N) > largestChange_N) {
    wanted_N = output_N_ + std::copysign(largestChange_N, change_N);
    ++counts_.slewLimited;
  }
  const double most_N = gain_ * limits_.force_N;  // a slow slew keeps no force that has to go
  return output_N_ = std::clamp(wanted_N, -most_N, most_N);
}

}  // namespace detent::playback
