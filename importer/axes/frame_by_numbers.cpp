// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/frame_by_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "importer/axes/text_lines.h"
#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"

namespace detent::importer {
namespace {

constexpr std::size_t fewestLabels = 3;

/// The used labels of one axis, in order.
struct LabelSeries {
  std::vector<double> positions;  // increasing
  double step_px = 0;             // between neighbours
  double across = 0;  // middle of the words across the axis; for a column, the edge at which they are aligned
  double height = 0;  // height of a word
  bool onRight = false;  // a column on the frame's right
};

std::optional<LabelSeries> seriesOf(const AxisReading& axis, bool alongX, const Box& frame) {
  LabelSeries s;
  std::vector<double> across, heights;
  for (const TickLabel& tick : axis.ticks) {
    if (!tick.used || tick.box.empty()) continue;
    s.positions.push_back(tick.position_px);
    s.onRight = !alongX && tick.box.x0 > frame.x1;
    across.push_back(alongX ? 0.5 * (tick.box.y0 + tick.box.y1) : s.onRight ? tick.box.x0 : tick.box.x1);
    heights.push_back(tick.box.height());
  }
  if (s.positions.size() < fewestLabels) return {};
  std::sort(s.positions.begin(), s.positions.end());
  s.step_px = s.positions.back() - s.positions.front();
  for (std::size_t i = 1; i < s.positions.size(); ++i)
    s.step_px = std::min(s.step_px, s.positions[i] - s.positions[i - 1]);
  std::sort(across.begin(), across.end());
  std::sort(heights.begin(), heights.end());
  s.across = across[across.size() / 2], s.height = heights[heights.size() / 2];
  if (s.step_px < 1.5 * s.height) return {};
  return s;
}

/// Returns true if a word of the labels' size is at a position along the axis, or is flush with it on the
/// side to which `inwards` points (-1 or 1 along the axis).
bool wordAt(const std::vector<Box>& words, const LabelSeries& s, bool alongX, double place, int inwards) {
  constexpr double flush = 0.75;  // share of a word's width: half of it and a margin
  const double along = 0.35 * s.height + 2, beside = 0.4 * s.height + 2;
  return std::any_of(words.begin(), words.end(), [&](const Box& w) {
    const double at = alongX ? 0.5 * (w.x0 + w.x1) : 0.5 * (w.y0 + w.y1);
    const double off = (alongX ? 0.5 * (w.y0 + w.y1) : s.onRight ? w.x0 : w.x1) - s.across;
    const double moved = inwards * (at - place);
    return moved >= -along && moved <= (alongX ? std::max(along, flush * w.width()) : along) &&
           std::abs(off) <= beside && w.height() <= 1.4 * s.height && w.height() >= 0.7 * s.height &&
           w.width() <= 4.5 * w.height();
  });
}

/// Position of the last word that continues the labels in a direction; `edge` if no word lies beyond it.
double reach(const std::vector<Box>& words, const LabelSeries& s, bool alongX, int direction, double edge) {
  constexpr double clearlyBeyond = 0.4;  // share of a step: the last label may stand slightly off its place
  double at = direction > 0 ? s.positions.back() : s.positions.front();
  for (int k = 0; k < 20 && wordAt(words, s, alongX, at + direction * s.step_px, -direction); ++k)
    at += direction * s.step_px;
  return direction * (at - edge) > clearlyBeyond * s.step_px ? at : edge;
}

/// Darkness of a line minus that of both its sides, averaged along a stretch.
double lineContrast(const cv::Mat& darkness, double at, double from, double to, bool upright) {
  constexpr int beside_px = 4;
  const int a = static_cast<int>(std::lround(std::min(from, to))),
            b = static_cast<int>(std::lround(std::max(from, to)));
  const int place = static_cast<int>(std::lround(at)), most = upright ? darkness.cols : darkness.rows;
  if (a < 0 || b >= (upright ? darkness.rows : darkness.cols) || b <= a) return 0;
  if (place < beside_px + 1 || place + beside_px + 1 >= most) return 0;
  double line = 0, sides = 0;
  for (int along = a; along <= b; ++along) {
    const auto level = [&](int across) -> int {
      return upright ? darkness.at<std::uint8_t>(along, across) : darkness.at<std::uint8_t>(across, along);
    };
    line += std::max({level(place - 1), level(place), level(place + 1)});
    sides += std::max(level(place - beside_px), level(place + beside_px));
  }
  return (line - sides) / (b - a + 1);
}

/// Returns true if most gridlines across an edge continue to another position beyond it. With `countAxis` the
/// axis itself counts as well.
bool linesGoOn(const cv::Mat& darkness, const std::vector<GridLine>& across, double axis, bool countAxis,
               double from, double to, bool upright) {
  constexpr double seen = 6;  // grey levels
  constexpr std::size_t fewest = 3;
  const auto goesOn = [&](double at) {
    double best = 0;
    for (int off = -1; off <= 1; ++off)
      best = std::max(best, lineContrast(darkness, at + off, from, to, !upright));
    return best >= seen;
  };
  std::size_t lines = 0, on = 0;
  for (const GridLine& line : across) {
    if (!line.spansFrame) continue;
    ++lines;
    on += goesOn(line.position_px);
  }
  return (lines >= fewest && 2 * on > lines) || (countAxis && goesOn(axis));
}

/// Returns true if an edge is drawn where the numbers require one, even with gaps. The last number may stand
/// away from the last line; the frame then ends at the line.
bool isDrawn(const cv::Mat& darkness, double edge, double from, double to, bool upright) {
  constexpr double seen = 6, enough = 0.3;  // grey levels; share of the pieces
  constexpr int reach_px = 4, pieces = 20;
  int drawn = 0;
  for (int k = 0; k < pieces; ++k) {
    const double a = from + (to - from) * (k + 0.1) / pieces, b = from + (to - from) * (k + 0.9) / pieces;
    double best = 0;
    for (int off = -reach_px; off <= reach_px; ++off)
      best = std::max(best, lineContrast(darkness, edge + off, a, b, upright));
    drawn += best >= seen;
  }
  return drawn >= enough * pieces;
}

}  // namespace

std::optional<Box> frameByNumbers(const PageView& view, const PlotFrame& frame, const AxisCalibration& axes) {
  const auto x = seriesOf(axes.x, true, frame.box()), y = seriesOf(axes.y, false, frame.box());
  if (!x || !y) return {};
  const double largest = 2 * std::max(x->height, y->height) + 4;
  const cv::Mat darkness = darknessOf(view.raster, frame.paper);
  const auto words = numberBoxes(glyphBoxes(darkMaskOf(darkness), 2, largest));
  const Box box = frame.box();
  const auto edge = [&](const LabelSeries& s, bool alongX, int direction, double at) {
    const double wider = reach(words, s, alongX, direction, at);
    const double from = alongX ? box.y0 : box.x0, to = alongX ? box.y1 : box.x1;
    if (wider == at) return at;
    const auto& across = alongX ? frame.yLines : frame.xLines;
    const double axis = alongX ? box.y1 : box.x0;
    // Above a drawn upper edge the axis continues to an arrow.
    const bool open = !isDrawn(darkness, at, from, to, alongX);
    const bool goesOn =
        linesGoOn(darkness, across, axis, open, at + 2.0 * direction, wider - 2.0 * direction, alongX);
    return goesOn || isDrawn(darkness, wider, from, to, alongX) ? wider : at;
  };
  const Box widened{edge(*x, true, -1, box.x0), edge(*y, false, -1, box.y0), edge(*x, true, 1, box.x1),
                    edge(*y, false, 1, box.y1)};
  if (widened == box) return {};
  return widened;
}

}  // namespace detent::importer
