// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_engine.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace detent::playback {

namespace {

// Largest damping of the controller: with more, its own sampling would create energy.
constexpr double controllerDamping_Ns_per_mm = 0.005;
constexpr double controllerSpeed_mm_per_s = 0.5;  // slower movements need no damping

// After a restart an estimator returns 0 at first, which is not yet a speed.
constexpr double velocityKnown_s = 0.005;
constexpr std::uint32_t velocityReadings = 5;
constexpr std::uint32_t mostMissed = 100;

}  // namespace

ForceEngine::ForceEngine(const ForceProgram& program)
    : program_(&program),
      law_(program),
      test_(program),
      proof_(program.proof, program.period_s),
      proving_(program.proof.present),
      guard_(program.limits, program.period_s, program.step_mm),
      velocity_(program.velocity, program.period_s, program.step_mm),
      sidewaysVelocity_{velocity_, velocity_} {}

void ForceEngine::setProgram(const ForceProgram& program) {
  program_ = &program;
  const double pressShare = law_.pressShare();
  law_ = ForceLaw(program);
  law_.restart(steady_mm_, pressShare);
  test_ = TestForces(program);
  guard_.setLimits(program.limits, program.period_s, program.step_mm);
  velocity_ = VelocityEstimator(program.velocity, program.period_s, program.step_mm);
  sidewaysVelocity_ = {velocity_, velocity_};
  resuming_ = true;  // the velocity estimators have no data yet
  exchanged_ = running_;
}

// While the force changes from one button to another, the change itself moves energy, so the balance pauses.
double ForceEngine::exchanging_N(double force_N) {
  if (exchanged_) {
    exchanged_ = false;
    exchange_N_ = heldForce_N_ - force_N;
    exchangeLeft_ = 1;
  }
  const double sent_N = force_N + exchangeLeft_ * exchange_N_;
  exchangeLeft_ = std::max(0.0, exchangeLeft_ - program_->period_s / program_->limits.startRamp_s);
  return sent_N;
}

// An encoder that alternates between two steps only shows that the position is at their common edge, which is
// exactly the result here. A wider play would hide movement.
double ForceEngine::steadied_mm(double position_mm) const {
  const double half_mm = 0.5 * program_->step_mm * (1 + 1e-9);
  return std::max(position_mm - half_mm, std::min(position_mm + half_mm, steady_mm_));
}

// Force that acts between the last reading and this one, given the device's delay.
double ForceEngine::actingForce_N() const {
  const double periods =
      std::min(program_->law.holdLead_s / program_->period_s - 0.5, static_cast<double>(sent_N_.size() - 2));
  const auto whole = static_cast<std::size_t>(std::max(0.0, periods));
  const auto before = [&](std::size_t steps) {
    return sent_N_[(newestSent_ + sent_N_.size() - steps) % sent_N_.size()];
  };
  return before(whole) +
         (std::max(0.0, periods) - static_cast<double>(whole)) * (before(whole + 1) - before(whole));
}

// E(n) = E(n-1) + F (x(n) - x(n-1)) with the force that acted during the movement (Hannaford and Ryu's
// passivity observer). The distance is that of the steadied position: whenever it changes, the handle is at
// the edge between two encoder steps.
void ForceEngine::observe(double position_mm) {
  last_.energy_mJ += actingForce_N() * (position_mm - steady_mm_);
  steady_mm_ = position_mm;
  // A ramp of the force changes the energy by itself, so the balance restarts once the full force acts.
  const double worked_mJ = last_.energy_mJ + law_.stateEnergy_mJ();
  const bool whole = guard_.gain() == 1 && exchangeLeft_ == 0 && !exchanged_;
  if (whole && !full_) balanceOrigin_mJ_ = law_.stored_mJ(position_mm) - worked_mJ;
  full_ = whole;
  last_.balance_mJ = full_ ? balanceOrigin_mJ_ + worked_mJ : 0;
  lowestBalance_mJ_ = std::min(lowestBalance_mJ_, last_.balance_mJ);
}

double ForceEngine::controlled_N(double force_N, double velocity_mm_per_s) const {
  const double speed_mm_per_s = std::abs(velocity_mm_per_s);
  if (!program_->passivityController || last_.balance_mJ >= 0 || speed_mm_per_s < controllerSpeed_mm_per_s)
    return force_N;
  const double wanted_Ns_per_mm =
      -last_.balance_mJ / (program_->period_s * velocity_mm_per_s * velocity_mm_per_s);
  return force_N + std::min(wanted_Ns_per_mm, controllerDamping_Ns_per_mm) * velocity_mm_per_s;
}

