// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/trace_vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "importer/page/same_colour.h"
#include "importer/trace/loop_crossing.h"
#include "importer/trace/loop_pair.h"
#include "importer/trace/piece_network.h"
#include "importer/trace/vector_pieces.h"

namespace detent::importer {
namespace {

/// Lines of one style: one colour, one dash pattern.
struct LineStyle {
  Rgb color;
  bool dashed = false;
  friend bool operator<(const LineStyle& a, const LineStyle& b) {
    return std::tie(a.color.r, a.color.g, a.color.b, a.dashed) <
           std::tie(b.color.r, b.color.g, b.color.b, b.dashed);
  }
};

struct StyledStroke {
  LineStyle style;
  FoundStroke stroke;
  double confidence = 1;
};

constexpr std::size_t strokesOfOneColour = 2;

/// Common share of the travel that either covers. Parts of one stroke lie side by side.
double sharedPathTravel(const FoundStroke& a, const FoundStroke& b) {
  const double either = std::max(a.to, b.to) - std::min(a.from, b.from);
  return (std::min(a.to, b.to) - std::max(a.from, b.from)) / either;
}

/// Force height (pixels above the plot's floor) of a left-to-right line at a column; nullopt beside it.
std::optional<double> rowAt(const std::vector<Point>& line, double x) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point a = line[i - 1], b = line[i];
    if ((a.x <= x && x < b.x) || (b.x <= x && x < a.x)) return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
  }
  return std::nullopt;
}

