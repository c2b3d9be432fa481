// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Dashed lines among unexplained pixels, and traced curves that run over the gaps of one. Private to
// importer/trace.

#include <functional>
#include <vector>

#include <opencv2/core.hpp>

#include "importer/page/polyline.h"

namespace detent::importer::trace {

/// Returns true if nothing is drawn at a place of the area.
using BareAt = std::function<bool(Point)>;

/// Pixels of each line of four or more dashes at even gaps on bare paper. The mask is 255 where coverage is;
/// lines are about `thickness_px` thick. Marks that touch a curve (`curves`: 255) are rims of its markers.
std::vector<std::vector<Point>> dashChains(const cv::Mat& marks, const cv::Mat& curves, double thickness_px,
                                           const BareAt& isBare);

/// Points one pixel apart along a curve; a stretch by their indices, last included.
struct Stretch {
  std::size_t from = 0, to = 0;
  double pace_px = 0;  ///< usual distance from one gap to the next
};

/// Stretches where the points cross gaps at an even distance, as along a dashed line.
std::vector<Stretch> dashedStretches(const std::vector<Point>& points, double thickness_px,
                                     const BareAt& isBare);

}  // namespace detent::importer::trace
