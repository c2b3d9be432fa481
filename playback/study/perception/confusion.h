// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Will people tell two buttons apart? From what is felt to d' to errors in an ABX test, before anyone is
// asked. docs/reference/predicted-confusion.md: sources, what it reaches on K&L's Table 2, and where it fails.

#include <functional>
#include <vector>

#include "playback/study/perception/felt_button.h"

namespace detent::playback {

/// What differs most between two buttons.
enum class Cue : std::uint8_t {
  strength,  ///< how strong it is, at the same place of the stroke
  timing,    ///< when in the stroke its weight comes
  travel,    ///< how far it seems to yield: how many grains are passed
  force      ///< how hard one presses on the way
};

/// One stroke's differences, each in units of what is just noticed (d' = 1).
struct StrokeDifference {
  double strength = 0, timing = 0, travel = 0, force = 0;
  double largest() const;
  Cue cue() const;
};

/// Factors on d' that bring the untuned forecast of single pairs to what K&L's noisy group did (Table 2 (b)): the least and the most of
/// the 15 pairs. A further pair like them lies within in 14 of 16 cases. `confusion_bench` prints them.
struct SensitivityRange {
  double least = 0.72, most = 5.8;
};

struct ConfusionSettings {
  /// Just noticeable differences of level: Weber fraction 0.58 at 10 Hz (RA), 0.20 at 125 Hz (P).
  std::array<double, channelCount> noticeable_dB{3.97, 1.58};
  double integration_s = 0.2;  ///< temporal summation of P: frames within are one look
  double timingWeber = 0.1;    ///< of the time since the stroke began
  double travelWeber = 0.25;   ///< of the number of grains
  /// Of the finger's own mean force in two presses of one's own: each varies by 0.2, and force is felt to 0.1 of it.
  double forceWeber = 0.32;
  double alignment_s = 0.02;  ///< time is warped by at most so much
  double sensitivity = 1;     ///< factor on every d'; 1: not tuned
  SensitivityRange range;     ///< further factors, for the range of errors
};

/// What the range of a forecast bears: that people tell two buttons apart (at most one error in ten, the bar of K&L's test, at both of
/// its ends), that they do not (more, at both), or neither.
enum class Verdict : std::uint8_t { toldApart, notToldApart, cannotBeSaid };

/// One forecast. "Errors" are those of an ABX test with mixed pairs.
struct PredictedPair {
  double dPrime = 0;              ///< mean over quick and slow presses
  double shareOfErrors = 0;       ///< [0, 0.5]
  double leastShareOfErrors = 0,  ///< at the sensitivity range's ends
      mostShareOfErrors = 0;
  StrokeDifference press, release;  ///< mean over the presses
  bool onPress = true;              ///< which stroke says more
  Cue cue = Cue::strength;          ///< and by what

  double errorsPer90() const { return 90 * shareOfErrors; }
  double leastErrorsPer90() const { return 90 * leastShareOfErrors; }
  double mostErrorsPer90() const { return 90 * mostShareOfErrors; }
  Verdict verdict() const;
  bool toldApart() const { return verdict() == Verdict::toldApart; }
};

/// Symmetric; 0 for a button and itself. A few milliseconds. Any thread.
PredictedPair predictConfusion(const FeltButton& a, const FeltButton& b,
                               const ConfusionSettings& settings = {});

/// All pairs by pairs (0,1), (0,2), (1,2), ... `progress(done, all)` returns false to cancel; the result is
/// then empty.
std::vector<PredictedPair> predictAll(const std::vector<FeltButton>& buttons,
                                      const std::function<bool(std::size_t, std::size_t)>& progress = {},
                                      const ConfusionSettings& settings = {});

}  // namespace detent::playback