/// Positive if `a` lies above `b` on average. In pixels.
double meanHeightAbove(const std::vector<Point>& a, const std::vector<Point>& b, const PlotPlane& plane) {
  constexpr int samples = 400;
  double sum = 0;
  int count = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = plane.box.x0 + plane.box.width() * (i + 0.5) / samples;
    const auto ya = rowAt(a, x), yb = rowAt(b, x);
    if (!ya || !yb) continue;
    sum += *yb - *ya;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

/// Returns true if the lines cross, or the lower one extends farther: not the strokes of one switch, or not
/// all of them. The pixels decide then.
bool areUnpaired(const FoundStroke& a, const FoundStroke& b, const PlotPlane& plane) {
  constexpr double farther = 0.035;  // share of the upper one's travel, as in pictures
  constexpr double contact_px = 0.75;
  const bool firstAbove = meanHeightAbove(a.points, b.points, plane) >= 0;
  const FoundStroke &press = firstAbove ? a : b, &release = firstAbove ? b : a;
  if (release.to - press.to > farther * (press.to - press.from)) return true;
  const auto [upper, lower] =
      trace::partUpperLower(densified(press.points, 1), densified(release.points, 1), contact_px);
  return trace::linesCross(upper, lower, press.width_px, plane.diagonal());
}

/// Returns true if a line that covers less of the plot than strokes do ends where the press does, like the
/// release of a latching key. Leaders are straight, or have two or three points.
bool pathLeadsBackFrom(const FoundStroke& press, const FoundStroke& other, const PlotPlane& plane) {
  constexpr double together = 0.02;  // share of the plot's width
  constexpr std::size_t measuredPoints = 8;
  constexpr double straightChord = 0.9995;  // share of the length
  return std::abs(press.to - other.to) <= together && other.points.size() >= measuredPoints &&
         distance(other.points.front(), other.points.back()) <= straightChord * lengthOf(other.points) &&
         !areUnpaired(press, other, plane);
}

struct StrokesOfColour {
  std::vector<StyledStroke> strokes;
  std::optional<FoundStroke> shortOne;  ///< none if there is no stroke
  bool inDoubt = false;                 ///< parts of strokes, or strokes of two switches
};

StrokesOfColour strokesOf(const LineStyle& style, std::vector<LinePiece> pieces, const PlotPlane& plane) {
  PieceNetwork network(std::move(pieces), plane);
  StrokesOfColour found;
  std::vector<FoundStroke> lines;
  while (lines.size() < strokesOfOneColour) {
    auto line = network.nextStroke();
    if (!line) break;
    lines.push_back(std::move(*line));
  }
  constexpr double halfAnotherStroke = 0.25;  // share of the plot's diagonal
  constexpr double leastShared = 0.3;         // of the travel that either covers
  bool third = false;                         // perhaps the best two do not belong together
  for (const UnusedLine& unused : network.unusedLines()) {
    third = third || (!unused.straight && unused.fresh > halfAnotherStroke);
    found.inDoubt = found.inDoubt || std::ranges::any_of(lines, [&](const FoundStroke& line) {
                      return network.isRestOf(line, unused);
                    });
  }
  if (lines.size() == 2)
    found.inDoubt = found.inDoubt || sharedPathTravel(lines[0], lines[1]) < leastShared ||
                    areUnpaired(lines[0], lines[1], plane);
  constexpr double shortCover = 0.12;  // share of the plot's width, as in pictures
  if (lines.empty()) found.shortOne = network.nextStroke(shortCover);
  for (FoundStroke& line : lines) {
    const double confidence = std::clamp(1 - 0.3 * line.joinCost, 0.1, 1.0) * (third ? 0.5 : 1);
    found.strokes.push_back({style, std::move(line), confidence});
  }
  return found;
}

/// Returns true if dots and dashes along a line of their own colour are its markers.
bool areMarkersOn(const StyledStroke& line, const StyledStroke& dotted) {
  constexpr double beside_px = 1.5, nearlyAll = 0.95;  // of the points
  if (line.style.dashed || !dotted.style.dashed || line.style.color != dotted.style.color) return false;
  const auto& positions = dotted.stroke.points;
  const auto on = std::ranges::count_if(positions, [&](Point p) {
    return distance(nearestOn(line.stroke.points, p), p) <= beside_px + 0.5 * line.stroke.width_px;
  });
  return static_cast<double>(on) >= nearlyAll * static_cast<double>(positions.size());
}

struct LegendSample {
  Box box;
  LineStyle style;
};

/// Short horizontal lines anywhere in the view: possible legend keys.
std::vector<LegendSample> legendSamples(const PageView& view, const PlotPlane& plane) {
  const double shortest = 0.01 * plane.box.width(), longest = 0.15 * plane.box.width();
  constexpr double tickReach_px = 2;
  std::vector<LegendSample> samples;
  for (const VectorPath& path : view.paths) {
    if (!path.stroke) continue;
    for (const auto& line : path.polylines) {
      if (line.empty()) continue;
      const Box box = boundsOf(line);
      if (box.width() < shortest || box.width() > longest || box.height() > 0.1) continue;
      const auto atEdge = [&](double x) {
        return std::abs(x - plane.box.x0) < tickReach_px || std::abs(x - plane.box.x1) < tickReach_px;
      };
      if (atEdge(box.x0) || atEdge(box.x1)) continue;  // a tick
      samples.push_back({box, {*path.stroke, path.dashed}});
    }
  }
  return samples;
}

bool isOf(const LegendSample& sample, const LineStyle& style) {
  return colorDistance(sample.style.color, style.color) <= 6 && sample.style.dashed == style.dashed;
}

struct LegendWords {
  const SeenText* text = nullptr;  ///< null if there is none
  double gap_px = std::numeric_limits<double>::infinity();
};

/// The nearest words level with a legend key on one side of it.
LegendWords wordsBeside(const LegendSample& sample, const std::vector<SeenText>& texts, bool after) {
  LegendWords words;
  for (const SeenText& text : texts) {
    const double height = text.box.height(), middle = text.box.middle().y;
    if (std::abs(text.angle_deg) > 1 || std::abs(middle - sample.box.y0) > 0.6 * height) continue;
    const double gap = after ? text.box.x0 - sample.box.x1 : sample.box.x0 - text.box.x1;
    if (gap < -height || gap > 3 * height || std::abs(gap) >= words.gap_px) continue;
    words = {&text, std::abs(gap)};
  }
  return words;
}

/// Each legend key's words: all behind their keys, as usual, or all before them, on the side where more have
/// some. In a row a key stands between its own words and its neighbour's.
std::vector<LegendWords> wordsBesideAll(const std::vector<LegendSample>& samples,
                                        const std::vector<SeenText>& texts) {
  std::vector<LegendWords> behind, before;
  for (const LegendSample& sample : samples) {
    behind.push_back(wordsBeside(sample, texts, true));
    before.push_back(wordsBeside(sample, texts, false));
  }
  const auto unread = [](const std::vector<LegendWords>& words) {
    return std::ranges::count_if(words, [](const LegendWords& each) { return each.text == nullptr; });
  };
  return unread(behind) <= unread(before) ? behind : before;
}

bool isGiven(Rgb color, const std::optional<Rgb>& given) {
  constexpr double sameColor = 60;  // colour levels
  return given && colorDistance(color, *given) < sameColor;
}

bool wanted(const LineStyle& style, const TraceHints& hints) {
  if (!hints.pressColor && !hints.releaseColor) return true;
  return isGiven(style.color, hints.pressColor) || isGiven(style.color, hints.releaseColor);
}

/// Returns true if a line was found for each given colour; with one colour the other is not requested.
bool hasAllGiven(const std::vector<CurveTrace>& traces, const TraceHints& hints) {
  const auto found = [&](const std::optional<Rgb>& given) {
    return !given ||
           std::ranges::any_of(traces, [&](const CurveTrace& trace) { return isGiven(trace.color, given); });
  };
  return found(hints.pressColor) && found(hints.releaseColor);
}

/// Two strokes in one colour, solid and dashed or alike: the press lies above the release.
void nameStrokesOfOneColour(std::vector<CurveTrace>& traces, const PlotPlane& plane) {
  for (std::size_t i = 0; i < traces.size(); ++i) {
    std::vector<std::size_t> ofColour;
    for (std::size_t k = 0; k < traces.size(); ++k)
      if (traces[k].color == traces[i].color) ofColour.push_back(k);
    if (ofColour.size() != 2 || ofColour[0] != i) continue;
    CurveTrace &a = traces[ofColour[0]], &b = traces[ofColour[1]];
    const bool firstAbove = meanHeightAbove(a.points_px, b.points_px, plane) >= 0;
    a.stroke = firstAbove ? Stroke::press : Stroke::release;
    b.stroke = firstAbove ? Stroke::release : Stroke::press;
  }
}

void nameStrokesByHints(std::vector<CurveTrace>& traces, const TraceHints& hints) {
  if (!hints.pressColor || !hints.releaseColor || *hints.pressColor == *hints.releaseColor) return;
  for (CurveTrace& trace : traces) {
    const bool press =
        colorDistance(trace.color, *hints.pressColor) <= colorDistance(trace.color, *hints.releaseColor);
    trace.stroke = press ? Stroke::press : Stroke::release;
  }
}

}  // namespace

