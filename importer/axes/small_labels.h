// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Labels too small for the text engine, read together: tick labels are evenly spaced, so that the digits of
// all settle those that a few pixels leave open (docs/develop/decisions/0408-small-print.md).

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// The numbers of one axis, as far as their pixels tell.
struct SmallLabels {
  std::vector<std::string> texts;  ///< one per word, in its order
  double likeness = 0;  ///< of the least alike label to what is read there, correlation of pixels, up to 1
};

/// Highest digits that are read together; larger ones the engine reads.
constexpr double smallDigits_px = 8.5;

/// Reads words of a row or a column (three to twelve, ordered along the axis, `centers_px` along it) as
/// numbers in even steps. `darkness`: of their view, dark is high. `rising`: values grow with the position.
/// Empty if no even numbers of the words' widths are similar enough, or several are.
std::optional<SmallLabels> readSmallLabels(const cv::Mat& darkness, const std::vector<Box>& words,
                                           const std::vector<double>& centers_px, bool rising);

}  // namespace detent::importer
