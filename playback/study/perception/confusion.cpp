// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/perception/confusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "playback/measurement/normal.h"
#include "playback/study/statistics/abx_sensitivity.h"

namespace detent::playback {

namespace {

using Levels = std::vector<std::array<double, channelCount>>;

constexpr double onset_dB = 6;  // above threshold: clearly felt

constexpr double errorsAtBar = 0.1;  // K&L: at most one error in ten trials
constexpr double surely = 0.9;       // probability of a verdict
constexpr int rangeTrials = 90;      // as in Table 2: nine people, ten trials

constexpr double faintForce_N = 0.02;  // two grams: less is not felt as a force

/// Levels from alignment_s before the first clearly felt frame on, with silence if the stroke is younger.
/// Faint levels before it stay, so that a level that passes the bar changes the alignment only.
Levels fromOnset(const Levels& levels, const ConfusionSettings& settings) {
  double loudest = 0;
  for (const auto& frame : levels) loudest = std::max({loudest, frame[0], frame[1]});
  const double bar = std::min(onset_dB, loudest);
  const auto first = std::find_if(levels.begin(), levels.end(),
                                  [&](const auto& frame) { return std::max(frame[0], frame[1]) >= bar; });
  const auto lead = static_cast<std::ptrdiff_t>(settings.alignment_s / frame_s);
  const std::ptrdiff_t there = std::min(lead, first - levels.begin());
  Levels from(static_cast<std::size_t>(lead - there));
  from.insert(from.end(), first - there, levels.end());
  return from;
}

/// A stroke's levels and, channel by channel, what they lie between half a frame to either side of each
/// moment.
struct Course {
  Levels at, least, most;
};

Course courseOf(Levels levels, std::size_t frames) {
  levels.resize(frames);  // silence behind its end
  Course course{levels, levels, levels};
  for (std::size_t i = 1; i < frames; ++i) {
    for (std::size_t c = 0; c < channelCount; ++c) {
      const double between = (levels[i - 1][c] + levels[i][c]) / 2;
      for (const std::size_t k : {i - 1, i}) {
        course.least[k][c] = std::min(course.least[k][c], between);
        course.most[k][c] = std::max(course.most[k][c], between);
      }
    }
  }
  return course;
}

/// Squared difference of two moments in just noticeable steps, as far as neither sequence has the other's
/// level within half a frame: the start of a frame is not felt (Birchfield & Tomasi, IEEE TPAMI 20(4), 1998).
double stepsBetween(const Course& a, std::size_t i, const Course& b, std::size_t k,
                    const ConfusionSettings& settings) {
  const auto outside = [](double level, double least, double most) {
    return std::max({0.0, level - most, least - level});
  };
  double sum = 0;
  for (std::size_t c = 0; c < channelCount; ++c) {
    const double apart_dB = std::min(outside(a.at[i][c], b.least[k][c], b.most[k][c]),
                                     outside(b.at[k][c], a.least[i][c], a.most[i][c]));
    const double steps = apart_dB / settings.noticeable_dB[c];
    sum += steps * steps;
  }
  return sum;
}

/// Dynamic time warping with a band: the least sum of squared steps over all ways to lay one over the other.
double warpedDistance(const Levels& levelsA, const Levels& levelsB, const ConfusionSettings& settings) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const std::size_t n = std::max(levelsA.size(), levelsB.size());
  const auto band = static_cast<std::size_t>(settings.alignment_s / frame_s);
  if (n == 0) return 0;
  const Course a = courseOf(levelsA, n), b = courseOf(levelsB, n);
  std::vector<double> before(n, far), row(n, far);
  for (std::size_t i = 0; i < n; ++i) {
    std::fill(row.begin(), row.end(), far);
    for (std::size_t k = i > band ? i - band : 0; k <= std::min(i + band, n - 1); ++k) {
      double best = i == 0 && k == 0 ? 0 : far;
      if (i > 0) best = std::min(best, before[k]);
      if (k > 0) best = std::min(best, row[k - 1]);
      if (i > 0 && k > 0) best = std::min(best, before[k - 1]);
      row[k] = best + stepsBetween(a, i, b, k, settings);
    }
    std::swap(before, row);
  }
  return before[n - 1];
}

/// Centroid time of the P channel's power from the start of the stroke, s; 0 for silence.
double centreOf(const FeltStroke& stroke) {
  double weight = 0, moment = 0;
  for (std::size_t i = 0; i < stroke.excitation.level_dB.size(); ++i) {
    const double power = std::pow(10, stroke.excitation.level_dB[i][1] / 10) - 1;
    weight += power;
    moment += power * frame_s * (static_cast<double>(i) + 0.5);
  }
  return weight > 0 ? moment / weight : 0;
}

/// Difference of two positive quantities as their ratio's logarithm.
double ratio(double a, double b, double least) {
  return std::fabs(std::log(std::max(a, least) / std::max(b, least)));
}

StrokeDifference differenceOf(const FeltStroke& a, const FeltStroke& b, const ConfusionSettings& settings) {
  StrokeDifference d;
  d.strength = std::sqrt(warpedDistance(fromOnset(a.excitation.level_dB, settings),
                                        fromOnset(b.excitation.level_dB, settings), settings) *
                         frame_s / settings.integration_s);
  const double whenA_s = centreOf(a), whenB_s = centreOf(b);
  if (whenA_s > 0 && whenB_s > 0) d.timing = ratio(whenA_s, whenB_s, frame_s) / settings.timingWeber;
  d.travel =
      ratio(1 + static_cast<double>(a.grains), 1 + static_cast<double>(b.grains), 1) / settings.travelWeber;
  d.force = ratio(a.meanForce_N, b.meanForce_N, faintForce_N) / settings.forceWeber;
  return d;
}

void addTo(StrokeDifference& sum, const StrokeDifference& d, double share) {
  sum.strength += share * d.strength;
  sum.timing += share * d.timing;
  sum.travel += share * d.travel;
  sum.force += share * d.force;
}

double shareWrong(double dPrime, const ConfusionSettings& settings) {
  return settings.lapses / 2 + (1 - settings.lapses) * (1 - shareCorrect(dPrime, AbxStrategy::differencing));
}

/// d' that makes one error in ten.
double dPrimeAtBar(const ConfusionSettings& settings) {
  const double share = 1 - (errorsAtBar - settings.lapses / 2) / (1 - settings.lapses);
  return dPrimeOf(share, AbxStrategy::differencing);
}

/// Probability that people confuse a pair of the smaller d' more than one of the larger.
double probabilityMoreConfused(double smaller, double larger, const ConfusionSettings& settings) {
  if (smaller == larger) return 0.5;
  if (smaller <= 0) return 1;
  return normalCdf(std::log(larger / smaller) / (std::sqrt(2.0) * settings.sensitivitySpread));
}

PredictedPair predictState(const FeltButton& a, const FeltButton& b, std::size_t state,
                           const ConfusionSettings& settings) {
  const auto& pressesA = a.states[state % a.states.size()];
  const auto& pressesB = b.states[state % b.states.size()];
  constexpr double share = 1.0 / static_cast<double>(pressLengths_s.size());
  PredictedPair pair;
  for (std::size_t i = 0; i < pressLengths_s.size(); ++i) {
    const StrokeDifference press = differenceOf(pressesA[i].press, pressesB[i].press, settings);
    const StrokeDifference release = differenceOf(pressesA[i].release, pressesB[i].release, settings);
    const double d = settings.sensitivity * std::hypot(press.largest(), release.largest());
    addTo(pair.press, press, share);
    addTo(pair.release, release, share);
    pair.dPrime += share * d;
  }
  foretellErrors(pair, settings);
  pair.onPress = pair.press.largest() >= pair.release.largest();
  pair.cue = (pair.onPress ? pair.press : pair.release).cue();
  return pair;
}

}  // namespace

