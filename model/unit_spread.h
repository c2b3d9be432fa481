// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Several units of one button as one: the mean, how far the units scatter around it, and which of them is odd.

#include <cstddef>
#include <vector>

#include "model/button.h"
#include "model/key_figures.h"

namespace detent {

/// One key figure over the units that have it.
struct FigureSpread {
  KeyFigure figure = KeyFigure::peakForce;
  std::size_t units = 0;    ///< that have it, >= 1
  double mean = 0, sd = 0;  ///< mm, N, N/mm, mJ, or a share; sd of a unit, n - 1; 0 of a single one
  double least = 0, most = 0;
};

/// Forces of the units at one displacement.
struct BandPoint {
  double displacement_mm = 0;
  double mean_N = 0, sd_N = 0;  ///< sd of a unit, n - 1
};

/// What the units' forces at each displacement say, over the travel that all of them have.
using ToleranceBand = std::vector<BandPoint>;

struct StateSpread {
  std::vector<FigureSpread> figures;  ///< those that any unit has, in the order of KeyFigure
  ToleranceBand press, release;       ///< 201 points each; the release empty where a unit has none
};

struct UnitSpread {
  Button mean;                      ///< aligned by features (blend.h), with few knots
  std::vector<StateSpread> states;  ///< as the mean's
  std::vector<double>
      distance_N;  ///< per unit: rms from the median of all over the press to its first bottom-out
  std::vector<std::size_t>
      outliers;  ///< units more than `outlierRatio` times the median distance away; in the mean like all others
};

/// Of units that scatter alike, 5 of them or 20, fewer than one in a hundred is this far out.
inline constexpr double outlierRatio = 5;
/// Fewer cannot say which of them is odd: none is marked.
inline constexpr std::size_t fewestForOutliers = 4;

/// Two units or more, all momentary or all self-locking. Failure wrongUsage: otherwise, or without a travel that all have. Any thread.
Result<UnitSpread> spreadOf(const std::vector<Button>& units, const SectionSettings& settings = {});

}  // namespace detent
