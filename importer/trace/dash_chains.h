// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines of dashes among ink that nothing explains, and curves drawn through that run over the gaps of one.
// Private to importer/trace.

#include <functional>
#include <vector>

#include <opencv2/core.hpp>

#include "importer/page/polyline.h"

namespace detent::importer::trace {

/// Nothing is drawn at a place of the area.
using BareAt = std::function<bool(Point)>;

/// The pixels of each line of four dashes and more, one behind the other at even gaps over bare paper. `ink`: 255 where it
/// is; lines are about `thickness_px` thick. What touches a curve (`curves`: 255 where one runs) is a rim of its markers.
std::vector<std::vector<Point>> dashChains(const cv::Mat& ink, const cv::Mat& curves, double thickness_px,
                                           const BareAt& isBare);

/// Points a pixel apart along a curve; a stretch of it by their numbers, the last included.
struct Stretch {
  std::size_t from = 0, to = 0;
  double pace_px = 0;  ///< usual, from one gap to the next
};

/// Stretches over which the points cross gaps at an even pace, as those of a line of dashes do.
std::vector<Stretch> dashedStretches(const std::vector<Point>& points, double thickness_px,
                                     const BareAt& isBare);

}  // namespace detent::importer::trace