double StrokeDifference::largest() const { return std::max({strength, timing, travel, force}); }

Cue StrokeDifference::cue() const {
  const double most = largest();
  if (strength == most) return Cue::strength;
  if (timing == most) return Cue::timing;
  return travel == most ? Cue::travel : Cue::force;
}

Verdict PredictedPair::verdict() const {
  if (probabilityApart >= surely) return Verdict::toldApart;
  return probabilityApart <= 1 - surely ? Verdict::notToldApart : Verdict::undecided;
}

void foretellErrors(PredictedPair& pair, const ConfusionSettings& settings) {
  constexpr int kinds = 40;      // of pairs, equally frequent, by rising sensitivity
  constexpr double tail = 0.05;  // left out at each end of the range
  std::array<double, rangeTrials + 1> probability{};
  for (int i = 0; i < kinds; ++i) {
    const double z = normalQuantile((i + 0.5) / kinds);
    const double wrong = shareWrong(pair.dPrime * std::exp(z * settings.sensitivitySpread), settings);
    double exactly = std::pow(1 - wrong, rangeTrials);  // no error
    for (int k = 0; k <= rangeTrials; ++k) {
      probability[static_cast<std::size_t>(k)] += exactly / kinds;
      exactly *= double(rangeTrials - k) / (k + 1) * wrong / (1 - wrong);
    }
  }
  const auto shareAt = [&](double quantile) {
    double below = 0;
    int k = 0;
    while (k < rangeTrials && (below += probability[static_cast<std::size_t>(k)]) < quantile) ++k;
    return double(k) / rangeTrials;
  };
  pair.shareOfErrors = shareWrong(pair.dPrime, settings);
  pair.leastShareOfErrors = shareAt(tail);
  pair.mostShareOfErrors = shareAt(1 - tail);
  pair.probabilityApart =
      pair.dPrime > 0 ? normalCdf(std::log(pair.dPrime / dPrimeAtBar(settings)) / settings.sensitivitySpread)
                      : 0;
}

