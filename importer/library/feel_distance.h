// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far apart two switches feel, by their curves, in units of what two laboratories differ by on one switch.

#include "importer/library/felt_shape.h"

namespace detent::importer {

/// Median rms difference of the press of one switch between two laboratories, over 33 switches that both measured. Below it nobody can
/// say that two records are of different switches.
inline constexpr double labNoise_gf = 3.5;

/// d^2 = (press rms)^2 + (w1 release rms)^2 + (w2 slope rms)^2 + (w3 difference in travel)^2, over the displacements both have.
struct FeelWeights {
  double release = 0.7;   ///< gf per gf
  double slope_mm = 0.1;  ///< gf per gf/mm
  double travel_gf_per_mm = 10;
};

/// One side of many comparisons: what does not depend on the other.
class FeelDistance {
 public:
  explicit FeelDistance(const FeltShape& wanted, const FeelWeights& weights = {});
  /// >= 0, in units of lab noise; 0 to itself.
  double to(const FeltShape& other) const;

 private:
  FeltShape wanted_;
  FeelWeights weights_;
};

}  // namespace detent::importer
