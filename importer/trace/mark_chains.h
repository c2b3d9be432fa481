// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows of markers at a curve's end: a curve drawn by its markers alone continues with them. Private to
// importer/trace.

#include <vector>

#include <opencv2/core.hpp>

#include "importer/page/raster.h"

namespace detent::importer::trace {

/// For each end of a curve the pixels of four or more markers of similar size, one above the other; empty if
/// there are fewer. The mask is 255 where unexplained, `curves`: 255 where one runs; ends in their pixels.
/// Flat rows may be letters of the curve's name.
std::vector<std::vector<Point>> marksUpFrom(const std::vector<Point>& ends, const cv::Mat& marks,
                                            const cv::Mat& curves);

}  // namespace detent::importer::trace
