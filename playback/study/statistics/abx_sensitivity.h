// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Distance of two stimuli (d') from the share of right answers in ABX, unbiased observer. Macmillan &
// Creelman, Detection Theory: A User's Guide, ABX under two strategies. Any thread.

namespace detent::playback {

/// The participant's strategy of decision.
enum class AbxStrategy {
  differencing,            ///< pairs are mixed ("roving"), as in Kim & Lee's shuffled list
  independentObservations  ///< one pair that is known ("fixed")
};

/// Share of right answers, 0.5 for d' = 0, towards 1. `dPrime` >= 0.
double shareCorrect(double dPrime, AbxStrategy strategy);

/// The inverse. Shares up to 0.5 give 0; from 1 on infinity: give a bound of the share instead.
double dPrimeOf(double shareCorrect, AbxStrategy strategy);

}  // namespace detent::playback
