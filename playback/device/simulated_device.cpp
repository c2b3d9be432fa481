// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace detent::playback {

namespace {

constexpr double longestSubstep_s = 40e-6;
constexpr double simulatedMmPerM = 1000;

}  // namespace

SimulatedForceDevice::SimulatedForceDevice(const SimulatedDeviceSettings& settings, SimulatedFinger finger)
    : settings_(settings), finger_(std::move(finger)), position_mm_(settings.start_mm) {
  substeps_ = static_cast<std::size_t>(std::ceil(settings.period_s / longestSubstep_s - 1e-9));
  dt_s_ = settings.period_s / static_cast<double>(substeps_);
  delaySubsteps_ = static_cast<std::size_t>(std::lround(settings.delay_s / dt_s_));
  lagKept_ = settings.lag_s > 0 ? std::exp(-dt_s_ / settings.lag_s) : 0;
  waiting_N_.assign(delaySubsteps_ / substeps_ + 2, 0.0);
}

double SimulatedForceDevice::stepped_mm() const {
  return std::round(position_mm_ / settings_.step_mm) * settings_.step_mm;
}

ForceReading SimulatedForceDevice::exchange(const ForceCommand& command) {
  newest_ = (newest_ + 1) % waiting_N_.size();
  waiting_N_[newest_] = std::clamp(command.force_N, -settings_.force_N, settings_.force_N);
  for (std::size_t i = 0; i < substeps_; ++i) {
    const std::size_t periodsAgo = (delaySubsteps_ + substeps_ - 1 - i) / substeps_;
    const double requested_N = waiting_N_[(newest_ + waiting_N_.size() - periodsAgo) % waiting_N_.size()];
    lagged_N_ = requested_N + lagKept_ * (lagged_N_ - requested_N);
    advance(lagged_N_);
  }
  ForceReading reading;
  reading.position_mm = stepped_mm();
  return reading;
}

// Coulomb friction as an implicit step: it removes at most the present speed, so a device at rest stays at
// rest without chatter.
void SimulatedForceDevice::advance(double motor_N) {
  const double finger_N = finger_.push_N(position_mm_, velocity_mm_per_s_, dt_s_);
  const double perNewton = simulatedMmPerM * dt_s_ / settings_.mass_kg;
  double velocity =
      (velocity_mm_per_s_ + perNewton * (finger_N - motor_N)) / (1 + perNewton * settings_.damping_Ns_per_mm);
  const double friction = perNewton * settings_.friction_N;
  velocity = std::abs(velocity) <= friction ? 0 : velocity - std::copysign(friction, velocity);
  const double moved_mm = velocity * dt_s_;
  position_mm_ += moved_mm;
  if (position_mm_ < settings_.lowest_mm || position_mm_ > settings_.highest_mm) {
    position_mm_ = std::clamp(position_mm_, settings_.lowest_mm, settings_.highest_mm);
    velocity = 0;
  }
  fingerWork_mJ_ += finger_N * moved_mm;
  velocity_mm_per_s_ = velocity;
}

}  // namespace detent::playback
