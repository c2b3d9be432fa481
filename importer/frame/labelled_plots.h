// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where plots stand by their numbers alone: a row of words at even distances, and a column of them at its left end.
// Lines are not asked, so frames that are pale, broken, open or absent are found as well.
// docs/develop/decisions/0401-finding-plot-frames.md

#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// A place between two rows of labels, in pixels of the plane they were found in.
struct LabelledPlot {
  Box box;                  ///< from the column's last label to its first, from the row's first to its last
  int below = 0, left = 0;  ///< evenly spaced words on either axis
  double score = 0;         ///< higher is surer; comparable within one page
};

/// Best first, none overlapping a better one. Upright plots only. `ink`: of writing, 255 or 0.
std::vector<LabelledPlot> findLabelledPlots(const cv::Mat& ink, double minWidth_px, double minHeight_px);

}  // namespace detent::importer
