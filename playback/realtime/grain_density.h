// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Level of a grain among others: grains that follow each other closely feel louder, not denser. Computed with
// square roots only, so that it has the same bits on every machine.

#include <cmath>

namespace detent::playback {

/// Exponent of the density in the loudness of grains: 1.9 dB per doubling.
inline constexpr double levelByDensity = 0.3125;

/// Level of grains at a rate of `density_per_s`: 1 at `loudest_per_s` and above. The lowest level is that at
/// `alone_per_s` (> 0), the rate at which one grain ends before the next begins. NaN counts as that rate.
inline double levelOfDensity(double density_per_s, double loudest_per_s, double alone_per_s) {
  const double heard_per_s = density_per_s > alone_per_s ? density_per_s : alone_per_s;
  const double share = heard_per_s < loudest_per_s ? heard_per_s / loudest_per_s : 1;
  static_assert(levelByDensity == 0.25 + 0.0625);
  const double fourthRoot = std::sqrt(std::sqrt(share));
  return fourthRoot * std::sqrt(std::sqrt(fourthRoot));
}

}  // namespace detent::playback
