// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Straight lines that run along the page's axes, possibly a little askew: frames, gridlines, tables,
// drawings.

#include <vector>

#include <opencv2/core/mat.hpp>

namespace detent::importer {

/// A line along one direction. "along" is x for horizontal lines and y for vertical ones, "across" is the
/// other. All in pixels of the darkness plane it was found in.
struct StraightLine {
  double from = 0, to = 0;              ///< ends, along
  double acrossFrom = 0, acrossTo = 0;  ///< position at those ends
  double fill = 1;                      ///< share of the length that is ink; below 1 for dashes and holes
  double length() const { return to - from; }
  double acrossAt(double along) const {
    return length() > 0 ? acrossFrom + (acrossTo - acrossFrom) * (along - from) / length() : acrossFrom;
  }
  double slope() const { return length() > 0 ? (acrossTo - acrossFrom) / length() : 0; }
};

struct LineSet {
  std::vector<StraightLine> horizontal, vertical;
};

/// Lines of at least `minLength_px`, darker than their two sides, askew by less than 3°. Fragments of one
/// line stay apart where a gap is wider than `maxGap_px`.
LineSet findStraightLines(const cv::Mat& darkness, double minLength_px, double maxGap_px);

}  // namespace detent::importer
