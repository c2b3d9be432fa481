// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Several units of one button: their mean, spread and outliers.

#include <cstddef>
#include <optional>
#include <vector>

#include "model/button.h"
#include "model/key_figures.h"

namespace detent {

/// One key figure over the units that have it.
struct FigureSpread {
  KeyFigure figure = KeyFigure::peakForce;
  std::size_t units = 0;     ///< number of units that have the figure, >= 1
  double mean = 0;           ///< mm, N, N/mm, mJ, or a share
  std::optional<double> sd;  ///< standard deviation of a unit (n - 1); none if a single unit has the figure
  double least = 0, most = 0;
};

/// Forces of the units at one displacement.
struct BandPoint {
  double displacement_mm = 0;
  double mean_N = 0, sd_N = 0;  ///< force of the mean button; standard deviation of a unit from it (n - 1)
};

/// The mean button's force, and the units' deviation from it, at each displacement of the common travel.
using ToleranceBand = std::vector<BandPoint>;

struct StateSpread {
  std::vector<FigureSpread> figures;  ///< figures that any unit has, in the order of KeyFigure
  ToleranceBand press, release;       ///< 201 points each; release empty if a unit has none
};

struct UnitSpread {
  Button mean;                      ///< aligned by features (blend.h), with few knots
  std::vector<StateSpread> states;  ///< states of the mean, in order
  std::vector<double>
      distance_N;  ///< per unit: rms distance from the median press of all units, up to the first bottom-out
  std::vector<std::size_t>
      outliers;  ///< units more than `outlierRatio` times the median distance away; included in the mean
};

/// Of 5 to 20 units with equal scatter, fewer than one in a hundred is this far out.
inline constexpr double outlierRatio = 5;
/// With fewer units no outlier is marked.
inline constexpr std::size_t fewestForOutliers = 4;

/// Two or more units, all momentary or all self-locking. Failure wrongUsage: otherwise, or without a common
/// travel. Any thread.
Result<UnitSpread> spreadOf(const std::vector<Button>& units, const SectionSettings& settings = {});

}  // namespace detent
