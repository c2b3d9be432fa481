// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/press_policy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "playback/performance/elementary.h"
#include "playback/performance/press_response.h"

namespace detent::playback {

namespace {

// The cost weights of docs/reference/press-forecast.md; they must not be changed.
constexpr double costOfForce_per_N = 1;
constexpr double costOfTime_per_s = 10;
constexpr double costOfMiss = 40;
constexpr double costOfDouble = 20;

// part of an amplitude's standard deviation that does not depend on its size
constexpr double tremor_N = 0.02;
// spread of the expected operating point, as a share of it, if no jump marks it
constexpr double depthSpreadUnfelt = 0.1;
constexpr double unfeltNotice_s = 0.25;  // time from the command until the result is seen on the screen
constexpr double mostFaults = 0.05;      // share of misses, and of doubles, at the highest rate
constexpr int noiseScores = 256;
constexpr int depthScores = 9;
constexpr int amplitudeSteps = 36;
constexpr double firstRatio = 1.02, ratioStep = 1.04;  // relative to the least amplitude that activates

const std::vector<double>& noise() {
  static const std::vector<double> scores = normalScores(noiseScores);
  return scores;
}

const std::vector<double>& depthNoise() {
  static const std::vector<double> scores = normalScores(depthScores);
  return scores;
}

/// Mean and spread of values that are added one by one.
class Moments {
 public:
  void add(double value) {
    sum_ += value;
    squares_ += value * value;
    ++count_;
  }
  double mean() const { return count_ > 0 ? sum_ / count_ : 0; }
  double spread() const {
    return count_ > 0 ? std::sqrt(std::max(0.0, squares_ / count_ - mean() * mean())) : 0;
  }

 private:
  double sum_ = 0, squares_ = 0;
  int count_ = 0;
};

PressStatistics statisticsOf(const PressResponse& response, const Finger& finger, double amplitude_N) {
  const double spread_N = amplitudeSpread_N(finger, amplitude_N);
  Moments peak, impulse, activation, fromCommand, impact, cycle, held, rapidHeld, doubled, rapidDoubled;
  std::size_t place = 0;
  for (const double score : noise()) {
    const double a_N = amplitude_N + score * spread_N;
    const ResponsePoint at = response.at(a_N, place);
    peak.add(at.peak_N);
    impulse.add(at.impulse_Ns);
    cycle.add(at.cycle_s);
    doubled.add(at.doubled);
    rapidDoubled.add(at.rapidDoubled);
    if (a_N < response.least_N()) continue;
    activation.add(at.activation_s - at.touch_s);
    fromCommand.add(at.activation_s);
    impact.add(at.peak_s);
    held.add(at.held_s);
    rapidHeld.add(at.rapidHeld_s);
  }
  PressStatistics s;
  s.peak_N = peak.mean();
  s.impulse_Ns = impulse.mean();
  s.activation_s = activation.mean();
  s.activationSpread_s = activation.spread();
  s.commandToActivation_s = fromCommand.mean();
  s.commandToActivationSpread_s = fromCommand.spread();
  s.impactSpread_s = impact.spread();
  s.cycle_s = cycle.mean();
  s.held_s = held.mean();
  s.rapidHeld_s = rapidHeld.mean();
  s.missed = normalShare((response.least_N() - amplitude_N) / spread_N);
  s.doubled = doubled.mean();
  s.rapidDoubled = rapidDoubled.mean();
  return s;
}

/// Misses that the finger expects: without a jump that can be felt, it knows the operating point only
/// roughly.
double missesExpected(const PressResponse& response, const Finger& finger, const PressTask& task,
                      double amplitude_N, double missed) {
  if (task.jumpIsFelt) return missed;
  double sum = 0;
  for (const double score : depthNoise()) {
    const double depth_m = task.contact.close_m * (1 + depthSpreadUnfelt * score);
    sum += normalShare((response.leastReaching_N(depth_m) - amplitude_N) /
                       amplitudeSpread_N(finger, amplitude_N));
  }
  return sum / depthScores;
}

double costOf(const PressStatistics& s, double missesReckoned) {
  return costOfForce_per_N * s.peak_N + costOfTime_per_s * s.commandToActivation_s * (1 + missesReckoned) +
         costOfMiss * missesReckoned + costOfDouble * s.doubled;
}

/// The search for one finger's plan; keeps the best one so far.
class Search {
 public:
  Search(const KeyTables& key, const Finger& finger, const PressTask& task)
      : key_(key), finger_(finger), task_(task) {}

