// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/loop_limit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "playback/realtime/velocity_estimator.h"

namespace detent::playback {

namespace {

constexpr double mmPerM = 1000;
constexpr double flattest_N_per_mm = 1e-3;
constexpr int halvings = 14;          // bisections of a range of six decades, to 0.1 %
constexpr double usableShare = 0.92;  // share of the limit found, because encoder steps are left out
constexpr double timing_s =
    10e-6;  // allowance for the error of the measured delay (identify-device: 19 µs at worst)
constexpr double start_mm = 1, escaped_mm = 100;  // the loop is linear, so only their ratio matters
constexpr double settled_s = 0.3,
                 watched_s = 0.4;               // stable if the amplitude stays below the start until then
constexpr double perRadian = 50;                // time steps per radian of an oscillation
constexpr int fewestSteps = 8, mostSteps = 64;  // time steps per period of the law

double latest_s(const ForceDeviceProfile& device) {
  return device.delay_s + std::max(timing_s, device.jitter_s);
}

/// A handle on a spring of the law, released 1 mm beside its rest.
class Swing {
 public:
  Swing(const ForceDeviceProfile& device, double rate_Hz, double slope_N_per_mm, double damping_Ns_per_mm)
      : device_(device),
        period_s_(1 / rate_Hz),
        slope_N_per_mm_(slope_N_per_mm),
        damping_Ns_per_mm_(damping_Ns_per_mm),
        lead_s_(0.5 * period_s_ + device.late_s()),
        swing_rad_per_s_(std::sqrt(slope_N_per_mm * mmPerM / device.mass_kg)),
        steps_(static_cast<int>(std::clamp(std::ceil(period_s_ * swing_rad_per_s_ * perRadian),
                                           1.0 * fewestSteps, 1.0 * mostSteps))),
        step_s_(period_s_ / steps_),
        velocity_(VelocityMethod::kalman, period_s_, device.step_mm),
        late_(static_cast<std::size_t>(latest_s(device) / step_s_) + 2, slope_N_per_mm),
        laterShare_(latest_s(device) / step_s_ - static_cast<double>(late_.size() - 2)),
        motor_N_(slope_N_per_mm),
        follows_(device.lag_s > 0 ? 1 - std::exp(-step_s_ / device.lag_s) : 1),
        meanShare_(device.lag_s > 0 ? follows_ * device.lag_s / step_s_ : 0),
        resists_(0.5 * device.damping_Ns_per_mm * mmPerM * step_s_ / device.mass_kg) {
    velocity_.restart(position_mm_);
  }

  bool calmsDown() {
    const auto settled = static_cast<long>(std::ceil(settled_s / period_s_)),
               end = static_cast<long>(std::ceil(watched_s / period_s_)) + 1;
    for (long i = 0; i < end; ++i) {
      const double farthest_mm = onePeriod();
      if (!(farthest_mm < escaped_mm)) return false;
      if (i >= settled && farthest_mm >= start_mm) return false;
    }
    return true;
  }

 private:
  /// Amplitude of the oscillation in one period.
  double onePeriod() {
    const double estimate_mm_per_s = velocity_.update(position_mm_);
    const double sent_N = slope_N_per_mm_ * (position_mm_ + lead_s_ * estimate_mm_per_s) +
                          damping_Ns_per_mm_ * estimate_mm_per_s;
    double farthest_mm = 0;
    for (int i = 0; i < steps_; ++i) {
      late_[newest_] = sent_N;
      newest_ = (newest_ + 1) % late_.size();
      const double oldest_N = late_[newest_], next_N = late_[(newest_ + 1) % late_.size()];
      move(std::lerp(next_N, oldest_N, laterShare_));
      farthest_mm = std::max(farthest_mm, std::abs(position_mm_));
    }
    return farthest_mm;
  }

  /// Advances one time step under the arriving force. The method is of second order, because otherwise half a
  /// step would count as delay.
  void move(double arrives_N) {
    const double mean_N = arrives_N + meanShare_ * (motor_N_ - arrives_N);
    motor_N_ += follows_ * (arrives_N - motor_N_);
    const double before_mm_per_s = velocity_mm_per_s_;
    velocity_mm_per_s_ =
        (before_mm_per_s * (1 - resists_) - step_s_ * mean_N * mmPerM / device_.mass_kg) / (1 + resists_);
    position_mm_ += 0.5 * step_s_ * (before_mm_per_s + velocity_mm_per_s_);
  }

  const ForceDeviceProfile& device_;
  double period_s_, slope_N_per_mm_, damping_Ns_per_mm_, lead_s_, swing_rad_per_s_;
  int steps_;
  double step_s_;
  VelocityEstimator velocity_;
  std::vector<double> late_;  // forces under way, one per time step
  double laterShare_;         // share of the step in which a force arrives that lies before its arrival
  std::size_t newest_ = 0;
  double position_mm_ = start_mm, velocity_mm_per_s_ = 0, motor_N_;
  double follows_, meanShare_,
      resists_;  // decay of the lag within one step, at its end and on average; factor of the damping
};

bool calmsDown(const ForceDeviceProfile& device, double rate_Hz, double slope_N_per_mm,
               double damping_Ns_per_mm) {
  return Swing(device, rate_Hz, slope_N_per_mm, damping_Ns_per_mm).calmsDown();
}

}  // namespace

double loopLimit_N_per_mm(const ForceDeviceProfile& device, double rate_Hz, double damping_Ns_per_mm) {
  double calm = flattest_N_per_mm, swinging = device.largestSlope_N_per_mm / usableShare;
  if (swinging <= calm || calmsDown(device, rate_Hz, swinging, damping_Ns_per_mm))
    return device.largestSlope_N_per_mm;
  if (!calmsDown(device, rate_Hz, calm, damping_Ns_per_mm)) return 0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(calm * swinging);
    (calmsDown(device, rate_Hz, middle, damping_Ns_per_mm) ? calm : swinging) = middle;
  }
  return usableShare * calm;
}

LoopLimits::LoopLimits(const ForceDeviceProfile& device, double rate_Hz, double low_Ns_per_mm,
                       double high_Ns_per_mm)
    : low_Ns_per_mm_(low_Ns_per_mm), high_Ns_per_mm_(high_Ns_per_mm) {
  constexpr int pieces = 8;
  if (high_Ns_per_mm <= low_Ns_per_mm) {
    limits_N_per_mm_ = {loopLimit_N_per_mm(device, rate_Hz, low_Ns_per_mm)};
    return;
  }
  for (int i = 0; i <= pieces; ++i)
    limits_N_per_mm_.push_back(loopLimit_N_per_mm(
        device, rate_Hz, std::lerp(low_Ns_per_mm, high_Ns_per_mm, static_cast<double>(i) / pieces)));
}

double LoopLimits::at_N_per_mm(double damping_Ns_per_mm) const {
  const std::size_t last = limits_N_per_mm_.size() - 1;
  if (last == 0) return limits_N_per_mm_.front();
  const double share = (damping_Ns_per_mm - low_Ns_per_mm_) / (high_Ns_per_mm_ - low_Ns_per_mm_);
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(last);
  const auto piece = std::min(static_cast<std::size_t>(place), last - 1);
  return std::lerp(limits_N_per_mm_[piece], limits_N_per_mm_[piece + 1], place - static_cast<double>(piece));
}

double LoopLimits::least_N_per_mm() const { return *std::ranges::min_element(limits_N_per_mm_); }

}  // namespace detent::playback
