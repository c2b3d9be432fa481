// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Marks in a row where a curve ends: a curve drawn by nothing but its marks goes on with them. Private to importer/trace.

#include <vector>

#include <opencv2/core.hpp>

#include "importer/page/raster.h"

namespace detent::importer::trace {

/// For each end of a curve the pixels of four marks and more, alike in size, one above the other from there on as those on its
/// wall are; none where there are fewer. `ink`: 255 where nothing explains it, `curves`: where one runs; ends in their pixels. What runs on flat may be the
/// letters of the curve's name.
std::vector<std::vector<Point>> marksUpFrom(const std::vector<Point>& ends, const cv::Mat& ink,
                                            const cv::Mat& curves);

}  // namespace detent::importer::trace
