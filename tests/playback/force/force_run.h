// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A simulated finger on a simulated device that renders a button, for the force tests.

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "playback/device/simulated_device.h"
#include "playback/prepare/prepare_force.h"

namespace detent::test {

inline playback::PreparedForce forceOf(const Button& button, const playback::ForceDeviceProfile& device,
                                       const playback::ForceSettings& settings = {}) {
  Result<playback::PreparedForce> prepared = playback::prepareForce(button, device, settings);
  if (!prepared) throw std::runtime_error(prepared.failure().sentence());
  return *std::move(prepared);
}

inline playback::SimulatedDeviceSettings simulationOf(const playback::ForceDeviceProfile& p,
                                                      const playback::PreparedForce& prepared) {
  playback::SimulatedDeviceSettings s;
  s.mass_kg = p.mass_kg;
  s.friction_N = p.friction_N;
  s.damping_Ns_per_mm = p.damping_Ns_per_mm;
  s.step_mm = p.step_mm;
  s.period_s = prepared.program.period_s;
  s.start_mm = prepared.summary.rest_mm;
  s.delay_s = p.delay_s;
  s.force_N = p.limits.force_N;
  return s;
}

/// A whole run, step for step.
class ForceRun {
 public:
  ForceRun(const playback::PreparedForce& prepared, const playback::ForceDeviceProfile& device,
           const playback::FingerPlan& plan, const playback::FingerMechanics& mechanics = {})
      : program_(prepared.program),
        device_(simulationOf(device, prepared), playback::SimulatedFinger(mechanics, plan)),
        engine_(program_) {}

  void run(double seconds, const std::function<void(const playback::ForceStep&)>& each = {}) {
    const auto steps = static_cast<int>(seconds / program_.period_s + 0.5);
    for (int i = 0; i < steps; ++i) {
      command_ = engine_.step(device_.exchange(command_));
      leastFingerWork_mJ_ = std::min(leastFingerWork_mJ_, device_.fingerWork_mJ());
      if (each) each(engine_.last());
    }
  }

  const playback::ForceEngine& engine() const { return engine_; }
  const playback::SimulatedForceDevice& device() const { return device_; }
  /// Least net work of the finger at any time (mJ): below 0 it got back more than it gave.
  double leastFingerWork_mJ() const { return leastFingerWork_mJ_; }

 private:
  playback::ForceProgram program_;
  playback::SimulatedForceDevice device_;
  playback::ForceEngine engine_;
  playback::ForceCommand command_;
  double leastFingerWork_mJ_ = 0;
};

/// Statistics of how steady a series of values is.
class Quiet {
 public:
  void add(double position_mm, double force_N) {
    low_mm_ = count_ == 0 ? position_mm : std::min(low_mm_, position_mm);
    high_mm_ = count_ == 0 ? position_mm : std::max(high_mm_, position_mm);
    if (count_ > 0) jump_N_ = std::max(jump_N_, std::abs(force_N - before_N_));
    before_N_ = force_N;
    ++count_;
    const double off_N = force_N - mean_N_;
    mean_N_ += off_N / count_;
    squares_ += off_N * (force_N - mean_N_);
  }
  double peakToPeak_mm() const { return high_mm_ - low_mm_; }
  double rms_N() const { return count_ == 0 ? 0 : std::sqrt(squares_ / count_); }
  double largestJump_N() const { return jump_N_; }

 private:
  int count_ = 0;
  double low_mm_ = 0, high_mm_ = 0, before_N_ = 0, mean_N_ = 0, squares_ = 0, jump_N_ = 0;
};

}  // namespace detent::test
