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

/// A letter's pixels, cut to its ink, and what it stands for.
struct LetterShape {
  int width = 0, height = 0;
  std::vector<std::uint8_t> ink;  ///< row by row, 1 or 0
  char sign = 0;                  ///< 0: not known

  /// But for a pixel in fifty: compression turns one at times.
  bool looksLike(const LetterShape& other) const;
};

/// Whether words are drawn in full ink and paper alone, with hardly a pixel between. `darkness`: of their
/// view, ink high.
bool isUnsmoothed(const cv::Mat& darkness, const std::vector<Box>& words);

/// The shapes of a word's letters from left to right, told apart by columns without ink. `ink`: 255 where ink
/// is, else 0.
std::vector<LetterShape> lettersOf(const cv::Mat& ink, const Box& word);

/// Numbers in even steps (three to twelve words, ordered along the axis) that have the same digit where the
/// shape is the same and another one where it is not, nearest to what the engine read. Empty where digits
/// touch, where the shapes fit no scale, or several that the engine's reading does not tell apart. `rising`:
/// values grow with the place.
std::optional<std::vector<std::string>> readEqualDigits(const std::vector<std::vector<LetterShape>>& words,
                                                        const std::vector<double>& centers_px, bool rising,
                                                        const std::vector<std::string>& engine);

/// Digits whose shapes the labels of both axes tell, each once; none where their print is smoothed or one
/// sign has two shapes. `darkness` and `ink` of the view they were read in.
std::vector<LetterShape> digitsOf(const cv::Mat& darkness, const cv::Mat& ink, const AxisCalibration& axes);

/// What was read of a word with known shapes' digits in place of what the engine made of them.
std::string withKnownDigits(const std::string& utf8, const std::vector<LetterShape>& letters,
                            const std::vector<LetterShape>& known);

}  // namespace detent::importer
