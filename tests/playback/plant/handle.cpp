// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/plant/handle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace detent::test {
namespace {

// mm and kg in newtons: m a = F is kg (mm/s2) = 1000 N.
constexpr double mmPerMetre = 1000;

double kinetic_mJ(double mass_kg, double speed_mm_per_s) {
  return 0.5 * mass_kg * speed_mm_per_s * speed_mm_per_s / mmPerMetre;
}

}  // namespace

HandleAndFinger::HandleAndFinger(const HandleSettings& handle, const FingerSettings& finger, Plan plan,
                                 double start_mm)
    : handle_(handle), finger_(finger), plan_(std::move(plan)), x_mm_(start_mm), tip_mm_(start_mm) {
  followed_ = plan_(0);
  storedAtStart_mJ_ = storedNow_mJ();
}

void HandleAndFinger::throwTip(double gap_mm, double speed_mm_per_s) {
  tip_mm_ = x_mm_ - gap_mm;
  tip_mm_per_s_ = speed_mm_per_s;
  storedAtStart_mJ_ = storedNow_mJ();
  energy_ = {};
}

void HandleAndFinger::takeFingerAway() {
  present_ = false;
  storedAtStart_mJ_ = storedNow_mJ();
  energy_ = {};
}

double HandleAndFinger::pulpEnergy_mJ(double depth_mm) const {
  if (depth_mm <= 0) return 0;
  return finger_.pulpForce_N *
         (std::expm1(finger_.pulpRate_per_mm * depth_mm) / finger_.pulpRate_per_mm - depth_mm);
}

// Mean elastic force over a step: energy over way, so that no step makes or loses any.
double HandleAndFinger::pulpElastic_N(double fromDepth_mm, double toDepth_mm) const {
  const double way_mm = toDepth_mm - fromDepth_mm;
  if (std::abs(way_mm) > 1e-4) return (pulpEnergy_mJ(toDepth_mm) - pulpEnergy_mJ(fromDepth_mm)) / way_mm;
  const double middle_mm = 0.5 * (fromDepth_mm + toDepth_mm);
  return middle_mm <= 0 ? 0 : finger_.pulpForce_N * std::expm1(finger_.pulpRate_per_mm * middle_mm);
}

// The handle over one step under a constant push: slides, comes to rest within the step, sticks, or breaks
// away. A function of the push without jumps, or the step would have no solution.
HandleAndFinger::Move HandleAndFinger::slide(double push_N, bool breaksAway) const {
  const double m = handle_.mass_kg / mmPerMetre, b = handle_.damping_Ns_per_mm;
  Move move;
  double v = v_mm_per_s_, way = 0;
  const auto take = [&](double end, double duration_s, double friction_N) {
    const double mean = 0.5 * (v + end), went = mean * duration_s;
    move.viscous_mJ += b * mean * went;
    move.friction_mJ += friction_N * went;
    way += went;
    v = end;
  };
  if (v != 0) {
    const double friction_N = std::copysign(handle_.coulomb_N, v);
    const double end = ((m / step_s - b / 2) * v + push_N - friction_N) / (m / step_s + b / 2);
    if (end * v > 0) {
      take(end, step_s, friction_N);
    } else {
      const double stopping_s = m * v / (friction_N + b * v / 2 - push_N);
      take(0, std::clamp(stopping_s, 0.0, step_s), friction_N);
    }
  }
  if (v_mm_per_s_ == 0 && breaksAway) {
    const double friction_N = std::copysign(handle_.coulomb_N, push_N_);
    const double end = (push_N - friction_N) / (m / step_s + b / 2);
    if (end * push_N_ > 0) take(end, step_s, friction_N);
  }
  const double at_mm = std::clamp(x_mm_ + way, handle_.lowest_mm, handle_.highest_mm);
  if (at_mm != x_mm_ + way) {  // a hard, inelastic stop
    const double into_mm = at_mm - x_mm_;
    return {at_mm, 0, into_mm, 0, 0, kinetic_mJ(handle_.mass_kg, v_mm_per_s_) + push_N * into_mm};
  }
  move.way_mm = way;
  move.to_mm = at_mm;
  move.to_mm_per_s = v;
  return move;
}

