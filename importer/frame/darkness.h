// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Darkness of pixels: one channel, 0 = paper, 255 = full contrast, for any colours of paper and print.

#include <opencv2/core/mat.hpp>

#include "importer/frame/paper.h"
#include "importer/page/raster.h"

namespace detent::importer {

/// Contrast to the paper, 0..255, 8-bit, same size as the raster. By page: paper is the most frequent
/// luminance. By region: paper is the median around each pixel, which keeps edges between papers; about 40 ms
/// per megapixel.
cv::Mat darknessOf(const Raster& raster, PaperBy paper = PaperBy::page);

/// Luminance, 0..255, 8-bit.
cv::Mat luminanceOf(const Raster& raster);

}  // namespace detent::importer
