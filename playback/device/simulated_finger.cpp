// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/simulated_finger.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "playback/realtime/finger_profile.h"

namespace detent::playback {

namespace {

constexpr double above_mm = -0.5;  // position where a finger waits before the touch
// Rate at which a finger that holds a position corrects its error, and the limits of the time for that.
constexpr double correctionRate_per_s = 25, shortestCorrection_s = 0.2, longestCorrection_s = 0.8;
constexpr double arrivedWithin_mm = 0.005, arrivedBelow_mm_per_s = 0.5;
// Stiffness and damping of the muscles while they aim, relative to rest. They are higher, because both
// muscles of a pair pull; damping grows with the square root of the stiffness.
constexpr double aimingStiffness = 10, aimingDamping = 3;
constexpr double longestHold_s = 0.5;  // a press that does not feel the bottom turns back after this time
constexpr double tremorFrequencies_Hz[] = {8.7, 11.3};  // physiological tremor, 8 to 12 Hz

/// Value of a polyline at a time; `next` advances with it.
double along(const std::vector<double>& times, const std::vector<double>& values, double time_s,
             std::size_t& next) {
  while (next < times.size() && times[next] <= time_s) ++next;
  if (next == 0) return values.front();
  if (next == times.size()) return values.back();
  const double share = (time_s - times[next - 1]) / (times[next] - times[next - 1]);
  return values[next - 1] + share * (values[next] - values[next - 1]);
}

}  // namespace

SimulatedFinger::SimulatedFinger(const FingerMechanics& mechanics, FingerPlan plan)
    : mechanics_(mechanics), plan_(std::move(plan)), tip_mm_(above_mm) {}

double SimulatedFinger::tremor_mm() const {
  double sum = 0;
  for (const double f : tremorFrequencies_Hz) sum += std::sin(2 * std::numbers::pi * f * time_s_);
  return mechanics_.tremor_mm * sum / static_cast<double>(std::size(tremorFrequencies_Hz));
}

double SimulatedFinger::intended(const FingerHold& plan, double device_mm, double dt_s) {
  if (arrived_) return relaxed_mm_;
  if (time_s_ >= plan.approach_s) correction_mm_ += (plan.at_mm - device_mm) * correctionRate_per_s * dt_s;
  const double carried_N = std::max(0.0, plan.force_N),
               aim_mm = plan.at_mm + carried_N / mechanics_.pulpStiffness_N_per_mm +
                        carried_N / (aimingStiffness * mechanics_.stiffness_N_per_mm);
  return above_mm + (aim_mm - above_mm) * minimumJerk(time_s_ / plan.approach_s) + correction_mm_;
}

// The muscle keeps its force, because a finger that went on correcting would oscillate with the device's
// friction.
void SimulatedFinger::relaxAt(const FingerHold& plan, double device_mm, double device_mm_per_s,
                              double muscle_N) {
  const double aiming_s = time_s_ - plan.approach_s;
  const bool stands = std::abs(plan.at_mm - device_mm) <= arrivedWithin_mm &&
                      std::abs(device_mm_per_s) <= arrivedBelow_mm_per_s;
  if (!(aiming_s >= shortestCorrection_s && stands) && !(aiming_s >= longestCorrection_s)) return;
  arrived_ = true;
  relaxed_mm_ = tip_mm_ + muscle_N / mechanics_.stiffness_N_per_mm - tremor_mm();
  wantedBefore_mm_ = relaxed_mm_ + tremor_mm();  // a different aim with the same force is not a movement
}

double SimulatedFinger::intended(const FingerPresses& plan, double device_mm, double) {
  const double aim_mm = plan.travel_mm + 1.3 * std::max(0.1, plan.force_N) / mechanics_.stiffness_N_per_mm;
  const double in_s = time_s_ - phaseStart_s_;
  switch (phase_) {
    case Phase::pause:
      if (in_s >= plan.pause_s) phase_ = Phase::down, phaseStart_s_ = time_s_, felt_s_ = -1;
      return above_mm;
    case Phase::down: {
      if (felt_s_ < 0 && device_mm >= plan.travel_mm) felt_s_ = time_s_;
      turned_mm_ = above_mm + (aim_mm - above_mm) * minimumJerk(in_s / plan.press_s);
      if ((felt_s_ >= 0 && time_s_ - felt_s_ >= mechanics_.reaction_s) ||
          in_s > plan.press_s + longestHold_s) {
        phase_ = Phase::back, phaseStart_s_ = time_s_;
      }
      return turned_mm_;
    }
    case Phase::back:
      break;
  }
  if (in_s >= plan.release_s) phase_ = Phase::pause, phaseStart_s_ = time_s_;
  return turned_mm_ + (above_mm - turned_mm_) * minimumJerk(in_s / plan.release_s);
}

double SimulatedFinger::intended(const FingerPath& plan, double, double) {
  return along(plan.time_s, plan.position_mm, time_s_, next_);
}

double SimulatedFinger::intended_mm(double device_mm, double dt_s) {
  return std::visit([&](const auto& plan) { return intended(plan, device_mm, dt_s); }, plan_) + tremor_mm();
}

double SimulatedFinger::contact_N(double device_mm, double device_mm_per_s) const {
  const double into_mm = tip_mm_ - device_mm;
  if (into_mm <= 0) return 0;
  return std::max(0.0, mechanics_.pulpStiffness_N_per_mm * into_mm +
                           mechanics_.pulpDamping_Ns_per_mm * (tip_mm_per_s_ - device_mm_per_s));
}

double SimulatedFinger::push_N(double device_mm, double device_mm_per_s, double dt_s) {
  if (const auto* forces = std::get_if<FingerForcePath>(&plan_)) {
    const double push_N = along(forces->time_s, forces->force_N, time_s_, next_);
    time_s_ += dt_s;
    return push_N;
  }
  const double wanted_mm = intended_mm(device_mm, dt_s);
  if (!started_) started_ = true, wantedBefore_mm_ = wanted_mm, tip_mm_ = wanted_mm;
  const double wanted_mm_per_s = (wanted_mm - wantedBefore_mm_) / dt_s;
  wantedBefore_mm_ = wanted_mm;
  const double push_N = contact_N(device_mm, device_mm_per_s);
  const double muscle_N =
      (aiming() ? aimingStiffness : 1) * mechanics_.stiffness_N_per_mm * (wanted_mm - tip_mm_) +
      (aiming() ? aimingDamping : 1) * mechanics_.damping_Ns_per_mm * (wanted_mm_per_s - tip_mm_per_s_);
  if (aiming()) relaxAt(std::get<FingerHold>(plan_), device_mm, device_mm_per_s, muscle_N);
  constexpr double mmPerM = 1000;
  tip_mm_per_s_ += (muscle_N - push_N) / mechanics_.mass_kg * mmPerM * dt_s;
  tip_mm_ += tip_mm_per_s_ * dt_s;
  time_s_ += dt_s;
  return push_N;
}

}  // namespace detent::playback
