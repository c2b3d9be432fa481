// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far a picture's lines lean: sheets that were scanned or photographed askew.

#include <opencv2/core/mat.hpp>

#include "importer/page/page.h"

namespace detent::importer {

/// Degrees by which most lines of a picture run down to the right, within ±15; 0 where they do so by less than 0.4, which
/// the steps take as it is, or where no direction stands out.
double leanOf(const cv::Mat& darkness);

/// From the page turned about its middle, so that lines which ran down to the right by `lean_deg` run level, to the page.
Affine turnedToPage(const Page& page, double lean_deg);

}  // namespace detent::importer
