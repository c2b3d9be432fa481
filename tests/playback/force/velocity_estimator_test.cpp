// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/velocity_estimator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

namespace {

using namespace detent::playback;

/// The movement of the figures: 4 mm in 100 ms, minimum jerk (peak 75 mm/s).
double position_mm(double time_s) {
  const double s = std::min(1.0, time_s / 0.1);
  return 4 * s * s * s * (10 + s * (6 * s - 15));
}
double velocity_mm_per_s(double time_s) {
  if (time_s >= 0.1) return 0;
  const double s = time_s / 0.1;
  return 4 * 30 * s * s * (1 - s) * (1 - s) / 0.1;
}
/// Readings as the engine hands them on: steps whose flicker is taken out (force_engine.h).
class Encoder {
 public:
  Encoder(double step_mm, double offset_mm) : step_mm_(step_mm), offset_mm_(offset_mm) {
    steady_mm_ = stepped(0);
  }
  double read(double value_mm) {
    const double half_mm = 0.5 * step_mm_ * (1 + 1e-9), at_mm = stepped(value_mm);
    return steady_mm_ = std::max(at_mm - half_mm, std::min(at_mm + half_mm, steady_mm_));
  }

 private:
  double stepped(double value_mm) const { return std::round((value_mm + offset_mm_) / step_mm_) * step_mm_; }
  double step_mm_, offset_mm_, steady_mm_ = 0;
};

struct Errors {
  double moving = 0, resting = 0;
};

/// Over twenty places of the movement between the encoder's steps.
Errors errorsOf(VelocityMethod method, double step_mm) {
  double moving = 0, resting = 0;
  for (int place = 0; place < 20; ++place) {
    VelocityEstimator estimator(method, 0.001, step_mm);
    Encoder encoder(step_mm, step_mm * place / 20);
    estimator.restart(encoder.read(0));
    for (int k = 1; k <= 100; ++k) {
      const double off =
          estimator.update(encoder.read(position_mm(k * 0.001))) - velocity_mm_per_s(k * 0.001);
      moving += off * off;
    }
    for (int k = 0; k < 200; ++k) estimator.update(encoder.read(4));
    for (int k = 0; k < 1000; ++k) {
      const double off =
          estimator.update(encoder.read(4 + 0.006 * std::sin(2 * std::numbers::pi * 9 * k * 0.001)));
      resting += off * off;
    }
  }
  return {std::sqrt(moving / 2000), std::sqrt(resting / 20000)};
}

}  // namespace

TEST_CASE("velocity: a finger's press at 10 µm and 1 kHz") {
  const Errors kalman = errorsOf(VelocityMethod::kalman, 0.01),
               difference = errorsOf(VelocityMethod::difference, 0.01);
  CHECK(kalman.moving <= 2.5);
  CHECK(kalman.resting <= 0.6);
  CHECK(difference.moving > 1.5 * kalman.moving);
  CHECK(errorsOf(VelocityMethod::foaw, 0.01).resting <= 0.3);
}

TEST_CASE("velocity: nothing is left at rest, and a steady movement is measured exactly") {
  for (const VelocityMethod method :
       {VelocityMethod::kalman, VelocityMethod::foaw, VelocityMethod::difference}) {
    VelocityEstimator estimator(method, 0.001, 0.01);
    estimator.restart(0);
    double velocity = 0;
    for (int k = 1; k <= 400; ++k) velocity = estimator.update(0.05 * k);
    CHECK(velocity == Approx(50).epsilon(0.001));
    for (int k = 0; k < 3000; ++k) velocity = estimator.update(20);
    CHECK(std::abs(velocity) < 0.01);
  }
}
