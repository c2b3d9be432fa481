// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Blobs of ink the size of letters, and rows of them: where numbers could stand, before anything is read.

#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// What stands out of its surroundings by writing's contrast: 255, else 0. Paper may shade.
cv::Mat inkOf(const cv::Mat& darkness);

/// What is darker than `threshold` grey levels above paper: 255, else 0.
cv::Mat inkAbove(const cv::Mat& darkness, int threshold);

/// Boxes (pixel edges: a single pixel has width 1) of connected ink between `minSize_px` and `maxSize_px` in
/// its larger extent.
std::vector<Box> glyphBoxes(const cv::Mat& ink, double minSize_px, double maxSize_px);

/// Whether a small mark hangs at a word's foot, as a comma does, which may share no more than a pixel's height with it.
bool isComma(const Box& mark, const Box& word);

/// Whether a flat mark lies at a word's foot or under it, as the stroke that parts the names of columns does.
bool isUnderscore(const Box& mark, const Box& word);

/// A number set so close to a title that runs upwards that a letter of it was taken up: the letter stands in a column with
/// others, nearer than one label to the next. `glyphs`: all of the page or of the place.
Box withoutTitleLetter(const Box& word, const std::vector<Box>& glyphs);

/// A copy of the ink without the inside of an upright frame and without the ticks that stick out of it, so
/// that labels stand free of them. `xLines`, `yLines`: where its gridlines and ticks are.
cv::Mat withoutFrameInk(const cv::Mat& ink, const Box& frame, const std::vector<double>& xLines,
                        const std::vector<double>& yLines);

/// Widest gap between the characters of one number: a decimal point leaves almost a digit's width.
inline constexpr double labelGapInHeights = 0.6;

/// Glyphs that stand side by side, closer than `gap` of their height, joined into words. Reading direction is
/// +x.
std::vector<Box> wordBoxes(std::vector<Box> glyphs, double gapInHeights);

/// Words as close as the characters of one number. A tick that reaches a label from the right is no minus sign: it is
/// left out of the word's box.
std::vector<Box> numberBoxes(const std::vector<Box>& glyphs);

/// The box after the page was turned clockwise by 90° `quarterTurns` times about the origin.
Box turned(const Box& box, int quarterTurns);

/// The box in a mirror: left for right, or above for below, about the origin.
Box leftForRight(const Box& box);
Box upsideDown(const Box& box);

}  // namespace detent::importer
