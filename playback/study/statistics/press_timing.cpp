// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/press_timing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "model/check.h"
#include "playback/measurement/normal.h"

namespace detent::playback {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int mostRounds = 300;
constexpr double settled = 1e-9;
constexpr double firstLapses = 0.05;
/// Range over which lapses are distributed, on the scale of an observation: one interval to either side; for
/// tapping a factor e to either side.
constexpr double lapseRange = 2;

/// An observation y = place * carrier + drift * when + noise; y in intervals, for tapping its logarithm.
struct Observation {
  double y = 0, carrier = 1, when = 0;  ///< when: from -1/2 to 1/2 over the trials
};

Observation observed(TimingTask task, const TimedPress& trial, double when) {
  DETENT_CHECK(task == TimingTask::tapping ? *trial.press_s > 0 : trial.interval_s > 0,
               "intervals, and times between taps, above 0");
  if (task == TimingTask::tapping) return {std::log(*trial.press_s), 1, when};
  const double carrier = task == TimingTask::window ? trial.window_s / trial.interval_s : 1;
  return {*trial.press_s / trial.interval_s, carrier, when};
}

struct Line {
  double place = 0, drift = 0, variance = 0;
  double at(const Observation& o) const { return place * o.carrier + drift * o.when; }
};

/// Weighted least squares of place and drift; the variance loses a degree of freedom for each.
std::optional<Line> fitted(const std::vector<Observation>& all, const std::vector<double>& weights) {
  double cc = 0, ct = 0, tt = 0, cy = 0, ty = 0, sum = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [y, carrier, when] = all[i];
    const double w = weights[i];
    cc += w * carrier * carrier;
    ct += w * carrier * when;
    tt += w * when * when;
    cy += w * carrier * y;
    ty += w * when * y;
    sum += w;
  }
  const double determinant = cc * tt - ct * ct;
  if (!(determinant > 0) || !(sum > 2)) return {};
  Line line{(cy * tt - ty * ct) / determinant, (ty * cc - cy * ct) / determinant, 0};
  for (std::size_t i = 0; i < all.size(); ++i)
    line.variance += weights[i] * (all[i].y - line.at(all[i])) * (all[i].y - line.at(all[i]));
  line.variance /= sum - 2;
  return line;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// First estimate for the iteration: median and median deviation. A lapse in every fourth trial does not move
/// it.
Line startFor(const std::vector<Observation>& all) {
  std::vector<double> observedPlaces, deviations;
  for (const Observation& o : all) observedPlaces.push_back(o.y / o.carrier);
  Line line{medianOf(observedPlaces), 0, 0};
  for (const Observation& o : all) deviations.push_back(std::fabs(o.y - line.at(o)));
  constexpr double ofNormal = 1.4826;
  line.variance = std::pow(ofNormal * medianOf(deviations), 2);
  return line;
}

struct MeanOverPeople {
  double mean = 0, half = 0;
};

MeanOverPeople meanOver(const std::vector<double>& values, double confidence) {
  const auto n = static_cast<double>(values.size());
  MeanOverPeople result{std::accumulate(values.begin(), values.end(), 0.0) / n, 0};
  if (values.size() < 2) return result;
  double squares = 0;
  for (const double v : values) squares += (v - result.mean) * (v - result.mean);
  result.half = studentQuantile(0.5 + confidence / 2, values.size() - 1) * std::sqrt(squares / (n - 1) / n);
  return result;
}

}  // namespace

std::optional<PersonTiming> timingOf(TimingTask task, const std::vector<TimedPress>& trials) {
  std::vector<Observation> all;
  for (std::size_t i = 0; i < trials.size(); ++i)
    if (trials[i].press_s)
      all.push_back(observed(task, trials[i],
                             (static_cast<double>(i) + 0.5) / static_cast<double>(trials.size()) - 0.5));
  if (all.size() < leastPresses) return {};
  Line line = startFor(all);
  double lapses = firstLapses;
  std::vector<double> weights(all.size(), 1);
  // Expectation maximisation: each press belongs to the task with some probability.
  for (int round = 0; round < mostRounds; ++round) {
    if (!(line.variance > 0)) return {};
    const double height = (1 - lapses) / std::sqrt(2 * pi * line.variance);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double off = all[i].y - line.at(all[i]);
      const double own = height * std::exp(-off * off / (2 * line.variance));
      weights[i] = own / (own + lapses / lapseRange);
    }
    const std::optional<Line> next = fitted(all, weights);
    if (!next) return {};
    lapses = 1 - std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
    const bool still = std::fabs(next->variance - line.variance) <= settled * line.variance &&
                       std::fabs(next->place - line.place) <= settled * std::sqrt(line.variance);
    line = *next;
    if (still) break;
  }
  if (!(line.variance > 0)) return {};
  // The logarithm of an estimated standard deviation is too low, by 1/2 divided by the degrees of freedom.
  const double degrees = std::accumulate(weights.begin(), weights.end(), -2.0);
  const double spread = std::sqrt(line.variance) * std::exp(0.5 / degrees);
  const double place = task == TimingTask::tapping ? std::exp(line.place) : line.place;
  return PersonTiming{trials.size(), all.size(), {place, spread}, line.drift, lapses};
}

LaboratoryTiming timingOver(TimingTask task, const std::vector<PersonTiming>& people, double confidence) {
  DETENT_CHECK(!people.empty(), "a laboratory has people");
  const bool ratio = task == TimingTask::tapping;  // for times between presses, a ratio scale, as for spreads
  std::vector<double> personPlaces, spreads;
  for (const PersonTiming& p : people) {
    personPlaces.push_back(ratio ? std::log(p.timing.place) : p.timing.place);
    spreads.push_back(std::log(p.timing.spread));
  }
  const MeanOverPeople place = meanOver(personPlaces, confidence), spread = meanOver(spreads, confidence);
  const auto back = [&](double value, bool logarithm) { return logarithm ? std::exp(value) : value; };
  LaboratoryTiming laboratory{{back(place.mean, ratio), std::exp(spread.mean)}, {}, {}};
  if (people.size() < fewestForInterval) return laboratory;
  laboratory.place = Interval{back(place.mean - place.half, ratio), back(place.mean + place.half, ratio)};
  laboratory.spread = Interval{std::exp(spread.mean - spread.half), std::exp(spread.mean + spread.half)};
  return laboratory;
}

}  // namespace detent::playback
