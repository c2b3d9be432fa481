// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds plots by tick labels alone: a row of evenly spaced words, and a column at its left end. Needs no
// lines, so it also finds frames that are pale, broken, open or absent.
// docs/develop/decisions/0401-finding-plot-frames.md

#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// Region between a row and a column of labels, in pixels of the plane.
struct LabelledPlot {
  Box box;                  ///< from the column's last label to its first, from the row's first to its last
  int below = 0, left = 0;  ///< evenly spaced words on either axis
  double score = 0;         ///< higher is surer; comparable within one page
};

/// Best first, without overlaps. Upright plots only. Text pixels are 255, others 0.
std::vector<LabelledPlot> findLabelledPlots(const cv::Mat& marks, double minWidth_px, double minHeight_px);

}  // namespace detent::importer
