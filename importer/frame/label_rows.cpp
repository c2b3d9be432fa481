// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/label_rows.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "importer/frame/glyph_marks.h"

namespace detent::importer {
namespace {

/// Largest number of places in an even progression through two of them; neighbours are at least `minStep`
/// apart.
int evenlySpaced(const std::vector<double>& positions, double tolerance, double minStep) {
  int best = 0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t j = i + 1; j < positions.size(); ++j) {
      const double step = positions[j] - positions[i];
      if (step < minStep) continue;
      int n = 0;
      double last = -1e9;
      for (const double p : positions) {
        const double k = std::round((p - positions[i]) / step);
        if (std::abs(p - positions[i] - k * step) > tolerance || k <= last) continue;
        ++n;
        last = k;
      }
      best = std::max(best, n);
    }
  return best;
}

int atLines(const std::vector<double>& positions, const std::vector<double>& lines, double tolerance) {
  int n = 0;
  for (const double line : lines)
    n += std::any_of(positions.begin(), positions.end(),
                     [&](double p) { return std::abs(p - line) <= tolerance; });
  return n;
}

/// Returns true for up to six characters of legible height; lower marks are remains of ticks. Letters of
/// small pictures are low too.
bool couldBeRowNumber(const Box& word, double frameHeight_px) {
  // least height of a digit: in px, and as a share of the frame's height
  constexpr double lowest_px = 4.5, lowestOfFrame = 0.025;
  return word.height() >= std::min(lowest_px, lowestOfFrame * frameHeight_px) &&
         word.width() <= 5.5 * word.height() && word.height() <= 3.5 * word.width();
}

/// Labels are next to their axis: largest gap in front of them.
double farthest(const Box& word) { return 3.5 * word.height() + 4; }

int regularity(const std::vector<double>& positions, const std::vector<double>& lines, double height,
               double size) {
  const double tolerance = 0.3 * height + 1.5;
  return std::max(evenlySpaced(positions, tolerance, std::max(1.2 * height, 0.04 * size)),
                  lines.size() >= 3 ? atLines(positions, lines, tolerance) : 0);
}

/// Returns true if nearly all words are in the progression. Letters of a vertical title may be evenly spaced
/// by chance, and be more numerous than labels, but other letters are between them.
bool allInStep(const LabelRow& row) {
  constexpr int fewest = 4;
  return row.regular >= fewest && 4 * row.regular >= 3 * static_cast<int>(row.words.size());
}

}  // namespace

LabelRow labelsBelow(const std::vector<Box>& words, const Box& r, const std::vector<double>& lines) {
  std::vector<Box> band;
  for (const auto& w : words)
    if (couldBeRowNumber(w, r.height()) && w.middle().x >= r.x0 - 0.1 * r.width() &&
        w.middle().x <= r.x1 + 0.1 * r.width() && w.y0 >= r.y1 - 0.02 * r.height() &&
        w.y1 <= r.y1 + 0.3 * r.height() && w.y0 <= r.y1 + farthest(w) + 0.03 * r.height() &&
        w.height() <= 0.12 * r.height() + 6)
      band.push_back(w);
  LabelRow best;
  for (const auto& seed : band) {
    LabelRow row;
    for (const auto& w : band)
      if (std::abs(w.middle().y - seed.middle().y) <= 0.35 * seed.height() + 1 &&
          w.height() <= 1.6 * seed.height() + 2 && seed.height() <= 1.6 * w.height() + 2)
        row.words.push_back(w);
    std::sort(row.words.begin(), row.words.end(), [](const Box& a, const Box& b) { return a.x0 < b.x0; });
    std::vector<double> positions;
    for (const auto& w : row.words) positions.push_back(w.middle().x);
    row.regular = regularity(positions, lines, seed.height(), r.width());
    row.height_px = seed.height();
    if (row.regular > best.regular || (row.regular == best.regular && row.height_px > best.height_px))
      best = std::move(row);
  }
  return best;
}

