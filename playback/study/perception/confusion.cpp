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

constexpr double onset_dB = 6;  // level above threshold from which a frame is clearly felt

constexpr double errorsAtBar = 0.1;  // K&L: at most one error in ten trials
constexpr double surely = 0.9;       // probability from which a verdict is given
constexpr int rangeTrials = 90;      // as in Table 2: nine people, ten trials

constexpr std::size_t pairKinds = 40;  // equally frequent kinds of pairs, by increasing sensitivity

constexpr double faintForce_N = 0.02;  // two grams: less is not felt as a force

/// Levels from alignment_s before the first clearly felt frame on, with silence before a stroke that began
/// later than that. Faint levels in that time stay, so that a level near the bar changes only the alignment.
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

/// Both channels side by side: one instruction works on both.
using BothChannels = double __attribute__((vector_size(channelCount * sizeof(double))));
BothChannels smaller(BothChannels x, BothChannels y) { return y < x ? y : x; }
BothChannels larger(BothChannels x, BothChannels y) { return x < y ? y : x; }

/// A stroke as the cues compare it; made once per button.
struct ComparedStroke {
  /// Levels from the onset on, in just noticeable steps, without the silence at the end.
  std::vector<BothChannels> steps;
  std::size_t frames = 0;  ///< number of frames, the silence at the end included
  double centre_s = 0;
  double grains = 0, force_N = 0;
};

/// One frame of a stroke: its levels, and their range within half a frame.
struct LevelRange {
  BothChannels at{}, least{}, most{};
};

/// `frames`: at least as many as there are steps; the rest is silence.
std::vector<LevelRange> rangesOf(const std::vector<BothChannels>& steps, std::size_t frames) {
  std::vector<LevelRange> ranges(frames);
  for (std::size_t i = 0; i < steps.size(); ++i) ranges[i] = {steps[i], steps[i], steps[i]};
  for (std::size_t i = 1; i < std::min(frames, steps.size() + 1); ++i) {
    const BothChannels between = (ranges[i - 1].at + ranges[i].at) / 2;
    for (const std::size_t k : {i - 1, i}) {
      ranges[k].least = smaller(ranges[k].least, between);
      ranges[k].most = larger(ranges[k].most, between);
    }
  }
  return ranges;
}

/// Squared difference of two frames. A level counts only as far as it lies outside the levels that the other
/// stroke has within half a frame, because the exact start of a frame is not felt (Birchfield & Tomasi, IEEE
/// TPAMI 20(4), 1998).
double squaredSteps(const LevelRange& a, const LevelRange& b) {
  const BothChannels outsideB = a.at - smaller(larger(a.at, b.least), b.most);
  const BothChannels outsideA = b.at - smaller(larger(b.at, a.least), a.most);
  const BothChannels squares = smaller(outsideA * outsideA, outsideB * outsideB);
  return squares[0] + squares[1];
}

/// Dynamic time warping within a band: the least sum of squared steps over all alignments of the two strokes.
/// Computed along diagonals (frames i and k with the same i + k), whose sums do not depend on each other.
double warpedDistance(const ComparedStroke& strokeA, const ComparedStroke& strokeB, std::size_t band) {
  constexpr double far = std::numeric_limits<double>::infinity();
  // Frames in which both are silent add nothing. One such frame is enough, so that every alignment can reach
  // the end.
  const std::size_t loud = std::max(strokeA.steps.size(), strokeB.steps.size());
  const std::size_t n = std::min(std::max(strokeA.frames, strokeB.frames), loud + 1);
  if (n == 0) return 0;
  const std::vector<LevelRange> a = rangesOf(strokeA.steps, n), b = rangesOf(strokeB.steps, n);
  // Least sums of this diagonal and of the two before it; frame i has index i + 1.
  std::vector<double> now(n + 2, far), before(n + 2, far), beforeThat(n + 2, far);
  beforeThat[0] = 0;
  for (std::size_t diagonal = 0; diagonal <= 2 * (n - 1); ++diagonal) {
    const std::size_t inBand = diagonal > band ? (diagonal - band + 1) / 2 : 0;
    const std::size_t low = std::max(inBand, diagonal >= n ? diagonal - (n - 1) : 0);
    const std::size_t high = std::min({(diagonal + band) / 2, diagonal, n - 1});
    for (std::size_t i = low; i <= high; ++i)
      now[i + 1] =
          std::min(std::min(before[i], before[i + 1]), beforeThat[i]) + squaredSteps(a[i], b[diagonal - i]);
    now[low] = now[high + 2] = far;
    std::swap(beforeThat, before);
    std::swap(before, now);
  }
  return before[n];
}

