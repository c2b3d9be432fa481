// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Documents show one graph twice: on the drawing page and on the page of its load curve. Copies are known by
// their axes and by where their strokes run, and the better drawn one is imported
// (docs/develop/decisions/0812-several-readings.md).

#include <optional>

#include "importer/axes/axis_calibration.h"
#include "importer/strokes/stroke_pair.h"

namespace detent::importer {

/// Same units and, within one hundredth, the same ranges: worth tracing both.
bool haveSameAxes(const AxisCalibration& a, const AxisCalibration& b);

/// Mean distance of either pair's points from the other's lines, each axis as a share of the first pair's
/// span; nullopt if only one of them has a release, or either has too few points.
std::optional<double> distanceBetween(const StrokePair& a, const StrokePair& b);

/// Copies are drawn, scanned and traced apart: this near, they are one graph. Different switches on equal
/// axes are farther apart.
inline constexpr double copiesWithin = 0.015;

/// Rank of a copy, to choose one.
struct CopyRank {
  double confidence = 0;   ///< of the whole reading, 0..1
  bool exact = false;      ///< strokes from the document's own paths
  double framePixels = 0;  ///< area of the frame in the view
};

/// The surer one; of equally sure ones the exact one, then the one drawn larger.
bool isBetterCopy(const CopyRank& a, const CopyRank& b);

}  // namespace detent::importer