std::vector<CurveTrace> traceVector(const PageView& view, const PlotFrame& frame, const AxesFound& axes,
                                    const TraceHints& hints) {
  const PlotPlane plane(frame);
  if (plane.box.empty()) return {};
  std::map<LineStyle, std::vector<LinePiece>> styles;
  const auto before = [](Point a, Point b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
  const auto pathBefore = [&](const Polyline& a, const Polyline& b) {
    return std::ranges::lexicographical_compare(a, b, before);
  };
  std::map<LineStyle, std::set<Polyline, decltype(pathBefore)>> drawn;
  for (LinePiece& piece : linePieces(view, plane, hints.masks_px)) {
    const LineStyle style{piece.color, piece.dashed};
    if (!wanted(style, hints)) continue;
    // A line drawn again over a fill that covered it is one line.
    const bool isNew = drawn.try_emplace(style, pathBefore).first->second.insert(piece.points).second;
    if (isNew) styles[style].push_back(std::move(piece));
  }
  std::vector<StyledStroke> strokes, shortOnes;
  for (auto& [style, pieces] : styles) {
    StrokesOfColour found = strokesOf(style, std::move(pieces), plane);
    if (found.inDoubt) return {};
    std::ranges::move(found.strokes, std::back_inserter(strokes));
    if (found.shortOne) shortOnes.push_back({style, std::move(*found.shortOne)});
  }
  std::erase_if(strokes, [&, lines = strokes](const StyledStroke& each) {
    return std::ranges::any_of(lines, [&](const StyledStroke& line) { return areMarkersOn(line, each); });
  });
  if (strokes.size() == 1) {
    std::erase_if(shortOnes, [&](const StyledStroke& each) {
      return !pathLeadsBackFrom(strokes.front().stroke, each.stroke, plane);
    });
    std::ranges::move(shortOnes, std::back_inserter(strokes));
  }

  std::vector<LegendSample> samples = legendSamples(view, plane);
  std::erase_if(samples, [&](const LegendSample& sample) {
    return std::ranges::none_of(strokes,
                                [&](const StyledStroke& stroke) { return isOf(sample, stroke.style); });
  });
  const std::vector<LegendWords> words = wordsBesideAll(samples, axes.texts);
  std::vector<CurveTrace> traces;
  for (StyledStroke& stroke : strokes) {
    CurveTrace trace;
    trace.points_px = std::move(stroke.stroke.points);
    trace.color = stroke.style.color;
    trace.fromVector = true;
    trace.confidence = stroke.confidence;
    LegendWords legendWords;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (isOf(samples[i], stroke.style) && words[i].gap_px < legendWords.gap_px) legendWords = words[i];
    if (legendWords.text != nullptr)
      trace.label = legendWords.text->utf8, trace.labelBox_px = legendWords.text->box;
    traces.push_back(std::move(trace));
  }
  if (!hasAllGiven(traces, hints)) return {};
  nameStrokesOfOneColour(traces, plane);
  nameStrokesByHints(traces, hints);
  return traces;
}

}  // namespace detent::importer