/// Centroid of the P channel's power over time, s, from the start of the stroke; 0 for silence.
double centreOf(const FeltStroke& stroke) {
  double weight = 0, moment = 0;
  for (std::size_t i = 0; i < stroke.excitation.level_dB.size(); ++i) {
    const double power = std::pow(10, stroke.excitation.level_dB[i][1] / 10) - 1;
    weight += power;
    moment += power * frame_s * (static_cast<double>(i) + 0.5);
  }
  return weight > 0 ? moment / weight : 0;
}

std::size_t bandOf(const ConfusionSettings& settings) {
  return static_cast<std::size_t>(settings.alignment_s / frame_s);
}

ComparedStroke comparedStroke(const FeltStroke& felt, const ConfusionSettings& settings) {
  ComparedStroke stroke;
  const BothChannels step_dB{settings.noticeable_dB[0], settings.noticeable_dB[1]};
  for (const auto& frame : fromOnset(felt.excitation.level_dB, settings))
    stroke.steps.push_back(BothChannels{frame[0], frame[1]} / step_dB);
  stroke.frames = stroke.steps.size();
  while (!stroke.steps.empty() && stroke.steps.back()[0] == 0 && stroke.steps.back()[1] == 0)
    stroke.steps.pop_back();
  stroke.centre_s = centreOf(felt);
  stroke.grains = static_cast<double>(felt.grains);
  stroke.force_N = felt.meanForce_N;
  return stroke;
}

/// Logarithm of the ratio of two positive quantities.
double ratio(double a, double b, double least) {
  return std::fabs(std::log(std::max(a, least) / std::max(b, least)));
}

