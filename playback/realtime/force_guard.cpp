// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_guard.h"

#include <algorithm>
#include <cmath>

namespace detent::playback {

namespace {

// After too fast a movement the device must have slowed to this share of the limit before force comes back.
constexpr double calmShare = 0.5;

}  // namespace

ForceGuard::ForceGuard(const ForceLimits& limits, double period_s) : limits_(limits), period_s_(period_s) {}

ReadingVerdict ForceGuard::judge(double position_mm, bool fresh) {
  ++counts_.readings;
  ReadingVerdict verdict = ReadingVerdict::good;
  // A finger may have gone on while readings were bad.
  const double reach_mm = limits_.speed_mm_per_s * period_s_ * 2 * (1.0 + bad_);
  if (!fresh) {
    verdict = ReadingVerdict::missing;
    ++counts_.missing;
  } else if (!std::isfinite(position_mm)) {
    verdict = ReadingVerdict::notFinite;
    ++counts_.notFinite;
  } else if (position_mm < limits_.lowest_mm || position_mm > limits_.highest_mm ||
             (started_ && std::abs(position_mm - last_mm_) > reach_mm)) {
    verdict = ReadingVerdict::absurd;
    ++counts_.absurd;
  }
  if (verdict == ReadingVerdict::good) {
    last_mm_ = position_mm;
    started_ = true;
    bad_ = 0;
    if (good_ <= limits_.heldReadings) ++good_;
  } else {
    good_ = 0;
    ++bad_;
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
