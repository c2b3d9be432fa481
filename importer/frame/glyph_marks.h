// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Letter-sized blobs and rows of them: possible places of tick labels, before anything is read.

#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// Returns 255 where a pixel differs from its surroundings by the contrast of text, else 0. Paper may be
/// shaded.
cv::Mat darkMaskOf(const cv::Mat& darkness);

/// Returns 255 where a pixel is darker than paper by more than `threshold` grey levels, else 0.
cv::Mat marksAbove(const cv::Mat& darkness, int threshold);

/// Bounding boxes (pixel edges: a single pixel has width 1) of connected components with a larger extent
/// between `minSize_px` and `maxSize_px`.
std::vector<Box> glyphBoxes(const cv::Mat& marks, double minSize_px, double maxSize_px);

/// Returns true if a small mark hangs at a word's baseline like a comma; it may share as little as one pixel
/// row with the word.
bool isComma(const Box& mark, const Box& word);

/// Returns true if a flat mark lies at or under a word's baseline like an underscore.
bool isUnderscore(const Box& mark, const Box& word);

/// Removes a letter of a vertical title from a label that stands too close to it. The letter is part of a
/// column of letters that lie closer together than labels do. `glyphs`: all of the page or the region.
Box withoutTitleLetter(const Box& word, const std::vector<Box>& glyphs);

/// A copy without the inside of an upright frame and without its outer ticks, so that labels are separate.
/// `xLines`, `yLines`: positions of gridlines and ticks.
cv::Mat withoutFrameMarks(const cv::Mat& marks, const Box& frame, const std::vector<double>& xLines,
                          const std::vector<double>& yLines);

/// Widest gap between the characters of one number, in heights; a decimal point leaves almost a digit's
/// width.
inline constexpr double labelGapInHeights = 0.6;

/// Joins glyphs closer than `gap` of their height into words. Reading direction is +x.
std::vector<Box> wordBoxes(std::vector<Box> glyphs, double gapInHeights);

/// Joins characters of numbers. A tick that reaches a label from the right is no minus sign and is left out
/// of the box.
std::vector<Box> numberBoxes(const std::vector<Box>& glyphs);

/// The box after rotating the page clockwise by 90° `quarterTurns` times about the origin.
Box turned(const Box& box, int quarterTurns);

/// The box mirrored left to right, or top to bottom, about the origin.
Box leftForRight(const Box& box);
Box upsideDown(const Box& box);

}  // namespace detent::importer
