// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Will people tell two buttons apart? From felt levels to d' to errors in an ABX test, as a forecast.
// docs/reference/predicted-confusion.md: sources, results on K&L's Table 2, and failures.

#include <functional>
#include <optional>
#include <vector>

#include "playback/study/perception/felt_button.h"

namespace detent::playback {

/// Kind of the largest difference between two buttons.
enum class Cue : std::uint8_t {
  strength,  ///< level of the vibration, at the same place of the stroke
  timing,    ///< mean time of the vibration, from the start of the stroke
  travel,    ///< apparent travel: number of grains that are passed
  force      ///< force of the finger on the way
};

/// Differences of one stroke, each in units of the just noticeable difference (d' = 1).
struct StrokeDifference {
  double strength = 0, timing = 0, travel = 0, force = 0;
  double largest() const;
  Cue cue() const;
};

struct ConfusionSettings {
  /// Just noticeable differences of level: Weber fraction 0.58 at 10 Hz (RA), 0.20 at 125 Hz (P).
  std::array<double, channelCount> noticeable_dB{3.97, 1.58};
  double integration_s = 0.2;  ///< temporal summation of P: frames within this time are one observation
  double timingWeber = 0.1;    ///< Weber fraction of the time since the stroke began
  double travelWeber = 0.25;   ///< Weber fraction of the number of grains
  /// Weber fraction of the finger's own mean force in two presses: each press varies by 0.2, and force is
  /// felt to 0.1 of its value.
  double forceWeber = 0.32;
  double alignment_s = 0.02;  ///< largest shift by which times are aligned
  // From d' to errors. Fitted by confusion_fit.py to the 15 pairs of K&L's noisy group (Table 2 (b)). Each
  // pair has its own sensitivity, log-normally distributed over pairs.
  double sensitivity = 3.3;        ///< factor on every d'; 1: not tuned
  double sensitivitySpread = 0.6;  ///< standard deviation of the factor's logarithm over pairs
  double lapses = 0.05;  ///< share of trials answered by guessing, however large the difference is; [0, 1)
};

/// Answer to "do people tell these apart?" (at most one error in ten, as in K&L's test): yes from a
/// probability of 0.9 on, no up to 0.1.
enum class Verdict : std::uint8_t { distinguished, notDistinguished, undecided };

/// One forecast. "Errors" are those of an ABX test with mixed pairs. All figures follow from dPrime.
struct PredictedPair {
  double dPrime = 0;           ///< mean over quick and slow presses
  double shareOfErrors = 0.5;  ///< [0, 0.5]
  /// range of the share of errors in 90 trials: 5 % of the pairs of this d' have fewer errors,
  double leastShareOfErrors = 0,
         mostShareOfErrors = 0.5;   ///< and 5 % have more
  double probabilityApart = 0;      ///< probability of at most one error in ten
  StrokeDifference press, release;  ///< mean over the presses
  bool onPress = true;              ///< stroke that differs more
  Cue cue = Cue::strength;          ///< cue that differs most in that stroke

  double errorsPer90() const { return 90 * shareOfErrors; }
  double leastErrorsPer90() const { return 90 * leastShareOfErrors; }
  double mostErrorsPer90() const { return 90 * mostShareOfErrors; }
  Verdict verdict() const;
  bool distinguished() const { return verdict() == Verdict::distinguished; }
};

/// Sets the errors of a pair that follow from its dPrime.
void foretellErrors(PredictedPair& pair, const ConfusionSettings& settings = {});

/// Rank of a pair among several, the most confused first.
struct PairRank {
  std::size_t rank = 1;
  std::optional<double> moreConfusedThanNext;  ///< probability, [0.5, 1]
};
std::vector<PairRank> ranksOf(const std::vector<PredictedPair>& pairs,
                              const ConfusionSettings& settings = {});

/// Symmetric; 0 for a button and itself. A few milliseconds. Any thread.
PredictedPair predictConfusion(const FeltButton& a, const FeltButton& b,
                               const ConfusionSettings& settings = {});

/// All pairs by pairs (0,1), (0,2), (1,2), ... `progress(done, all)` returns false to cancel; the result is
/// then empty.
std::vector<PredictedPair> predictAll(const std::vector<FeltButton>& buttons,
                                      const std::function<bool(std::size_t, std::size_t)>& progress = {},
                                      const ConfusionSettings& settings = {});

}  // namespace detent::playback