std::vector<PairRank> ranksOf(const std::vector<PredictedPair>& pairs, const ConfusionSettings& settings) {
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return pairs[a].dPrime < pairs[b].dPrime; });
  std::vector<PairRank> ranks(pairs.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    PairRank& rank = ranks[order[i]];
    rank.rank = i + 1;
    if (i + 1 == order.size()) break;
    rank.moreConfusedThanNext =
        probabilityMoreConfused(pairs[order[i]].dPrime, pairs[order[i + 1]].dPrime, settings);
  }
  return ranks;
}

PredictedPair predictConfusion(const FeltButton& a, const FeltButton& b, const ConfusionSettings& settings) {
  PredictedPair clearest;
  const std::size_t states = std::max(a.states.size(), b.states.size());
  for (std::size_t s = 0; s < states; ++s) {
    PredictedPair pair = predictState(a, b, s, settings);
    if (s == 0 || pair.dPrime > clearest.dPrime) clearest = pair;
  }
  return clearest;
}

std::vector<PredictedPair> predictAll(const std::vector<FeltButton>& buttons,
                                      const std::function<bool(std::size_t, std::size_t)>& progress,
                                      const ConfusionSettings& settings) {
  std::vector<PredictedPair> pairs;
  const std::size_t all = buttons.size() * (buttons.size() - (buttons.empty() ? 0 : 1)) / 2;
  for (std::size_t second = 1; second < buttons.size(); ++second) {
    for (std::size_t first = 0; first < second; ++first) {
      pairs.push_back(predictConfusion(buttons[first], buttons[second], settings));
      if (progress && !progress(pairs.size(), all)) return {};
    }
  }
  return pairs;
}

}  // namespace detent::playback
