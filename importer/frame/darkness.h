// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pixels as ink: one channel, 0 = paper, 255 = full ink, whatever the colours of paper and ink are.

#include <opencv2/core/mat.hpp>

#include "importer/frame/paper.h"
#include "importer/page/raster.h"

namespace detent::importer {

/// Contrast to the paper, 0..255, 8-bit, same size as the raster. By page: paper is the most frequent luminance. By
/// region: the median around each pixel, which keeps its step where one paper meets the next; about 40 ms per megapixel.
cv::Mat darknessOf(const Raster& raster, PaperBy paper = PaperBy::page);

/// As it is, 0..255, 8-bit.
cv::Mat luminanceOf(const Raster& raster);

}  // namespace detent::importer