StrokeDifference differenceOf(const ComparedStroke& a, const ComparedStroke& b,
                              const ConfusionSettings& settings) {
  StrokeDifference d;
  d.strength = std::sqrt(warpedDistance(a, b, bandOf(settings)) * frame_s / settings.integration_s);
  if (a.centre_s > 0 && b.centre_s > 0)
    d.timing = ratio(a.centre_s, b.centre_s, frame_s) / settings.timingWeber;
  d.travel = ratio(1 + a.grains, 1 + b.grains, 1) / settings.travelWeber;
  d.force = ratio(a.force_N, b.force_N, faintForce_N) / settings.forceWeber;
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

/// d' that gives one error in ten.
double dPrimeAtBar(const ConfusionSettings& settings) {
  const double share = 1 - (errorsAtBar - settings.lapses / 2) / (1 - settings.lapses);
  return dPrimeOf(share, AbxStrategy::differencing);
}

/// Probability that people confuse a pair with the smaller d' more often than one with the larger.
double probabilityMoreConfused(double smaller, double larger, const ConfusionSettings& settings) {
  if (smaller == larger) return 0.5;
  if (smaller <= 0) return 1;
  return normalCdf(std::log(larger / smaller) / (std::sqrt(2.0) * settings.sensitivitySpread));
}

/// Sensitivity factors of all kinds of pairs, and the d' that gives one error in ten. Both are the same for
/// every pair.
class PairErrors {
 public:
  explicit PairErrors(const ConfusionSettings& settings)
      : settings_(settings), dPrimeAtBar_(dPrimeAtBar(settings)) {
    for (std::size_t i = 0; i < pairKinds; ++i)
      factors_[i] =
          std::exp(settings.sensitivitySpread * normalQuantile((static_cast<double>(i) + 0.5) / pairKinds));
  }

  void foretell(PredictedPair& pair) const {
    constexpr double tail = 0.05;  // share that is left out at each end of the range
    std::array<double, rangeTrials + 1> probability{};
    for (const double factor : factors_) {
      const double wrong = shareWrong(pair.dPrime * factor, settings_);
      const double odds = wrong / (1 - wrong);
      double exactly = std::pow(1 - wrong, rangeTrials);  // no error
      for (int k = 0; k <= rangeTrials; ++k) {
        probability[static_cast<std::size_t>(k)] += exactly / pairKinds;
        exactly *= odds * (rangeTrials - k) / (k + 1);
      }
    }
    const auto shareAt = [&](double quantile) {
      double below = 0;
      int k = 0;
      while (k < rangeTrials && (below += probability[static_cast<std::size_t>(k)]) < quantile) ++k;
      return double(k) / rangeTrials;
    };
    pair.shareOfErrors = shareWrong(pair.dPrime, settings_);
    pair.leastShareOfErrors = shareAt(tail);
    pair.mostShareOfErrors = shareAt(1 - tail);
    pair.probabilityApart =
        pair.dPrime > 0 ? normalCdf(std::log(pair.dPrime / dPrimeAtBar_) / settings_.sensitivitySpread) : 0;
  }

 private:
  const ConfusionSettings& settings_;
  double dPrimeAtBar_;
  std::array<double, pairKinds> factors_{};
};

/// Buttons ready to be compared with each other, pair by pair.
class Comparison {
 public:
  Comparison(const std::vector<const FeltButton*>& buttons, const ConfusionSettings& settings)
      : settings_(settings), errors_(settings) {
    for (const FeltButton* button : buttons) {
      States& states = buttons_.emplace_back();
      for (const auto& presses : button->states) {
        Presses& compared = states.emplace_back();
        for (std::size_t i = 0; i < presses.size(); ++i)
          compared[i] = {comparedStroke(presses[i].press, settings),
                         comparedStroke(presses[i].release, settings)};
      }
    }
  }

  /// Forecast for two buttons; for self-locking ones, that of the state in which they differ more clearly.
  PredictedPair pair(std::size_t a, std::size_t b) const {
    const std::size_t states = std::max(buttons_[a].size(), buttons_[b].size());
    PredictedPair clearest;
    for (std::size_t s = 0; s < states; ++s) {
      PredictedPair pair =
          statePair(buttons_[a][s % buttons_[a].size()], buttons_[b][s % buttons_[b].size()]);
      if (s == 0 || pair.dPrime > clearest.dPrime) clearest = pair;
    }
    if (states > 0) errors_.foretell(clearest);
    return clearest;
  }

 private:
  struct ComparedPress {
    ComparedStroke press, release;
  };
  using Presses = std::array<ComparedPress, pressLengths_s.size()>;
  using States = std::vector<Presses>;

  PredictedPair statePair(const Presses& a, const Presses& b) const {
    constexpr double share = 1.0 / static_cast<double>(pressLengths_s.size());
    PredictedPair pair;
    for (std::size_t i = 0; i < pressLengths_s.size(); ++i) {
      const StrokeDifference press = differenceOf(a[i].press, b[i].press, settings_);
      const StrokeDifference release = differenceOf(a[i].release, b[i].release, settings_);
      const double d = settings_.sensitivity * std::hypot(press.largest(), release.largest());
      addTo(pair.press, press, share);
      addTo(pair.release, release, share);
      pair.dPrime += share * d;
    }
    pair.onPress = pair.press.largest() >= pair.release.largest();
    pair.cue = (pair.onPress ? pair.press : pair.release).cue();
    return pair;
  }

  const ConfusionSettings& settings_;
  PairErrors errors_;
  std::vector<States> buttons_;
};

}  // namespace

double StrokeDifference::largest() const { return std::max({strength, timing, travel, force}); }

Cue StrokeDifference::cue() const {
  const double most = largest();
  if (strength == most) return Cue::strength;
  if (timing == most) return Cue::timing;
  return travel == most ? Cue::travel : Cue::force;
}

Verdict PredictedPair::verdict() const {
  if (probabilityApart >= surely) return Verdict::distinguished;
  return probabilityApart <= 1 - surely ? Verdict::notDistinguished : Verdict::undecided;
}

void foretellErrors(PredictedPair& pair, const ConfusionSettings& settings) {
  PairErrors(settings).foretell(pair);
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
  return Comparison({&a, &b}, settings).pair(0, 1);
}

std::vector<PredictedPair> predictAll(const std::vector<FeltButton>& buttons,
                                      const std::function<bool(std::size_t, std::size_t)>& progress,
                                      const ConfusionSettings& settings) {
  std::vector<const FeltButton*> all;
  for (const FeltButton& button : buttons) all.push_back(&button);
  const Comparison comparison(all, settings);
  const std::size_t count = buttons.size() * (buttons.size() - (buttons.empty() ? 0 : 1)) / 2;
  std::vector<PredictedPair> pairs;
  for (std::size_t second = 1; second < buttons.size(); ++second) {
    for (std::size_t first = 0; first < second; ++first) {
      pairs.push_back(comparison.pair(first, second));
      if (progress && !progress(pairs.size(), count)) return {};
    }
  }
  return pairs;
}

}  // namespace detent::playback
