// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Short texts drawn as a plotting program would, to be held against pixels too few for the text engine
// (docs/develop/decisions/0408-small-print.md).

#include <map>
#include <string>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// Style of drawn text. All labels of an axis share one style.
struct Hand {
  int font = 0;           ///< of OpenCV's Hershey fonts
  double height_px = 0;   ///< of a digit, > 0
  double advance_px = 0;  ///< from digit to digit, > 0
};

/// Width of a text in advances of a digit, as in common typefaces.
double advancesOf(const std::string& ascii);

/// Enlarged pixels of a word, upright, dark is high, with a margin for trying positions; empty outside the
/// picture. `quarterTurns`: clockwise, until the word stands upright.
cv::Mat finePatch(const cv::Mat& darkness, const Box& word, int quarterTurns = 0);

/// Texts in one hand, drawn on the pixels of finePatch(); each is drawn once.
class DrawnText {
 public:
  explicit DrawnText(const Hand& hand) : hand_(hand) {}

  /// Correlation of a patch's pixels with the text at its best place, -1 to 1; -1 where it has no room.
  double likeness(const cv::Mat& patch, const std::string& ascii);

  /// The same with a text that the patch's word ends with, give or take so many pixels of the page.
  double likenessAtEnd(const cv::Mat& patch, const std::string& ascii, double within_px);

 private:
  const cv::Mat& glyph(char c);
  cv::Mat drawn(const std::string& ascii);

  Hand hand_;
  std::map<char, cv::Mat> glyphs_;
};

}  // namespace detent::importer
