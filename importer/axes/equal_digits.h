// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Print whose equal digits are equal to the pixel, as programs draw it that smooth nothing: what the text
// engine makes of one digit at one place it has to make of it everywhere
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
  char sign = 0;                     ///< 0: not known

  /// But for a pixel in fifty: compression turns one at times.
  bool resembles(const LetterShape& other) const;
};

/// Returns true if words are drawn without antialiasing, with hardly an intermediate pixel. `darkness`: of
/// their view, dark is high.
bool isUnsmoothed(const cv::Mat& darkness, const std::vector<Box>& words);

/// The shapes of a word's letters from left to right, separated by empty columns. The mask is 255 at dark
/// pixels, else 0.
std::vector<LetterShape> lettersOf(const cv::Mat& marks, const Box& word);

/// Numbers in even steps (three to twelve words, ordered along the axis) that have the same digit where the
/// shape is the same and another one where it is not, nearest to what the engine read. Empty where digits
/// touch, where the shapes fit no scale, or several that the engine's reading does not tell apart. `rising`:
/// values grow with the place.
std::optional<std::vector<std::string>> readEqualDigits(const std::vector<std::vector<LetterShape>>& words,
                                                        const std::vector<double>& centers_px, bool rising,
                                                        const std::vector<std::string>& engine);

/// Digits with the shapes of the labels of both axes, each once; none if their print is smoothed or one sign
/// has two shapes. Darkness and mask are those of the view they were read in.
std::vector<LetterShape> digitsOf(const cv::Mat& darkness, const cv::Mat& marks, const AxisCalibration& axes);

/// The reading of a word with digits of known shape in place of the engine's.
std::string withKnownDigits(const std::string& utf8, const std::vector<LetterShape>& letters,
                            const std::vector<LetterShape>& known);

}  // namespace detent::importer
