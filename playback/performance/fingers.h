// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The simulated people of the forecast: 64 fingers from a fixed seed (docs/reference/press-forecast.md,
// "Fingers").

#include <vector>

namespace detent::playback {

/// One finger and the muscle behind it. Ranges are those of the population.
struct Finger {
  double mass_kg = 0.012;              ///< 0.008..0.016
  double pulp_N_per_m = 1500;          ///< 800..3000
  double pulpDamping_Ns_per_m = 4;     ///< 2..6, while the pulp is being compressed
  double amplitudeSpread = 0.2;        ///< 0.10..0.25: standard deviation of an amplitude / the amplitude
  double muscleRise_s = 0.03;          ///< 0.02..0.04
  double muscleFall_s = 0.045;         ///< 1.5 times the rise
  double extensorShare = 1;            ///< 0.7..1.3, times 0.6 of the amplitude
  double feedbackDelay_s = 0.08;       ///< 0.06..0.10
  double restingWeightMedian_N = 0.4;  ///< median weight of this finger at rest
};

/// Spread of one finger's resting weight, in the logarithm.
inline constexpr double restingSpreadWithin = 0.30;

/// Number of fingers of a forecast.
inline constexpr int fingerCount = 64;

/// The population: each range is divided into as many equal parts as there are fingers, and each finger gets
/// one part of each. Always the same.
std::vector<Finger> allFingers();

}  // namespace detent::playback
