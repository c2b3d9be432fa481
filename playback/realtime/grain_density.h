// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How loud a grain is among others: where grains touch, more of them in a second are felt as nothing but louder. Powers by square
// roots alone: the same bits on every machine.

#include <cmath>

namespace detent::playback {

/// Level of grains that come `density_per_s` times a second, of 1 at `loudest_per_s` and above: density^(3/8), 2.3 dB per doubling. As
/// quiet as grains get where one has ended before the next begins, `alone_per_s` (> 0). No number counts as that.
inline double levelOfDensity(double density_per_s, double loudest_per_s, double alone_per_s) {
  const double heard_per_s = density_per_s > alone_per_s ? density_per_s : alone_per_s;
  const double share = heard_per_s < loudest_per_s ? heard_per_s / loudest_per_s : 1;
  return std::sqrt(std::sqrt(share * std::sqrt(share)));
}

}  // namespace detent::playback
