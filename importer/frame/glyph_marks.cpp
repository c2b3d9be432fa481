// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/glyph_marks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <numeric>

#include <opencv2/imgproc.hpp>

#include "importer/page/pixel_components.h"
#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

constexpr int maxHalfEdge_px = 12;  // half of the thickest frame line
constexpr int paperWindow_px = 61;
constexpr int markContrast = 34;  // grey levels; light gridlines have less, or are too long for letters

bool besides(const Box& left, const Box& right, double gapInHeights) {
  const double height = std::max(left.height(), right.height());
  const double overlap = std::min(left.y1, right.y1) - std::max(left.y0, right.y0);
  return (overlap >= 0.4 * std::min(left.height(), right.height()) || isComma(right, left) ||
          isUnderscore(right, left)) &&
         right.x0 - left.x1 <= gapInHeights * height;
}

/// Width of the dark run around column `x` in one row, at most `atMost`; 0 if there is none within a pixel.
int darkRunWidth(const std::uint8_t* row, int cols, int x, int atMost) {
  int middle = -1;
  for (const int k : {x, x - 1, x + 1})
    if (middle < 0 && k >= 0 && k < cols && row[k] >= 128) middle = k;
  if (middle < 0) return 0;
  int l = middle, r = middle;
  while (l > 0 && r - l < atMost && row[l - 1] >= 128) --l;
  while (r + 1 < cols && r - l < atMost && row[r + 1] >= 128) ++r;
  return r - l + 1;
}

/// Thickness of a nearly vertical line at column `x` between two rows; 0 if there is none.
int lineThickness(const cv::Mat& marks, double x, int y0, int y1) {
  if (marks.cols < 4) return 0;
  const int at = std::clamp(static_cast<int>(std::lround(x)), 1, marks.cols - 2);
  std::vector<int> widths;
  for (int y = std::max(0, y0); y < std::min(marks.rows, y1); y += 3)
    if (const int w = darkRunWidth(marks.ptr<std::uint8_t>(y), marks.cols, at, 2 * maxHalfEdge_px); w > 0)
      widths.push_back(w);
  return medianOf(std::move(widths));
}

/// Thickness of a nearly horizontal line at row `y` between two columns; 0 if there is none.
int rowLineThickness(const cv::Mat& marks, double y, int x0, int x1) {
  if (marks.rows < 4) return 0;
  const int at = std::clamp(static_cast<int>(std::lround(y)), 1, marks.rows - 2);
  const int from = std::max(0, at - 2 * maxHalfEdge_px - 2);
  const int to = std::min(marks.rows, at + 2 * maxHalfEdge_px + 3);
  return lineThickness(marks.rowRange(from, to).t(), at - from, x0, x1);
}

/// Length of each column's line from row 0 down until it gets wider: its tick. Wider marks are labels close
/// to it.
std::vector<int> ticksBelow(const cv::Mat& d, const std::vector<double>& columns, int atMost, int thickest) {
  std::vector<int> lengths;
  for (const double at : columns) {
    const int x = std::clamp(static_cast<int>(std::lround(at)), 1, d.cols - 2);
    const int width = darkRunWidth(d.ptr<std::uint8_t>(0), d.cols, x, atMost);
    int n = 0;
    while (width > 0 && width <= thickest && n < atMost && n < d.rows) {
      const int here = darkRunWidth(d.ptr<std::uint8_t>(n), d.cols, x, atMost);
      if (here == 0 || here > width + 2) break;
      ++n;
    }
    lengths.push_back(n);
  }
  return lengths;
}

/// Modal run length if so many runs agree that they are ticks; 0 if they are labels that touch the edge.
int commonLength(const std::vector<int>& lengths) {
  int best = 0, bestCount = 0, positive = 0;
  for (const int n : lengths) {
    if (n <= 0) continue;
    ++positive;
    const auto count = static_cast<int>(
        std::count_if(lengths.begin(), lengths.end(), [n](int m) { return m > 0 && std::abs(m - n) <= 1; }));
    if (count > bestCount || (count == bestCount && n < best)) {
      best = n;
      bestCount = count;
    }
  }
  const bool ticks =
      bestCount >= 3 && 2 * bestCount >= positive && 5 * positive >= static_cast<int>(lengths.size());
  return ticks ? best : 0;
}

int longestTick(double frameHeight) { return std::max(4, static_cast<int>(0.1 * frameHeight)); }

/// Erases ticks below the frame's edge, which is row 0. A run longer than the others ends in a label, which
/// is kept. Rows beyond `longest` + 1 are not examined.
void eraseTicksBelow(cv::Mat& d, const std::vector<double>& columns, int longest, int thickest) {
  if (d.cols < 4 || columns.empty()) return;
  const auto lengths = ticksBelow(d, columns, longest, thickest);
  const int common = commonLength(lengths);
  if (common == 0 || common >= longest) return;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const int length = std::min(lengths[i], common + 1);
    const int at = std::clamp(static_cast<int>(std::lround(columns[i])), 1, d.cols - 2);
    const int half = darkRunWidth(d.ptr<std::uint8_t>(0), d.cols, at, longest) / 2 + 2;
    const int x0 = std::clamp(at - half, 0, d.cols), x1 = std::clamp(at + half + 1, 0, d.cols);
    d(cv::Rect(x0, 0, x1 - x0, std::min(d.rows, length + 1))).setTo(0);
  }
}

}  // namespace

