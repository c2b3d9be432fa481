// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A document may show one graph twice, for example on the drawing and on the page with the load curve. Copies
// are recognised by equal axes and nearly equal strokes; the better drawn one is imported
// (docs/develop/decisions/0812-several-readings.md).

#include <optional>

#include "importer/axes/axis_calibration.h"
#include "importer/strokes/stroke_pair.h"

namespace detent::importer {

/// Returns true if units are equal and ranges agree within one hundredth, so that tracing both graphs is
/// worthwhile.
bool haveSameAxes(const AxisCalibration& a, const AxisCalibration& b);

/// Mean distance of either pair's points from the other's lines, each axis as a share of the first pair's
/// span; nullopt if only one of them has a release, or either has too few points.
std::optional<double> distanceBetween(const StrokePair& a, const StrokePair& b);

/// Largest distance of two copies. Copies differ a little because each is drawn, scanned and traced
/// separately; different switches on equal axes are farther apart.
inline constexpr double copiesWithin = 0.015;

/// Rank of a copy, to choose one.
struct CopyRank {
  double confidence = 0;   ///< confidence of the whole reading, 0..1
  bool exact = false;      ///< strokes from the document's own paths
  double framePixels = 0;  ///< area of the frame in the view
};

/// Returns true if `a` has the higher confidence; of equal ones, if it comes from the document's own paths;
/// then if it is drawn larger.
bool isBetterCopy(const CopyRank& a, const CopyRank& b);

}  // namespace detent::importer
