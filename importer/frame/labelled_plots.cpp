// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/labelled_plots.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "importer/frame/glyph_marks.h"

namespace detent::importer {
namespace {

constexpr int fewestLabels = 3;
constexpr std::size_t mostWords = 1500;  // pages of running text are skipped

double middleX(const Box& b) { return 0.5 * (b.x0 + b.x1); }
double middleY(const Box& b) { return 0.5 * (b.y0 + b.y1); }

/// Returns true for up to five characters of legible height.
bool couldBePlotNumber(const Box& word) {
  return word.height() >= 5 && word.width() <= 4.5 * word.height() && word.height() <= 3.5 * word.width();
}

bool alike(const Box& a, const Box& b) {
  return a.height() <= 1.35 * b.height() + 2 && b.height() <= 1.35 * a.height() + 2;
}

/// Evenly spaced words in a line.
struct Series {
  std::vector<Box> words;  // along the axis
  double step_px = 0;
  double height_px = 0;
  double first_px = 0, last_px = 0;  // positions of the outermost labels along the axis
};

/// Some programs move the outermost labels inwards, flush with the axis ends; their values are still one step
/// away.
void takeFlushEnds(Series& s, const std::vector<Box>& line, const std::vector<double>& positions) {
  constexpr double moved = 0.75;  // share of a word's width: half of it, and a margin
  const auto at = [&](double place) {
    return static_cast<std::size_t>(std::find(positions.begin(), positions.end(), place) - positions.begin());
  };
  const std::size_t first = at(s.first_px), last = at(s.last_px);
  const auto flush = [&](std::size_t k, double away) {
    return away < s.step_px && s.step_px - away <= moved * line[k].width();
  };
  if (last + 1 < positions.size() && flush(last + 1, positions[last + 1] - s.last_px)) {
    s.words.push_back(line[last + 1]);
    s.last_px += s.step_px;
  }
  if (first > 0 && first <= positions.size() && flush(first - 1, s.first_px - positions[first - 1])) {
    s.words.insert(s.words.begin(), line[first - 1]);
    s.first_px -= s.step_px;
  }
}

/// The longest even progression without a gap; `places` increase.
Series evenSeries(const std::vector<Box>& words, const std::vector<double>& positions, double height,
                  double minStep) {
  Series best;
  const double tolerance = 0.3 * height + 1.5;
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t j = i + 1; j < positions.size(); ++j) {
      const double first = positions[j] - positions[i];
      if (first < minStep) continue;
      std::vector<std::size_t> members{i, j};
      double step = first;
      for (std::size_t k = j + 1; k < positions.size(); ++k) {
        const double off = positions[k] - positions[members.back()] - step;
        if (off > tolerance) break;
        if (off < -tolerance) continue;
        members.push_back(k);
        step = (positions[k] - positions[i]) / static_cast<double>(members.size() - 1);
      }
      if (members.size() <= best.words.size()) continue;
      best = Series{{}, step, height, positions[members.front()], positions[members.back()]};
      for (const std::size_t k : members) best.words.push_back(words[k]);
    }
  return best;
}

template <class Aligned, class Place>
std::vector<Series> allSeries(const std::vector<Box>& words, Aligned aligned, Place place,
                              double minStepInHeights, bool alongX) {
  std::vector<Series> found;
  for (const Box& seed : words) {
    const bool known = std::any_of(found.begin(), found.end(), [&](const Series& s) {
      return std::find(s.words.begin(), s.words.end(), seed) != s.words.end();
    });
    if (known) continue;
    std::vector<Box> line;
    for (const Box& w : words)
      if (alike(w, seed) && aligned(w, seed)) line.push_back(w);
    std::sort(line.begin(), line.end(), [&](const Box& a, const Box& b) { return place(a) < place(b); });
    std::vector<double> positions;
    for (const Box& w : line) positions.push_back(place(w));
    auto series = evenSeries(line, positions, seed.height(), minStepInHeights * seed.height());
    if (static_cast<int>(series.words.size()) >= fewestLabels && alongX)
      takeFlushEnds(series, line, positions);
    if (static_cast<int>(series.words.size()) >= fewestLabels) found.push_back(std::move(series));
  }
  return found;
}

/// Region enclosed by a row and a column, if the column is at the row's left end and the row at the column's
/// bottom.
std::optional<LabelledPlot> between(const Series& row, const Series& column) {
  if (!alike(row.words.front(), column.words.front())) return {};
  const double left = row.first_px, right = row.last_px;
  const double top = column.first_px, bottom = column.last_px;
  double columnEnd = column.words.front().x1;
  for (const Box& w : column.words) columnEnd = std::max(columnEnd, w.x1);
  const double rowTop = row.words.front().y0, width = right - left, height = bottom - top;
  // The first label may be one step right of the axis, the last one a step above it, because zeros are often
  // omitted.
  if (columnEnd > left + 0.5 * row.height_px || left - columnEnd > 1.6 * row.step_px) return {};
  if (rowTop < bottom - 0.3 * row.height_px || rowTop - bottom > 1.6 * column.step_px) return {};
  const bool zeroLeft = left - columnEnd > 0.75 * row.step_px && left - columnEnd > 3 * row.height_px;
  const bool zeroBelow = rowTop - bottom > 0.75 * column.step_px && rowTop - bottom > 2 * row.height_px;
  LabelledPlot plot;
  plot.box = {zeroLeft ? left - row.step_px : left, top, right, zeroBelow ? bottom + column.step_px : bottom};
  plot.below = static_cast<int>(row.words.size()), plot.left = static_cast<int>(column.words.size());
  if (width <= 0 || height <= 0 || plot.box.x0 < columnEnd - row.height_px || plot.box.y1 > rowTop + 1)
    return {};
  plot.score = 2 * std::min(plot.below, plot.left) + std::max(plot.below, plot.left) -
               2 * std::max(0.0, (left - columnEnd) / row.step_px - 1) -
               2 * std::max(0.0, (rowTop - bottom) / column.step_px - 1);
  return plot;
}

/// A series mirrored by `side`; `along`: its words run across the mirror axis.
Series mirrored(Series s, Box (*side)(const Box&), bool along) {
  for (Box& word : s.words) word = side(word);
  if (along) {
    std::ranges::reverse(s.words);
    s.first_px = -std::exchange(s.last_px, -s.first_px);
  }
  return s;
}

/// The same with the column at the row's right end. Less likely, because it may belong to the next plot.
std::optional<LabelledPlot> betweenFromRight(const Series& row, const Series& column) {
  auto plot = between(mirrored(row, leftForRight, true), mirrored(column, leftForRight, false));
  if (plot) plot->box = leftForRight(plot->box), plot->score -= 1;
  return plot;
}

/// The same with the row above the column. Less likely, because it may belong to another plot.
std::optional<LabelledPlot> betweenFromAbove(const Series& row, const Series& column) {
  const Series rowBelow = mirrored(row, upsideDown, false), columnUp = mirrored(column, upsideDown, true);
  auto plot = between(rowBelow, columnUp);
  if (!plot) plot = betweenFromRight(rowBelow, columnUp);
  if (plot) plot->box = upsideDown(plot->box), plot->score -= 1;
  return plot;
}

bool meets(const Box& a, const Box& b) { return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1; }

}  // namespace