bool isComma(const Box& mark, const Box& word) {
  constexpr double largest = 0.5, baseline = 0.6, below = 0.1;  // share of the word's height
  const double height = word.height();
  return mark.height() <= largest * height && mark.width() <= largest * height &&
         mark.y0 >= word.y0 + baseline * height && mark.y0 <= word.y1 + below * height;
}

bool isUnderscore(const Box& mark, const Box& word) {
  constexpr double flat = 0.2, narrowest = 0.3, widest = 1.2, baseline = 0.8,
                   below = 0.35;  // share of the word's height
  const double height = word.height();
  return mark.height() <= flat * height && mark.width() >= narrowest * height &&
         mark.width() <= widest * height && mark.y0 >= word.y0 + baseline * height &&
         mark.y1 <= word.y1 + below * height;
}

cv::Mat withoutFrameMarks(const cv::Mat& marks, const Box& frame, const std::vector<double>& xLines,
                          const std::vector<double>& yLines) {
  int x0 = std::clamp(static_cast<int>(std::floor(frame.x0)) - 1, 0, marks.cols);
  int x1 = std::clamp(static_cast<int>(std::ceil(frame.x1)) + 2, 0, marks.cols);
  int y0 = std::clamp(static_cast<int>(std::floor(frame.y0)) - 1, 0, marks.rows);
  int y1 = std::clamp(static_cast<int>(std::ceil(frame.y1)) + 2, 0, marks.rows);
  cv::Mat out = marks.clone();
  if (x1 <= x0 || y1 <= y0) return out;
  // Thick edges extend beyond their middle.
  const auto lined = [&](const cv::Mat& strip) {
    return cv::countNonZero(strip) > 0.35 * static_cast<double>(strip.total());
  };
  for (int k = 0; k < maxHalfEdge_px && x0 > 0 && lined(marks(cv::Rect(x0 - 1, y0, 1, y1 - y0))); ++k) --x0;
  for (int k = 0; k < maxHalfEdge_px && x1 < marks.cols && lined(marks(cv::Rect(x1, y0, 1, y1 - y0))); ++k)
    ++x1;
  for (int k = 0; k < maxHalfEdge_px && y0 > 0 && lined(marks(cv::Rect(x0, y0 - 1, x1 - x0, 1))); ++k) --y0;
  for (int k = 0; k < maxHalfEdge_px && y1 < marks.rows && lined(marks(cv::Rect(x0, y1, x1 - x0, 1))); ++k)
    ++y1;
  // Antialiasing remains beside an edge.
  x0 = std::max(0, x0 - 1);
  y0 = std::max(0, y0 - 1);
  x1 = std::min(marks.cols, x1 + 1);
  y1 = std::min(marks.rows, y1 + 1);
  const int thickness =
      std::max({lineThickness(marks, frame.x0, y0, y1), lineThickness(marks, frame.x1, y0, y1),
                rowLineThickness(marks, frame.y0, x0, x1), rowLineThickness(marks, frame.y1, x0, x1)});
  const int thickest = std::max(4, 2 * thickness);  // ticks have about the frame's line width
  out(cv::Rect(x0, y0, x1 - x0, y1 - y0)).setTo(0);
  const auto mirrored = [](std::vector<double> positions, int size) {
    for (auto& p : positions) p = size - 1 - p;
    return positions;
  };
  // The strip beyond each side in turn is rotated to the bottom; the rest of the picture has no ticks.
  const int rows = longestTick(frame.height()), columns = longestTick(frame.width());
  const auto eraseIn = [&](cv::Mat strip, bool sideways, bool mirror, const std::vector<double>& at,
                           int longest) {
    if (strip.empty()) return;
    cv::Mat turned = sideways ? cv::Mat(strip.t()) : strip.clone();
    if (mirror) cv::flip(turned, turned, -1);
    eraseTicksBelow(turned, at, longest, thickest);
    if (mirror) cv::flip(turned, turned, -1);
    if (sideways) turned = cv::Mat(turned.t());
    turned.copyTo(strip);
  };
  eraseIn(out.rowRange(std::min(y1, out.rows), std::min(out.rows, y1 + rows + 1)), false, false, xLines,
          rows);
  eraseIn(out.rowRange(std::max(0, y0 - rows - 1), y0), false, true, mirrored(xLines, out.cols), rows);
  eraseIn(out.colRange(std::min(x1, out.cols), std::min(out.cols, x1 + columns + 1)), true, false, yLines,
          columns);
  eraseIn(out.colRange(std::max(0, x0 - columns - 1), x0), true, true, mirrored(yLines, out.rows), columns);
  return out;
}

