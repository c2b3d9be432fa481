// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads labels that are too small for the text engine, all labels of an axis together: they are evenly
// spaced, so the digits that are clear determine those that the pixels leave open
// (docs/develop/decisions/0408-small-print.md).

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// The numbers of one axis, read from their pixels.
struct SmallLabels {
  std::vector<std::string> texts;  ///< one per word, in its order
  double likeness = 0;  ///< lowest correlation of a label's pixels with the text read there, at most 1
};

/// Largest height of digits that are read together. The text engine reads larger ones.
constexpr double smallDigits_px = 8.5;

/// Reads the words of a row or a column (three to twelve, ordered along the axis; `centers_px` along it) as
/// evenly spaced numbers. `darkness`: of their view; a high value is dark. `rising`: values grow with the
/// position. Empty if no evenly spaced numbers of such widths resemble the pixels, or if several do equally.
std::optional<SmallLabels> readSmallLabels(const cv::Mat& darkness, const std::vector<Box>& words,
                                           const std::vector<double>& centers_px, bool rising);

}  // namespace detent::importer
