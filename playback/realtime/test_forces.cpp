// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/test_forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace detent::playback {

namespace {

// The relay's force grows so fast until the handle has gone so far, then by so much: what moves it at all hardly does.
constexpr double growth_N_per_s = 0.8, movedBy_mm = 0.3, moreThanFriction = 3, least_N = 0.25;
// Against the push it needs less to be sure.
constexpr double opposedBy_mm = 0.05, opposedSteps = 4;
// Speeds between the slowest and the fastest, in an order that mixes them.
constexpr std::array<double, 5> speedShares{0.0, 1.0, 0.4, 0.1, 0.7};
// A weak spring of this frequency keeps the chirp in the middle; it leads by this, so that its own lateness makes nothing swing.
constexpr double keeping_Hz = 3, keepingLead_s = 0.08;
constexpr double moreThanFrictionShaking = 3, fadeIn_s = 0.4;
// Beyond this share of the half way it takes more force to turn, or less speed.
constexpr double mostBeyond = 0.8, stronger = 1.02, slower = 0.99;
constexpr double mPerMm = 1e-3;

double square(double x) { return x * x; }

}  // namespace

double TestForces::step_N(double position_mm, double velocity_mm_per_s) {
  if (!begun_) {
    from_mm_ = position_mm;
    direction_ = position_mm < excitation_.middle_mm ? 1 : -1;
  }
  begun_ = true;
  time_s_ += period_s_;
  const double force_N = excitation_.kind == ForceExcitation::Kind::relay
                             ? relay_N(position_mm, velocity_mm_per_s)
                             : chirp_N(position_mm, velocity_mm_per_s);
  if (reversed_) return 0;
  return std::clamp(force_N, -excitation_.largest_N, excitation_.largest_N);
}

// Grows until the handle moves.
double TestForces::throwing_N(double position_mm) {
  if (!moving_) {
    relay_N_ += growth_N_per_s * period_s_;
    const double followed_mm = direction_ * (position_mm - from_mm_);
    reversed_ = reversed_ || followed_mm < -std::max(opposedBy_mm, opposedSteps * step_mm_);
    moving_ = followed_mm > std::max(movedBy_mm, 0.1 * excitation_.half_mm);
    if (moving_) relay_N_ = std::max(moreThanFriction * relay_N_, least_N);
  }
  return std::min(relay_N_, excitation_.largest_N);
}

// A heavy handle turns late.
void TestForces::keepInside(double beyond_mm) {
  if (beyond_mm < mostBeyond * excitation_.half_mm) return;
  if (relay_N_ < excitation_.largest_N) {
    relay_N_ *= stronger;
  } else {
    fastest_mm_per_s_ = std::max(excitation_.slowest_mm_per_s, slower * fastest_mm_per_s_);
  }
}

// Accelerates up to the speed of this turn, coasts, and turns behind the half way; where friction has slowed it, it is pushed again.
double TestForces::relay_N(double position_mm, double velocity_mm_per_s) {
  const double strength_N = throwing_N(position_mm);
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
