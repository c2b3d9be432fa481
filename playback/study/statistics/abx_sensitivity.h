// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Distance of two stimuli (d') from the share of correct answers in ABX, for an unbiased observer. Macmillan
// & Creelman, Detection Theory: A User's Guide, ABX under two strategies. Any thread.

namespace detent::playback {

/// The participant's strategy of decision.
enum class AbxStrategy {
  differencing,            ///< mixed pairs ("roving"), as in Kim & Lee's shuffled list
  independentObservations  ///< a single known pair ("fixed")
};

/// Share of correct answers: 0.5 for d' = 0, approaching 1. `dPrime` >= 0.
double shareCorrect(double dPrime, AbxStrategy strategy);

/// The d' at which this share is expected. Shares up to 0.5 give 0; a share of 1 gives infinity, so use a
/// bound of the share instead.
double dPrimeOf(double shareCorrect, AbxStrategy strategy);

}  // namespace detent::playback
