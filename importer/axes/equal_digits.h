// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Print without antialiasing, in which equal digits have equal pixels. A digit that the text engine reads in
// one place is therefore the same digit wherever its shape recurs
// (docs/develop/decisions/0408-small-print.md).

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/axes/axis_calibration.h"

namespace detent::importer {

/// A letter's pixels, cut to its bounding box, and its sign.
struct LetterShape {
  int width = 0, height = 0;
  std::vector<std::uint8_t> isDark;  ///< row by row, 1 or 0
  char sign = 0;                     ///< 0: not known yet

  /// Returns true if at most one pixel in fifty differs, because compression changes single pixels.
  bool resembles(const LetterShape& other) const;
};

/// Returns true if words are drawn without antialiasing: hardly a pixel is between paper and full darkness.
/// `darkness`: of the view that contains the words; dark is high.
bool isUnsmoothed(const cv::Mat& darkness, const std::vector<Box>& words);

/// The shapes of a word's letters from left to right, separated by empty columns. The mask is 255 at dark
/// pixels, else 0.
std::vector<LetterShape> lettersOf(const cv::Mat& marks, const Box& word);

/// The evenly spaced numbers (three to twelve words, ordered along the axis) that have one digit per shape
/// and are nearest to what the text engine read. Empty if digits touch, if no scale fits the shapes, or if
/// the engine's reading does not decide between several scales. `rising`: values grow with the position.
std::optional<std::vector<std::string>> readEqualDigits(const std::vector<std::vector<LetterShape>>& words,
                                                        const std::vector<double>& centers_px, bool rising,
                                                        const std::vector<std::string>& engine);

/// The digit of each shape among the labels of both axes, each shape once. Empty if the print is antialiased
/// or if one shape was read as two digits. Darkness and mask are those of the view they were read in.
std::vector<LetterShape> digitsOf(const cv::Mat& darkness, const cv::Mat& marks, const AxisCalibration& axes);

/// The word as read, with the engine's characters replaced by the digits of known shapes.
std::string withKnownDigits(const std::string& utf8, const std::vector<LetterShape>& letters,
                            const std::vector<LetterShape>& known);

}  // namespace detent::importer