  void tryStroke(double duration_s, double lift_s) {
    const std::optional<PressResponse> response =
        PressResponse::measure(key_, task_.contact, finger_, duration_s, lift_s);
    if (!response) return;
    double amplitude_N = response->least_N() * firstRatio;
    for (int i = 0; i < amplitudeSteps && amplitude_N <= mostAmplitude_N; ++i, amplitude_N *= ratioStep)
      tryAmplitude(*response, {amplitude_N, duration_s, lift_s});
  }

  const std::optional<FingerPlan>& best() const { return best_; }
  double highestRate_per_s() const { return highestRate_per_s_; }

 private:
  void tryAmplitude(const PressResponse& response, const PressCommand& command) {
    const PressStatistics s = statisticsOf(response, finger_, command.amplitude_N);
    if (s.missed <= mostFaults && s.doubled <= mostFaults)
      highestRate_per_s_ = std::max(highestRate_per_s_, 1 / s.cycle_s);
    if (task_.period_s && s.cycle_s > *task_.period_s) return;
    const double cost = costOf(s, missesExpected(response, finger_, task_, command.amplitude_N, s.missed));
    if (cost >= leastCost_) return;
    leastCost_ = cost;
    best_ = FingerPlan{command, s, 0, 0, 0};
  }

  const KeyTables& key_;
  const Finger& finger_;
  const PressTask& task_;
  std::optional<FingerPlan> best_;
  double leastCost_ = std::numeric_limits<double>::infinity();
  double highestRate_per_s_ = 0;
};

/// P(the resting finger is heavier than every force up to the closing of the contact), with log-normal
/// weight.
double accidentalShare(const KeyTables& key, double close_m, const Finger& finger) {
  constexpr int positions = 400;
  double most_N = 0;
  for (int i = 0; i <= positions; ++i) {
    const double depth_m = close_m * i / positions;
    most_N = std::max(most_N, key.mean_N(depth_m) + key.halfWidth_N(depth_m));
  }
  // ln(weight) > ln(most), solved without a logarithm: finds the score at which the weight equals the force.
  double low = -8, high = 8;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (finger.restingWeightMedian_N * exponential(restingSpreadWithin * middle) < most_N ? low : high) = middle;
  }
  return 1 - normalShare(low);
}

double timePerCorrectPress(const FingerPlan& plan, const Finger& finger, bool jumpIsFelt) {
  const PressStatistics& s = plan.result;
  const double notice_s = jumpIsFelt ? finger.feedbackDelay_s : unfeltNotice_s;
  return s.cycle_s + s.missed * (s.cycle_s + notice_s) +
         (s.doubled + plan.accidental) * 2 * (s.cycle_s + unfeltNotice_s);
}

}  // namespace

double amplitudeSpread_N(const Finger& finger, double amplitude_N) {
  const double own_N = finger.amplitudeSpread * amplitude_N;
  return std::sqrt(own_N * own_N + tremor_N * tremor_N);
}

std::optional<FingerPlan> planPress(const KeyTables& key, const Finger& finger, const PressTask& task) {
  Search search(key, finger, task);
  for (const double duration_s : {0.05, 0.065, 0.08, 0.1, 0.125}) search.tryStroke(duration_s, 0);
  if (!search.best()) return {};
  const double duration_s = search.best()->command.duration_s;
  for (const double lift_s : {-0.02, 0.02}) search.tryStroke(duration_s, lift_s);
  const double lift_s = search.best()->command.lift_s;
  for (const double ratio : {0.9, 1.1}) search.tryStroke(duration_s * ratio, lift_s);
  FingerPlan plan = *search.best();
  plan.accidental = accidentalShare(key, task.contact.close_m, finger);
  plan.highestRate_per_s = search.highestRate_per_s();
  plan.timePerCorrectPress_s = timePerCorrectPress(plan, finger, task.jumpIsFelt);
  return plan;
}

}  // namespace detent::playback
