// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Draws short texts as a plotting program would, to compare them with print that is too small for the text
// engine (docs/develop/decisions/0408-small-print.md).

#include <map>
#include <string>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// Style of drawn text. All labels of an axis share one style.
struct Hand {
  int font = 0;           ///< number of one of OpenCV's Hershey fonts
  double height_px = 0;   ///< height of a digit, > 0
  double advance_px = 0;  ///< distance from digit to digit, > 0
};

/// Width of a text in advances of a digit, as in common typefaces.
double advancesOf(const std::string& ascii);

/// Enlarged pixels of a word, upright, dark is high, with a margin for trying positions; empty outside the
/// picture. `quarterTurns`: clockwise, until the word stands upright.
cv::Mat finePatch(const cv::Mat& darkness, const Box& word, int quarterTurns = 0);

/// Texts drawn in one style on the pixel grid of finePatch(). Each text is drawn once and kept.
class DrawnText {
 public:
  explicit DrawnText(const Hand& hand) : hand_(hand) {}

  /// Correlation of a patch's pixels with the text at its best position, -1 to 1; -1 if the text does not fit
  /// into the patch.
  double likeness(const cv::Mat& patch, const std::string& ascii);

  /// The same for a text at the end of the patch's word, displaced by at most `within_px` pixels of the page.
  double likenessAtEnd(const cv::Mat& patch, const std::string& ascii, double within_px);

 private:
  const cv::Mat& glyph(char c);
  cv::Mat drawn(const std::string& ascii);

  Hand hand_;
  std::map<char, cv::Mat> glyphs_;
};

}  // namespace detent::importer
