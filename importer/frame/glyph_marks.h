#pragma once
// Blobs of ink the size of letters, and rows of them: where numbers could stand, before anything is read.

#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// Boxes (pixel edges: a single pixel has width 1) of connected ink between `minSize_px` and `maxSize_px` in
/// its larger extent.
/// `threshold`: grey levels above paper that count as ink; 0: what stands out of its surroundings.
std::vector<Box> glyphBoxes(const cv::Mat& darkness, double minSize_px, double maxSize_px, int threshold = 0);

/// A copy without the inside of an upright frame and without the ticks that stick out of it, so that labels
/// stand free of them. `xLines`, `yLines`: where its gridlines and ticks are.
cv::Mat withoutFrameInk(const cv::Mat& darkness, const Box& frame, const std::vector<double>& xLines,
                        const std::vector<double>& yLines);

/// Widest gap between the characters of one number: a decimal point leaves almost a digit's width.
inline constexpr double labelGapInHeights = 0.6;

/// Glyphs that stand side by side, closer than `gap` of their height, joined into words. Reading direction is
/// +x.
std::vector<Box> wordBoxes(std::vector<Box> glyphs, double gapInHeights);

/// The box after the page was turned clockwise by 90° `quarterTurns` times about the origin.
Box turned(const Box& box, int quarterTurns);

}  // namespace detent::importer
