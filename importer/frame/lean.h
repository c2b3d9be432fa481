// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tilt of a picture's lines: sheets scanned or photographed askew.

#include <opencv2/core/mat.hpp>

#include "importer/page/page.h"

namespace detent::importer {

/// Angle in degrees by which most lines run down to the right, within ±15. Returns 0 below 0.4, which later
/// steps tolerate, or if no direction stands out.
double leanOf(const cv::Mat& darkness);

/// Map to the page from the page rotated about its middle so that lines with a tilt of `lean_deg` are level.
Affine turnedToPage(const Page& page, double lean_deg);

}  // namespace detent::importer