std::vector<LabelledPlot> findLabelledPlots(const cv::Mat& marks, double minWidth_px, double minHeight_px) {
  const double largest = 0.12 * std::min(marks.cols, marks.rows);
  const std::vector<Box> glyphs = glyphBoxes(marks, 2, largest);
  auto words = numberBoxes(glyphs);
  std::erase_if(words, [](const Box& w) { return !couldBePlotNumber(w); });
  if (words.size() > mostWords) return {};
  const auto rows = allSeries(
      words,
      [](const Box& a, const Box& b) { return std::abs(middleY(a) - middleY(b)) <= 0.3 * b.height() + 1; },
      middleX, 1.6, true);
  // A vertical title beside the column joins its words; one below the row does not.
  for (Box& word : words) word = withoutTitleLetter(word, glyphs);
  const auto columns = allSeries(
      words,
      [](const Box& a, const Box& b) {
        return std::abs(a.x1 - b.x1) <= 0.4 * b.height() + 2 ||
               std::abs(middleX(a) - middleX(b)) <= 0.3 * b.height() + 1;
      },
      middleY, 1.2, false);
  std::vector<LabelledPlot> all;
  for (const Series& row : rows)
    for (const Series& column : columns)
      for (const auto& plot :
           {between(row, column), betweenFromRight(row, column), betweenFromAbove(row, column)})
        if (plot && plot->box.width() >= minWidth_px && plot->box.height() >= minHeight_px)
          all.push_back(*plot);
  std::sort(all.begin(), all.end(),
            [](const LabelledPlot& a, const LabelledPlot& b) { return a.score > b.score; });
  std::vector<LabelledPlot> kept;
  for (const LabelledPlot& plot : all)
    if (std::none_of(kept.begin(), kept.end(), [&](const LabelledPlot& k) { return meets(k.box, plot.box); }))
      kept.push_back(plot);
  return kept;
}

}  // namespace detent::importer
