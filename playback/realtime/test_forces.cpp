// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/test_forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace detent::playback {

namespace {

// The relay's pushes increase until one has moved the handle this far, then by this much more, because a push
// that barely moves it is too weak.
constexpr double firstPush_N = 0.04, growth = 1.4, growth_N_per_s = 0.8;
constexpr double movedBy_mm = 0.3, moreThanFriction = 3, least_N = 0.25;
constexpr double push_s = 0.04, pushPeriods = 3;
// A movement against the push counts from this distance on.
constexpr double opposedBy_mm = 0.05, opposedSteps = 4;
// Speeds between the slowest and the fastest, in a mixed order.
constexpr std::array<double, 5> speedShares{0.0, 1.0, 0.4, 0.1, 0.7};
// A weak spring of this frequency keeps the chirp in the middle. It predicts by this time, so that its own
// delay causes no oscillation.
constexpr double keeping_Hz = 3, keepingLead_s = 0.08;
constexpr double moreThanFrictionShaking = 3, fadeIn_s = 0.4;
// Beyond this share of the half range, more force is used for turning, or less speed.
constexpr double mostBeyond = 0.8, stronger = 1.02, slower = 0.99;
constexpr double mPerMm = 1e-3;

double square(double x) { return x * x; }

}  // namespace

double TestForces::step_N(double position_mm, double velocity_mm_per_s) {
  if (!begun_) {
    direction_ = position_mm < excitation_.middle_mm ? 1 : -1;
    sense_ = -direction_;
  }
  begun_ = true;
  time_s_ += period_s_;
  const double force_N = excitation_.kind == ForceExcitation::Kind::relay
                             ? relay_N(position_mm, velocity_mm_per_s)
                             : chirp_N(position_mm, velocity_mm_per_s);
  if (reversed_ || unmoved_) return 0;
  return std::clamp(force_N, -excitation_.largest_N, excitation_.largest_N);
}

void TestForces::beginPush(double position_mm) {
  relay_N_ = relay_N_ == 0 ? firstPush_N : growth * relay_N_;
  sense_ = -sense_;
  from_mm_ = position_mm;
  pushed_s_ = 0;
}

// Alternating pushes in and out, each stronger than the last and each braked by an equally long opposite one,
// so that a free handle with a dead encoder stays about where it is. Once the encoder has counted: one push
// that increases until the handle follows.
double TestForces::firstMove_N(double position_mm) {
  const double most_N = excitation_.largest_N, part_s = std::max(push_s, pushPeriods * period_s_);
  if (relay_N_ == 0) beginPush(position_mm);
  if (!counted_ && position_mm != from_mm_) {
    counted_ = true;
    if (pushed_s_ > part_s) from_mm_ = position_mm;
  }
  if (counted_) {
    relay_N_ += growth_N_per_s * period_s_;
  } else {
    pushed_s_ += period_s_;
    if (pushed_s_ > 2 * part_s) {
      strongest_ += relay_N_ >= most_N ? 1 : 0;
      unmoved_ = strongest_ == 2;  // the handle moved in neither direction
      if (unmoved_) return 0;
      beginPush(position_mm);
    }
  }
  const double strength_N = std::min(relay_N_, most_N), followed_mm = sense_ * (position_mm - from_mm_);
  if (!counted_ && pushed_s_ > part_s) return sense_ * strength_N;
  reversed_ = reversed_ || followed_mm < -std::max(opposedBy_mm, opposedSteps * step_mm_);
  moving_ = followed_mm > std::max(movedBy_mm, 0.1 * excitation_.half_mm);
  if (moving_) relay_N_ = std::max(moreThanFriction * relay_N_, least_N);
  return -sense_ * strength_N;
}

// Adjusts force and speed for a heavy handle, which turns late.
void TestForces::keepInside(double beyond_mm) {
  if (beyond_mm < mostBeyond * excitation_.half_mm) return;
  if (relay_N_ < excitation_.largest_N) {
    relay_N_ *= stronger;
  } else {
    fastest_mm_per_s_ = std::max(excitation_.slowest_mm_per_s, slower * fastest_mm_per_s_);
  }
}

// Accelerates to the speed of this turn, coasts, and turns beyond half of the range; if friction has slowed
// the handle down, pushes again.
double TestForces::relay_N(double position_mm, double velocity_mm_per_s) {
  if (!moving_) return firstMove_N(position_mm);
  const double strength_N = std::min(relay_N_, excitation_.largest_N);
  const double seen_mm = position_mm + velocity_mm_per_s * excitation_.lead_s;
  if (direction_ * (seen_mm - excitation_.middle_mm) > excitation_.half_mm) {
    direction_ = -direction_;
    ++turns_;
  }
  if (turns_ > 0) keepInside(-direction_ * (position_mm - excitation_.middle_mm) - excitation_.half_mm);
  const double share = speedShares[turns_ % speedShares.size()];
  const double wanted_mm_per_s =
      excitation_.slowest_mm_per_s + share * (fastest_mm_per_s_ - excitation_.slowest_mm_per_s);
  return direction_ * velocity_mm_per_s < wanted_mm_per_s ? -direction_ * strength_N : 0.0;
}

double TestForces::chirp_N(double position_mm, double velocity_mm_per_s) {
  const double swept = std::fmod(time_s_, excitation_.sweep_s) / excitation_.sweep_s;
  const double frequency_Hz = excitation_.from_Hz * std::pow(excitation_.to_Hz / excitation_.from_Hz, swept);
  const double omega_per_s = 2 * std::numbers::pi * frequency_Hz;
  phase_rad_ = std::fmod(phase_rad_ + omega_per_s * period_s_, 2 * std::numbers::pi);
  const double inertia_N = excitation_.mass_kg * square(omega_per_s) * excitation_.shake_mm * mPerMm;
  const double shaking_N = std::max(inertia_N, moreThanFrictionShaking * excitation_.friction_N);
  const double keeping_N_per_mm = excitation_.mass_kg * square(2 * std::numbers::pi * keeping_Hz) * mPerMm;
  const double aside_mm = position_mm + velocity_mm_per_s * keepingLead_s - excitation_.middle_mm;
  const double kept_N =
      std::clamp(keeping_N_per_mm * aside_mm, -excitation_.largest_N / 2, excitation_.largest_N / 2);
  const double room_N = std::max(0.0, excitation_.largest_N - std::abs(kept_N));
  return kept_N + std::min(1.0, time_s_ / fadeIn_s) * std::min(shaking_N, room_N) * std::sin(phase_rad_);
}

}  // namespace detent::playback