std::array<double, 2> ForceEngine::guide(const std::array<double, 2>& sideways_mm) {
  std::array<double, 2> force_N{};
  const ForceGuide& g = program_->guide;
  if (!g.present) return force_N;
  for (std::size_t i = 0; i < force_N.size(); ++i) {
    if (!std::isfinite(sideways_mm[i])) continue;
    const double velocity = sidewaysVelocity_[i].update(sideways_mm[i]);
    const double wanted_N = -g.stiffness_N_per_mm * sideways_mm[i] - g.damping_Ns_per_mm * velocity;
    const double most_N = std::min(g.force_N, program_->limits.force_N);
    force_N[i] = guard_.gain() * std::clamp(wanted_N, -most_N, most_N);
  }
  return force_N;
}

void ForceEngine::restartAt(const ForceReading& reading) {
  if (!running_) steady_mm_ = reading.position_mm;
  velocity_.restart(reading.position_mm);
  for (std::size_t i = 0; i < sidewaysVelocity_.size(); ++i)
    sidewaysVelocity_[i].restart(reading.sideways_mm[i]);
  running_ = true;
  resuming_ = false;
  sinceRestart_ = missed_ = 0;
}

void ForceEngine::rearm() {
  guard_.rearm();
  running_ = false;
  proof_ = DirectionProof(program_->proof, program_->period_s);
  proving_ = program_->proof.present;
}

std::optional<double> ForceEngine::knownVelocity() const {
  if (sinceRestart_ < velocityReadings || sinceRestart_ * program_->period_s < velocityKnown_s) return {};
  return last_.velocity_mm_per_s;
}

double ForceEngine::requested_N(double position_mm) {
  if (!test_.present()) return law_.step(position_mm, last_.velocity_mm_per_s);
  const double force_N = test_.step_N(position_mm, last_.velocity_mm_per_s);
  if (test_.reversed()) guard_.latch(ForceHalt::reversed);
  if (test_.unmoved()) guard_.latch(ForceHalt::deadCount);
  return force_N;
}

double ForceEngine::proving_N(double position_mm) {
  const double push_N = proof_.step_N(position_mm);
  const DirectionProof::Verdict verdict = proof_.verdict();
  if (verdict == DirectionProof::Verdict::running) return push_N;
  if (verdict == DirectionProof::Verdict::reversed) guard_.latch(ForceHalt::reversed);
  if (verdict == DirectionProof::Verdict::unmoved) guard_.latch(ForceHalt::unmoved);
  proving_ = false;
  guard_.riseAnew();
  law_.restart(position_mm);
  return 0;
}

ForceCommand ForceEngine::step(const ForceReading& reading) {
  ++last_.index;
  last_.periods = reading.periods;
  if (reading.zero == ForceReading::Zero::lost) guard_.displace();
  if (reading.zero == ForceReading::Zero::found) {
    guard_.home();
    running_ = false;
  }
  if (reading.stopped) guard_.emergencyStop();
  if (reading.deadCount) guard_.latch(ForceHalt::deadCount);
  const ReadingVerdict verdict = guard_.judge(reading.position_mm, reading.fresh, reading.periods);
  last_.good = verdict == ReadingVerdict::good;
  last_.proving = proving_;
  if (!last_.good) {
    // Holds the last force for a moment, then lets it fall to zero.
    const ForceCommand command = send(guard_.limit(heldForce_N_, std::nullopt), {});
    resuming_ = resuming_ || guard_.silent();
    if (missed_ < mostMissed) ++missed_;
    return command;
  }
  if (!running_) law_.restart(reading.position_mm);
  if (!running_ || resuming_) restartAt(reading);
  last_.position_mm = reading.position_mm;
  const double before_mm = steady_mm_, missedInAll = missed_;
  const double position_mm = steadied_mm(reading.position_mm);
  observe(position_mm);
  // A distance covered in several periods must not appear as a higher speed.
  for (; missed_ > 0; --missed_)
    velocity_.update(position_mm - (position_mm - before_mm) * missed_ / (missedInAll + 1));
  last_.velocity_mm_per_s = velocity_.update(position_mm);
  if (sinceRestart_ < std::numeric_limits<std::uint32_t>::max()) ++sinceRestart_;
  heldForce_N_ = proving_ ? proving_N(reading.position_mm)
                          : controlled_N(exchanging_N(requested_N(position_mm)), last_.velocity_mm_per_s);
  last_.state = law_.state();
  last_.actuated = law_.actuated();
  return send(guard_.limit(heldForce_N_, knownVelocity()), guide(reading.sideways_mm));
}

ForceCommand ForceEngine::send(double force_N, std::array<double, 2> sideways_N) {
  last_.force_N = force_N;
  newestSent_ = (newestSent_ + 1) % sent_N_.size();
  sent_N_[newestSent_] = force_N;
  return {force_N, sideways_N, guard_.halt() != ForceHalt::none};
}

}  // namespace detent::playback