LabelRow labelsLeft(const std::vector<Box>& words, const Box& r, const std::vector<double>& lines) {
  std::vector<Box> band;
  for (const auto& w : words)
    if (couldBeRowNumber(w, r.height()) && w.x1 <= r.x0 + 0.02 * r.width() &&
        w.x0 >= r.x0 - 0.35 * r.width() && w.middle().y >= r.y0 - 0.12 * r.height() &&
        w.middle().y <= r.y1 + 0.06 * r.height() && w.x1 >= r.x0 - farthest(w) - 0.03 * r.width() &&
        w.height() <= 0.12 * r.height() + 6)
      band.push_back(w);
  LabelRow best;
  for (const auto& seed : band) {
    LabelRow column;
    for (const auto& w : band)
      if (w.height() <= 1.6 * seed.height() + 2 && seed.height() <= 1.6 * w.height() + 2 &&
          (std::abs(w.x1 - seed.x1) <= 0.5 * seed.height() + 2 ||
           std::abs(w.middle().x - seed.middle().x) <= 0.5 * seed.height() + 2))
        column.words.push_back(w);
    std::sort(column.words.begin(), column.words.end(),
              [](const Box& a, const Box& b) { return a.y0 < b.y0; });
    std::vector<double> positions;
    for (const auto& w : column.words) positions.push_back(w.middle().y);
    column.regular = regularity(positions, lines, seed.height(), r.height());
    column.height_px = seed.height();
    const bool nearer = !best.words.empty() && seed.x1 > best.words.front().x1;
    // Of equally regular columns the nearest to the axis ranks first, because titles are farther out.
    const auto rank = std::tuple(allInStep(column), column.regular, nearer);
    if (rank > std::tuple(allInStep(best), best.regular, false)) best = std::move(column);
  }
  return best;
}

LabelRow labelsRight(std::vector<Box> words, const Box& r, const std::vector<double>& lines) {
  for (Box& word : words) word = leftForRight(word);
  LabelRow row = labelsLeft(words, leftForRight(r), lines);
  for (Box& word : row.words) word = leftForRight(word);
  return row;
}

LabelRow labelsAbove(std::vector<Box> words, const Box& r, const std::vector<double>& lines) {
  for (Box& word : words) word = upsideDown(word);
  LabelRow row = labelsBelow(words, upsideDown(r), lines);
  for (Box& word : row.words) word = upsideDown(word);
  return row;
}

LabelRow labelsUpwards(const std::vector<Box>& words, const Box& r, const std::vector<double>& lines) {
  constexpr double aligned = 0.25, joined = 0.8;  // share of a digit's height, which is the width here
  const auto isAligned = [&](const Box& w, const Box& seed) {
    const double off = aligned * seed.width() + 1.5;
    return std::abs(w.x0 - seed.x0) <= off && std::abs(w.x1 - seed.x1) <= off;
  };
  LabelRow best;
  for (const auto& seed : words) {
    const Box lying{0, 0, seed.height(), seed.width()};
    if (!couldBeRowNumber(lying, r.height()) || seed.x1 > r.x0 ||
        seed.x1 < r.x0 - farthest(lying) - 0.03 * r.width())
      continue;
    std::vector<Box> digits;
    for (const auto& w : words)
      if (isAligned(w, seed) && w.y1 >= r.y0 - 0.12 * r.height() && w.y0 <= r.y1 + 0.12 * r.height())
        digits.push_back(w);
    std::sort(digits.begin(), digits.end(), [](const Box& a, const Box& b) { return a.y0 < b.y0; });
    LabelRow column;
    for (const auto& digit : digits)
      if (!column.words.empty() && digit.y0 - column.words.back().y1 <= joined * seed.width())
        column.words.back() = column.words.back().joined(digit);
      else
        column.words.push_back(digit);
    std::vector<double> positions;
    for (const auto& w : column.words) positions.push_back(w.middle().y);
    column.regular = regularity(positions, lines, seed.width(), r.height());
    column.height_px = seed.width();
    if (column.regular > best.regular) best = std::move(column);
  }
  return best;
}

}  // namespace detent::importer
