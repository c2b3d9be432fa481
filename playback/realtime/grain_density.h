// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Level of a grain among others: where grains touch, more of them per second are felt only as louder. Powers
// by square roots alone: the same bits on every machine.

#include <cmath>

namespace detent::playback {

/// Power of the density that grains are as loud as: 1.9 dB per doubling.
inline constexpr double levelByDensity = 0.3125;

/// Level of grains that come `density_per_s` times a second, of 1 at `loudest_per_s` and above. As quiet as
/// grains get where one has ended before the next begins, `alone_per_s` (> 0). No number counts as that.
inline double levelOfDensity(double density_per_s, double loudest_per_s, double alone_per_s) {
  const double heard_per_s = density_per_s > alone_per_s ? density_per_s : alone_per_s;
  const double share = heard_per_s < loudest_per_s ? heard_per_s / loudest_per_s : 1;
  static_assert(levelByDensity == 0.25 + 0.0625);
  const double fourthRoot = std::sqrt(std::sqrt(share));
  return fourthRoot * std::sqrt(std::sqrt(fourthRoot));
}

}  // namespace detent::playback
