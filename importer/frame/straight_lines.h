// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Straight lines along the page's axes, possibly slightly tilted: frames, gridlines, tables, drawings.

#include <vector>

#include <opencv2/core/mat.hpp>

namespace detent::importer {

/// A line in one direction. "along" is x for horizontal and y for vertical lines, "across" is the other. In
/// pixels of the darkness plane.
struct StraightLine {
  double from = 0, to = 0;              ///< ends, along
  double acrossFrom = 0, acrossTo = 0;  ///< position across the line at its ends
  double fill = 1;                      ///< share of the length that is dark; below 1 for dashes and gaps
  double length() const { return to - from; }
  double acrossAt(double along) const {
    return length() > 0 ? acrossFrom + (acrossTo - acrossFrom) * (along - from) / length() : acrossFrom;
  }
  double slope() const { return length() > 0 ? (acrossTo - acrossFrom) / length() : 0; }
};

struct LineSet {
  std::vector<StraightLine> horizontal, vertical;
};

/// Finds lines of at least `minLength_px`, darker than both sides, tilted by less than 3°. Fragments stay
/// apart where a gap is wider than `maxGap_px`.
LineSet findStraightLines(const cv::Mat& darkness, double minLength_px, double maxGap_px);

}  // namespace detent::importer