cv::Mat darkMaskOf(const cv::Mat& darkness) {
  // Dense text darkens its surroundings, but not above its own darkness.
  cv::Mat around, marks;
  cv::blur(darkness, around, cv::Size(paperWindow_px, paperWindow_px), cv::Point(-1, -1),
           cv::BORDER_REPLICATE);
  cv::subtract(darkness, around, marks);
  cv::threshold(marks, marks, markContrast, 255, cv::THRESH_BINARY);
  return marks;
}

cv::Mat marksAbove(const cv::Mat& darkness, int threshold) {
  cv::Mat marks;
  cv::threshold(darkness, marks, threshold, 255, cv::THRESH_BINARY);
  return marks;
}

std::vector<Box> glyphBoxes(const cv::Mat& marks, double minSize_px, double maxSize_px) {
  std::vector<Box> boxes;
  for (const PixelComponent& piece : pixelComponentsOf(marks.data, marks.cols, marks.rows, marks.step).all) {
    const Box& b = piece.box;
    const double size = std::max(b.width(), b.height());
    if (size >= minSize_px && size <= maxSize_px)
      boxes.push_back({b.x0 - 0.5, b.y0 - 0.5, b.x1 - 0.5, b.y1 - 0.5});
  }
  return boxes;
}

std::vector<Box> wordBoxes(std::vector<Box> glyphs, double gapInHeights) {
  std::sort(glyphs.begin(), glyphs.end(), [](const Box& a, const Box& b) { return a.x0 < b.x0; });
  std::vector<Box> words;
  for (const auto& glyph : glyphs) {
    const auto word = std::find_if(words.rbegin(), words.rend(),
                                   [&](const Box& w) { return besides(w, glyph, gapInHeights); });
    if (word == words.rend()) {
      words.push_back(glyph);
      continue;
    }
    *word = word->joined(glyph);
  }
  return words;
}

std::vector<Box> numberBoxes(const std::vector<Box>& glyphs) {
  std::vector<Box> words = wordBoxes(glyphs, labelGapInHeights);
  for (Box& word : words) {
    const auto isTick = [&](const Box& g) {
      return g.x1 == word.x1 && g.width() >= 1.5 * g.height() && g.height() <= 0.45 * word.height() &&
             word.contains(g);
    };
    const auto tick = std::find_if(glyphs.begin(), glyphs.end(), isTick);
    if (tick == glyphs.end()) continue;
    std::vector<Box> rest;
    std::copy_if(glyphs.begin(), glyphs.end(), std::back_inserter(rest),
                 [&](const Box& g) { return g != *tick && word.contains(g); });
    if (rest.empty()) continue;
    word = std::accumulate(rest.begin() + 1, rest.end(), rest.front(),
                           [](const Box& a, const Box& b) { return a.joined(b); });
  }
  return words;
}

Box withoutTitleLetter(const Box& word, const std::vector<Box>& glyphs) {
  constexpr double apart = 0.2, nextLetter = 0.45;  // share of the word's height
  std::vector<Box> members;
  for (const Box& g : glyphs)
    if (word.contains(g)) members.push_back(g);
  std::sort(members.begin(), members.end(), [](const Box& a, const Box& b) { return a.x0 < b.x0; });
  Box before = members.empty() ? word : members.front();
  for (std::size_t k = 1; k < members.size(); before = before.joined(members[k]), ++k) {
    if (members[k].x0 - before.x1 < apart * members[k].height()) continue;
    const bool inColumn = std::any_of(glyphs.begin(), glyphs.end(), [&](const Box& g) {
      const double shared = std::min(g.x1, before.x1) - std::max(g.x0, before.x0);
      const double gap = std::max(g.y0, before.y0) - std::min(g.y1, before.y1);
      return !word.contains(g) && shared >= 0.5 * std::min(g.width(), before.width()) &&
             gap <= nextLetter * word.height();
    });
    if (!inColumn) return word;
    Box rest = members[k];
    for (std::size_t i = k; i < members.size(); ++i) rest = rest.joined(members[i]);
    return rest;
  }
  return word;
}

Box leftForRight(const Box& box) { return {-box.x1, box.y0, -box.x0, box.y1}; }

Box upsideDown(const Box& box) { return {box.x0, -box.y1, box.x1, -box.y0}; }

Box turned(const Box& box, int quarterTurns) {
  switch (quarterTurns & 3) {
    case 1:
      return {-box.y1, box.x0, -box.y0, box.x1};
    case 2:
      return {-box.x1, -box.y1, -box.x0, -box.y0};
    case 3:
      return {box.y0, -box.x1, box.y1, -box.x0};
    default:
      return box;
  }
}

}  // namespace detent::importer
