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

ReadingVerdict ForceGuard::verdictOn(double position_mm, bool fresh) const {
  // A finger may have gone on while readings were bad.
  const double reach_mm = limits_.speed_mm_per_s * period_s_ * 2 * (1.0 + bad_);
  if (!fresh) return ReadingVerdict::missing;
  if (!std::isfinite(position_mm)) return ReadingVerdict::notFinite;
  if (position_mm < limits_.lowest_mm || position_mm > limits_.highest_mm ||
      (started_ && std::abs(position_mm - last_mm_) > reach_mm)) {
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

ReadingVerdict ForceGuard::judge(double position_mm, bool fresh) {
  const ReadingVerdict verdict = verdictOn(position_mm, fresh);
  count(verdict);
  if (verdict == ReadingVerdict::good) {
    follow(position_mm);
    bad_ = 0;
    if (good_ <= limits_.heldReadings) ++good_;
  } else {
    good_ = 0;
    bad_ += bad_ < std::numeric_limits<std::uint32_t>::max() ? 1 : 0;
  }
  return verdict;
}

bool ForceGuard::mayRise() const {
  return started_ && !stopping_ && !tooFast_ && bad_ <= limits_.heldReadings &&
         (running_ || good_ > limits_.heldReadings);
}

void ForceGuard::moveGain() {
  if (mayRise()) {
    running_ = true;
    gain_ = std::min(1.0, gain_ + period_s_ / limits_.startRamp_s);
    return;
  }
  if (running_ && bad_ > limits_.heldReadings) ++counts_.faded;
  running_ = false;
  gain_ = gain_ - period_s_ / limits_.stopRamp_s;
  if (gain_ < 1e-9) gain_ = 0;
}

double ForceGuard::limit(double force_N, double velocity_mm_per_s) {
  const double speed_mm_per_s = std::abs(velocity_mm_per_s);
  if (!tooFast_ && speed_mm_per_s > limits_.speed_mm_per_s) {
    tooFast_ = true;
    ++counts_.tooFast;
  } else if (tooFast_ && speed_mm_per_s < calmShare * limits_.speed_mm_per_s) {
    tooFast_ = false;
  }
  moveGain();
  if (gain_ == 0 || !std::isfinite(force_N)) return output_N_ = 0;
  double wanted_N = gain_ * force_N;
  if (std::abs(wanted_N) > limits_.force_N) {
    wanted_N = std::copysign(limits_.force_N, wanted_N);
    ++counts_.forceLimited;
  }
  const double largestChange_N = limits_.slew_N_per_s * period_s_;
  const double change_N = wanted_N - output_N_;
  if (running_ && std::abs(change_N) > largestChange_N) {
    wanted_N = output_N_ + std::copysign(largestChange_N, change_N);
    ++counts_.slewLimited;
  }
  return output_N_ = wanted_N;
}

}  // namespace detent::playback
