// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/drawn_text.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <opencv2/imgproc.hpp>

namespace detent::importer {
namespace {

constexpr int finer = 3;          // factor by which pixels are subdivided for the comparison
constexpr double blur_px = 0.45;  // blur in the page's own pixels, by their size and by scaling
constexpr int room_px = 3;        // margin around a word for trying positions
// shares of a digit's height, for descenders such as g, and for brackets
constexpr double below = 0.3, above = 0.15;

int fine(double px) { return std::max(1, static_cast<int>(std::lround(px * finer))); }

/// Width of a character in digit advances: between those of the sans-serif and serif fonts that plotting
/// programs use.
double advanceOf(char c) {
  switch (c) {
    case '.':
    case ' ':
      return 0.5;
    case 'i':
    case 'l':
      return 0.43;
    case 'f':
    case '/':
      return 0.52;
    case '(':
    case ')':
    case '[':
    case ']':
      return 0.6;
    case 'm':
      return 1.53;
    case 'N':
    case 'V':
    case 'A':
      return 1.22;
    case 'c':
    case 'k':
    case 's':
    case 'z':
      return 0.87;
    default:
      return 1;
  }
}

/// Correlation at the text's best position; -1 if it does not fit into the patch.
double likenessOf(const cv::Mat& patch, const cv::Mat& text) {
  if (text.cols > patch.cols || text.rows > patch.rows) return -1;
  cv::Mat alike;
  cv::matchTemplate(patch, text, alike, cv::TM_CCOEFF_NORMED);
  double best = 0;
  cv::minMaxLoc(alike, nullptr, &best);
  return best;
}

}  // namespace

double advancesOf(const std::string& ascii) {
  double sum = 0;
  for (const char c : ascii) sum += advanceOf(c);
  return sum;
}

cv::Mat finePatch(const cv::Mat& darkness, const Box& word, int quarterTurns) {
  constexpr int rim_px = 1;  // ticks and neighbours begin beyond this margin
  const cv::Rect marksBox(
      static_cast<int>(std::lround(word.x0 + 0.5)), static_cast<int>(std::lround(word.y0 + 0.5)),
      static_cast<int>(std::lround(word.width())), static_cast<int>(std::lround(word.height())));
  const auto grown = [&](int by) {
    return cv::Rect(marksBox.x - by, marksBox.y - by, marksBox.width + 2 * by, marksBox.height + 2 * by);
  };
  const cv::Rect all = grown(room_px), seen = grown(rim_px) & cv::Rect(0, 0, darkness.cols, darkness.rows);
  if (seen.empty()) return {};
  cv::Mat alone = cv::Mat::zeros(all.size(), CV_8U), patch;
  darkness(seen).copyTo(alone(seen - all.tl()));
  if (quarterTurns == 1) cv::rotate(alone, alone, cv::ROTATE_90_CLOCKWISE);
  if (quarterTurns == 3) cv::rotate(alone, alone, cv::ROTATE_90_COUNTERCLOCKWISE);
  cv::resize(alone, patch, {}, finer, finer, cv::INTER_CUBIC);
  return patch;
}

const cv::Mat& DrawnText::glyph(char c) {
  const auto [at, fresh] = glyphs_.try_emplace(c);
  if (!fresh) return at->second;
  constexpr double scale = 3;  // OpenCV's Hershey fonts are drawn large and reduced to the label's size
  constexpr int pen = 8;
  int ignored = 0;
  const int height = cv::getTextSize("0", hand_.font, scale, pen, &ignored).height;
  const std::string text(1, c);
  const int width = cv::getTextSize(text, hand_.font, scale, pen, &ignored).width;
  const int over = static_cast<int>(above * height) + pen / 2,
            under = static_cast<int>(below * height) + pen / 2;
  cv::Mat cell = cv::Mat::zeros(over + height + under, width, CV_8U);
  cv::putText(cell, text, {0, over + height}, hand_.font, scale, cv::Scalar(255), pen, cv::LINE_AA);
  cv::resize(cell, at->second,
             {fine(advanceOf(c) * hand_.advance_px), fine((1 + above + below) * hand_.height_px)}, 0, 0,
             cv::INTER_AREA);
  return at->second;
}

cv::Mat DrawnText::drawn(const std::string& ascii) {
  const int margin = finer, height = fine((1 + above + below) * hand_.height_px);
  cv::Mat canvas = cv::Mat::zeros(height, fine(advancesOf(ascii) * hand_.advance_px) + 2 * margin, CV_8U);
  double at = margin;
  for (const char c : ascii) {
    const cv::Mat& marks = glyph(c);
    cv::Mat place = canvas(cv::Rect(std::min(static_cast<int>(std::lround(at)), canvas.cols - marks.cols), 0,
                                    marks.cols, marks.rows));
    cv::max(place, marks, place);
    at += advanceOf(c) * hand_.advance_px * finer;
  }
  cv::GaussianBlur(canvas, canvas, {}, blur_px * finer);
  // Digits alone need no room above and below.
  const bool tall = ascii.find_first_not_of("0123456789.") != std::string::npos;
  if (tall) return canvas;
  const int over = static_cast<int>(above / (1 + above + below) * height),
            bottom = static_cast<int>(below / (1 + above + below) * height);
  const int top = std::max(0, over - margin), end = std::min(height, height - bottom + margin);
  return canvas.rowRange(top, end);
}

double DrawnText::likeness(const cv::Mat& patch, const std::string& ascii) {
  return likenessOf(patch, drawn(ascii));
}

double DrawnText::likenessAtEnd(const cv::Mat& patch, const std::string& ascii, double within_px) {
  const cv::Mat text = drawn(ascii);
  const int columns = std::min(patch.cols, text.cols + fine(room_px + within_px));
  return likenessOf(patch.colRange(patch.cols - columns, patch.cols), text);
}

}  // namespace detent::importer
