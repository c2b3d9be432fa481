// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pixels as ink: one channel, 0 = paper, 255 = full ink, whatever the colours of paper and ink are.

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// Luminance of paper minus luminance of the pixel, clipped to 0..255; on dark paper the other way round.
/// Paper is the most frequent luminance. 8-bit, same size as the raster.
cv::Mat darknessOf(const Raster& raster);

/// True if most of the raster is dark, so that its ink is light.
bool hasDarkPaper(const Raster& raster);

}  // namespace detent::importer
