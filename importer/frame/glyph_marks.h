#pragma once
// Blobs of ink the size of letters, and rows of them: where numbers could stand, before anything is read.

#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// Boxes (pixel edges: a single pixel has width 1) of connected ink between `minSize_px` and `maxSize_px` in
/// its larger extent.
std::vector<Box> glyphBoxes(const cv::Mat& darkness, double minSize_px, double maxSize_px);

/// Glyphs that stand side by side, closer than `gap` of their height, joined into words. Reading direction is
/// +x.
std::vector<Box> wordBoxes(std::vector<Box> glyphs, double gapInHeights);

/// The box after the page was turned clockwise by 90° `quarterTurns` times about the origin.
Box turned(const Box& box, int quarterTurns);

}  // namespace detent::importer