double HandleAndFinger::meanMotor_N(double command_N) {
  const double wanted_N = std::clamp(command_N, -handle_.motorLimit_N, handle_.motorLimit_N);
  if (handle_.motorLag_s <= 0) return motor_N_ = wanted_N;
  const double share = step_s / handle_.motorLag_s, kept = std::exp(-share);
  const double mean_N = wanted_N + (motor_N_ - wanted_N) * (1 - kept) / share;
  motor_N_ = wanted_N + (motor_N_ - wanted_N) * kept;
  return mean_N;
}

Intent HandleAndFinger::intent() {
  const Intent wanted = plan_(time_s());
  const double share = finger_.muscleLag_s <= 0 ? 1 : -std::expm1(-step_s / finger_.muscleLag_s);
  followed_.aim_mm += (wanted.aim_mm - followed_.aim_mm) * share;
  followed_.push_N += (wanted.push_N - followed_.push_N) * share;
  Intent shaken = followed_;
  const double pressed_N = std::max(pulp_N_, 0.0);
  shaken.push_N +=
      finger_.tremorShare * pressed_N * std::sin(2 * std::numbers::pi * finger_.tremor_Hz * time_s());
  return shaken;
}

double HandleAndFinger::storedNow_mJ() const {
  const double handle_mJ = kinetic_mJ(handle_.mass_kg, v_mm_per_s_);
  return handle_mJ + kinetic_mJ(finger_.mass_kg, tip_mm_per_s_) +
         (present_ ? pulpEnergy_mJ(tip_mm_ - x_mm_) : 0);
}

void HandleAndFinger::advance(double command_N) {
  const double motor_N = meanMotor_N(command_N);
  const Intent wanted = intent();
  const double tipMass = finger_.mass_kg / mmPerMetre;
  const double depth_mm = tip_mm_ - x_mm_;
  double tipTo_mm = tip_mm_ + tip_mm_per_s_ * step_s, tipTo_mm_per_s = tip_mm_per_s_;
  double xTo_mm = x_mm_ + v_mm_per_s_ * step_s, muscle_N = 0, elastic_N = 0, pulp_N = 0;
  const bool breaksAway = std::abs(push_N_) > handle_.static_N;
  Move move;
  for (int pass = 0; pass < 8; ++pass) {
    const double depthTo_mm = tipTo_mm - xTo_mm;
    elastic_N = present_ ? pulpElastic_N(depth_mm, depthTo_mm) : 0;
    pulp_N = std::max(0.0, elastic_N * (1 + finger_.pulpLoss_s_per_mm * (depthTo_mm - depth_mm) / step_s));
    muscle_N = wanted.push_N + finger_.stiffness_N_per_mm * (wanted.aim_mm - 0.5 * (tip_mm_ + tipTo_mm)) -
               finger_.damping_Ns_per_mm * 0.5 * (tip_mm_per_s_ + tipTo_mm_per_s);
    move = slide(pulp_N - motor_N, breaksAway);
    const double before_mm = tipTo_mm + xTo_mm;
    tipTo_mm_per_s = tip_mm_per_s_ + (muscle_N - pulp_N) * step_s / tipMass;
    tipTo_mm = tip_mm_ + 0.5 * (tip_mm_per_s_ + tipTo_mm_per_s) * step_s;
    xTo_mm = move.to_mm;
    if (pass > 0 && std::abs(tipTo_mm + xTo_mm - before_mm) < 1e-12) break;
  }
  const double tipWay_mm = tipTo_mm - tip_mm_;
  energy_.muscle_mJ += muscle_N * tipWay_mm;
  energy_.motor_mJ -= motor_N * move.way_mm;
  energy_.finger_mJ += pulp_N * move.way_mm;
  energy_.viscous_mJ += move.viscous_mJ;
  energy_.friction_mJ += move.friction_mJ;
  energy_.stops_mJ += move.stops_mJ;
  energy_.pulp_mJ += (pulp_N - elastic_N) * (tipWay_mm - move.way_mm);
  energy_.turnover_mJ +=
      std::abs(muscle_N * tipWay_mm) + std::abs(motor_N * move.way_mm) + std::abs(pulp_N * move.way_mm);
  x_mm_ = move.to_mm;
  v_mm_per_s_ = move.to_mm_per_s;
  tip_mm_ = tipTo_mm;
  tip_mm_per_s_ = tipTo_mm_per_s;
  pulp_N_ = pulp_N;
  push_N_ = pulp_N - motor_N;
  ++steps_;
  energy_.stored_mJ = storedNow_mJ() - storedAtStart_mJ_;
}

}  // namespace detent::test
