// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/bottom_outs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "importer/page/polyline.h"
#include "importer/page/quantile.h"
#include "importer/trace/edge_cut.h"

namespace detent::importer::trace {

namespace {

constexpr double kNearer = 0.5;       // of two thicknesses the nearer one: beyond the middle between them
constexpr double kMostOfCurve = 1.7;  // of the curve's thickness; bars and shaded areas are thicker
constexpr double kLean_px = 0.75;     // lean between the halves of a bottom-out, at most
// additional pixels compared with the plot's own line, whatever the curve's thickness
constexpr double kMuch_px = 0.4;
constexpr double kMuchOfThickness = 0.35;  // the same as a share of the curve's thickness, at least
constexpr double kLittle_px =
    0.3;  // additional pixels compared with that line, if all rows and the curve's thickness agree
constexpr double kThinRows =
    0.15;  // share of a lane's rows: the thin rows of a bottom-out are thicker than the thick rows of a line
// share of the frame's height; without pixels over this distance below the end there is no line
constexpr double kBareBelow = 0.1;
constexpr double kPlumb_px = 1.5;      // px within which the points of a vertical rise lie
constexpr double kLeastHeight = 0.05;  // share of the frame's height
constexpr std::size_t kLeastRows = 6;  // rows needed to measure a thickness
constexpr double kProbed_px = 14;      // rows examined; a horizontal line may cover 7 of them
// line widths beside the bottom-out within which a crest belongs to the corner
constexpr double kHook = 4;
constexpr double kHook_px = 4;         // and pixels over which a path bends at a corner
constexpr double kFaintest_px = 0.15;  // of a line in a curve's colour that stands out from noise
constexpr double kTopReached_px = 3;   // a bottom-out that ends this close to the frame's edge reaches it

constexpr double kWindow_px = kLeastRows;  // part of a lane that may be one dash or one gap

/// A curve in area pixels, from left to right, with the properties of its end.
struct Curve {
  std::vector<Point> points;
  bool reversed = false;    ///< drawn from the right
  bool fromVector = false;  ///< known to its end
  double thickness_px = 0;  ///< 0: not visible
  Rgb color;

  Point end() const { return points.back(); }
};

Curve curveOnArea(const CurveTrace& trace, const PlotArea& area) {
  Curve curve;
  curve.color = trace.color;
  curve.fromVector = trace.fromVector;
  for (const Point& p : trace.points_px) curve.points.push_back(area.fromView(p));
  curve.reversed = curve.points.front().x > curve.points.back().x;
  if (curve.reversed) std::ranges::reverse(curve.points);
  return curve;
}

/// Thickness of a lane between two rows; nullopt for too few rows.
struct Thickness {
  double thin = 0, usual = 0, thick = 0;  ///< its thinner and thicker rows, px

  static std::optional<Thickness> between(const PlumbLane& lane, double y0, double y1) {
    const std::vector<double> rows = lane.rows(y0, y1);
    if (rows.size() < kLeastRows) return {};
    return Thickness{quantileOf(rows, kThinRows), quantileOf(rows, 0.5), quantileOf(rows, 1 - kThinRows)};
  }
};

/// Thickness of the frame in a curve's colour, if it is drawn on the left and at the top too; else 0.
double frameLine(const ColourOnArea& coverage, const PlotArea& area) {
  const Box& frame = area.frame;
  const auto left = Thickness::between({coverage, area, frame.x0}, frame.y0 + 4, frame.y1 - 4);
  std::vector<double> top;
  for (double x = frame.x0 + 4; x < frame.x1 - 4; x += 1)
    top.push_back(coverage.across(x, frame.y0, false).thickness_px);
  return left && !top.empty() ? std::min(left->usual, quantileOf(top, 0.5)) : 0;
}

/// Thickness of the plot's own vertical lines, of which the lane may be one; 0 if it is none.
double ownLine(const ColourOnArea& coverage, const PlotArea& area, double x, double within_px) {
  if (!isAtOneOf(area.columns_px, x, within_px)) return 0;
  std::vector<double> others;
  for (const double column : area.columns_px)
    if (std::abs(column - x) > within_px)
      if (const auto run = Thickness::between({coverage, area, column}, area.frame.y0 + 4, area.frame.y1 - 4))
        others.push_back(run->usual);
  const double usual = others.empty() ? 0 : quantileOf(others, 0.75);
  return std::abs(area.frame.x1 - x) <= within_px ? std::max(usual, frameLine(coverage, area)) : usual;
}

/// The plot's own line on a lane, measured below the end; empty if nothing is there for a long distance. A
/// gridline is as thick along all of itself, whatever others are; the frame's edge may be drawn twice above.
Thickness lineBelow(const PlumbLane& lane, double riseStart, double own_px, const Box& frame, double x,
                    double margin_px) {
  const double end = frame.y1 - margin_px;
  const auto below = Thickness::between(lane, riseStart, end);
  if (!below) return {own_px, own_px, own_px};
  const bool longEnough = end - riseStart > kBareBelow * frame.height();  // not a gap between two dashes
  if (below->thick <= 0 && longEnough) return {};
  if (frame.x1 - x > margin_px && longEnough) return *below;
  return {below->thin, std::max(below->usual, own_px), std::max(below->thick, own_px)};
}

/// Returns true if there is more above a curve's end than the plot's own line has. Much more is a bottom-out
/// whatever the curve's thickness; a little more is one if the curve is thicker than the line and all rows
/// agree, because two adjacent thin lines resemble a thicker one.
bool standsOut(double more_px, const Thickness& above, const Thickness& line, double curve_px) {
  if (more_px >= std::max(kMuch_px, kMuchOfThickness * curve_px)) return true;
  return std::min(more_px, curve_px - line.usual) >= kLittle_px && above.thin > line.thick;
}

/// Columns on either side of a lane over which its colours are added.
constexpr int kLaneReach_px = 6;

/// Mean over some rows of a lane's difference to the paper, added across it: its colour times its thickness.
/// Rows and columns outside the area do not count.
std::optional<Color3> laneColour(const PlotScene& scene, double x, double y0, double y1) {
  const int middle = static_cast<int>(std::lround(x));
  Color3 sum;
  int rows = 0;
  const Raster& raster = scene.area().raster;
  const int last = static_cast<int>(std::min(std::floor(y1), raster.height_px - 1.0));
  for (int y = std::max(0, static_cast<int>(std::ceil(y0))); y <= last; ++y) {
    if (isAtOneOf(scene.area().rows_px, y, 3)) continue;
    for (int at = std::max(0, middle - kLaneReach_px);
         at <= std::min(raster.width_px - 1, middle + kLaneReach_px); ++at)
      sum = sum + (scene.pixel(at, y) - scene.paperAt(at, y));
    ++rows;
  }
  if (rows < static_cast<int>(kLeastRows)) return {};
  return (1.0F / static_cast<float>(rows)) * sum;
}

/// The part of a lane's colour that is in `own`, as a thickness, if the rest of it is in the other colour.
double thicknessIn(const PaletteColour& own, const PaletteColour& other, Color3 added) {
  const Color3 a = own.difference(), b = other.difference();
  const double determinant = static_cast<double>(dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b));
  return static_cast<double>(dot(a, added) * dot(b, b) - dot(b, added) * dot(a, b)) / determinant;
}

struct LostBottomOut {
  double x = 0, riseStart = 0, top = 0;  ///< area px
};

/// Row where the vertical rise at the end of a curve begins; the end's own row without one.
double startOfRise(const Curve& curve) {
  const Point end = curve.end();
  double riseStart = end.y;
  for (auto p = curve.points.rbegin(); p != curve.points.rend() && std::abs(p->x - end.x) <= kPlumb_px; ++p)
    riseStart = std::max(riseStart, p->y);
  return riseStart;
}

/// Returns true if the right ends of two curves are on one lane.
bool endTogether(const Curve& a, const Curve& b) {
  return std::abs(a.end().x - b.end().x) <= 2 * a.thickness_px + 4;
}

/// Returns true if a curve runs above another one, but for their bottom-outs: it is the press.
bool runsAbove(const Curve& curve, const Curve& other) {
  const auto meanRow = [](const Curve& each) {
    double sum = 0, count = 0;
    for (const Point& p : each.points)
      if (p.x < each.end().x - kPlumb_px) sum += p.y, count += 1;
    return sum / std::max(1.0, count);
  };
  return meanRow(curve) < meanRow(other);
}

/// Curves that end beside one. The bottom-out rises from the uppermost end, and below the lowest end only the
/// plot's own line may stand on the lane.
struct Ends {
  double uppermost = 0, lowest = 0;   ///< area px
  std::vector<PaletteColour> others;  ///< colours of presses, if this is a release of another colour
};

Ends endsBeside(const Curve& curve, const std::vector<Curve>& curves, Color3 paper) {
  const PaletteColour own = paletteColourOf(curve.color, paper);
  Ends ends{curve.end().y, curve.end().y, {}};
  for (const Curve& other : curves) {
    if (!endTogether(curve, other)) continue;
    if (other.color == curve.color) ends.uppermost = std::min(ends.uppermost, startOfRise(other));
    ends.lowest = std::max(ends.lowest, other.end().y);
    const PaletteColour colour = paletteColourOf(other.color, paper);
    if (static_cast<double>(dot(colour.direction, own.direction)) <= kSameColourAngle &&
        runsAbove(other, curve))
      ends.others.push_back(colour);
  }
  return ends;
}

/// Distance from a curve's end beyond which its corner has no pixels.
double marginOf(const Curve& curve) { return 1.5 * curve.thickness_px + 2; }

/// A lane's colour between two rows, less its colour below a curve's end; nullopt if lines of the plot or the
/// area's edge leave too few rows.
class LaneGain {
 public:
  LaneGain(const PlotScene& scene, double x, double y0, double y1)
      : scene_(scene), x_(x), below_(laneColour(scene, x, y0, y1)) {}
  std::optional<Color3> between(double y0, double y1) const {
    const auto above = below_ ? laneColour(scene_, x_, y0, y1) : std::nullopt;
    return above ? std::optional(*above - *below_) : std::nullopt;
  }

 private:
  const PlotScene& scene_;
  double x_;
  std::optional<Color3> below_;
};

/// Thickness, in a curve's colour, of what a lane shows above an end and not below it, if all of that is the
/// curve's or another's that ends there: its thickest part, because a dashed curve has gaps. nullopt without
/// others or rows.
std::optional<double> ownThickness(const Curve& curve, const Ends& ends, double x, double y0, double y1,
                                   const PlotScene& scene) {
  if (ends.others.empty()) return {};
  const double margin = marginOf(curve);
  const LaneGain lane(scene, x, ends.lowest + margin, scene.area().frame.y1 - margin);
  const PaletteColour own = paletteColourOf(curve.color, scene.paper());
  std::vector<double> parts_px;
  for (double y = y1; y - kWindow_px >= y0; y -= kWindow_px + 1) {
    const auto gain = lane.between(y - kWindow_px, y);
    if (!gain) continue;  // a level line of the plot
    double least_px = INFINITY;
    for (const PaletteColour& other : ends.others)
      least_px = std::min(least_px, thicknessIn(own, other, *gain));
    parts_px.push_back(least_px);
  }
  if (parts_px.empty()) return {};
  return quantileOf(parts_px, 1 - kThinRows);
}

/// The bottom-out above a curve's end. The stroke rises there if the pixels are nearer to what its own line
/// would show than to what the plot's line shows, and are not in the colour of another curve that ends there.
std::optional<LostBottomOut> bottomOutAt(const Curve& curve, const std::vector<Curve>& curves,
                                         const PlotScene& scene) {
  const Ends ends = endsBeside(curve, curves, scene.paper());
  const PlotArea& area = scene.area();
  const ColourOnArea& coverage = scene.coverageOf(curve.color);
  const double w = curve.thickness_px, height = area.frame.height(), margin = marginOf(curve);
  const double least_px = std::max(kLeastHeight * height, 3 * w);
  if (ends.uppermost - area.frame.y0 < least_px) return {};
  // The corner may have been cut short: the lane is within a line's width of the end.
  const double probe = ends.uppermost - margin, room = probe - area.frame.y0;
  const double probed = std::max(kLeastHeight * height, std::min(kProbed_px, room));
  const auto probedAt = [&](double at) {
    return Thickness::between({coverage, area, at}, probe - probed, probe).value_or(Thickness{});
  };
  double x = curve.end().x, most_px = 0;
  for (double at = curve.end().x - w - 2; at <= curve.end().x + w + 2; at += 1)
    if (const double run = probedAt(at).usual; run > most_px) most_px = run, x = at;
  x = PlumbLane(coverage, area, x).middle(probe - probed, probe);
  const PlumbLane lane(coverage, area, x);
  const Thickness seen = probedAt(x);
  const Thickness line =
      lineBelow(lane, ends.lowest + margin, ownLine(coverage, area, x, w + 2), area.frame, x, margin);
  const auto own_px = ownThickness(curve, ends, x, probe - probed, probe, scene);
  const auto isBottomOut = [&](const Thickness& thickness) {
    const double more_px = own_px.value_or(thickness.usual - line.usual);
    return more_px >= kNearer * (w - line.usual) && thickness.usual <= kMostOfCurve * w + 1 &&
           standsOut(more_px, thickness, line, w);
  };
  if (!isBottomOut(seen)) return {};
  // Rows of a dashed curve are usually bare.
  const double rise_px = own_px ? w : seen.usual;
  const double top = lane.top(probe, 0.5 * (rise_px + line.usual), 2 * w + 3);
  if (ends.uppermost - top < least_px) return {};
  // If only the corner is thicker, there is no bottom-out.
  if (!isBottomOut(Thickness::between(lane, top, probe).value_or(seen))) return {};
  const double half = 0.5 * (top + probe);
  if (std::abs(lane.middle(top, half) - lane.middle(half, probe)) > kLean_px) return {};
  const double atFrame = top - area.frame.y0 <= kTopReached_px + w ? area.frame.y0 : top;
  return LostBottomOut{lane.middle(top, probe), curve.end().y, atFrame};
}

/// Number of points of a curve's vertical end on a line of the plot that another curve's colour explains.
std::size_t pointsOfOthers(const Curve& curve, const std::vector<Curve>& curves, const PlotScene& scene) {
  const double w = curve.thickness_px, riseStart = startOfRise(curve);
  const Point end = curve.end();
  if (curve.fromVector || w <= 0 || !isAtOneOf(scene.area().columns_px, end.x, w + 2)) return 0;
  const auto own_px = ownThickness(curve, endsBeside(curve, curves, scene.paper()), end.x, end.y,
                                   riseStart - 1.5 * w - 2, scene);
  if (!own_px || *own_px >= kNearer * w) return 0;
  const auto isStart = [&](Point p) { return p.y >= riseStart; };
  return static_cast<std::size_t>(std::find_if(curve.points.rbegin(), curve.points.rend(), isStart) -
                                  curve.points.rbegin());
}

/// The bottom-out of another curve, if this one ends beside it: strokes of one colour separate there, and a
/// press reaches the force from which its release comes back, hidden by the release.
std::optional<LostBottomOut> sharedBottomOut(const Curve& curve, const std::vector<Curve>& curves,
                                             const PlotScene& scene) {
  const PlotArea& area = scene.area();
  const double least_px = std::max(kLeastHeight * area.frame.height(), 3 * curve.thickness_px);
  for (const Curve& other : curves) {
    if (&other == &curve || !endTogether(curve, other)) continue;
    const bool hidden = other.color != curve.color;
    if (hidden && (curve.fromVector || curves.size() != 2 || !runsAbove(curve, other))) continue;
    if (hidden && startOfRise(curve) - curve.end().y > least_px) continue;  // not hidden
    const LostBottomOut bottomOut{other.end().x, curve.end().y, other.end().y};
    const double riseStart = startOfRise(other);
    if (riseStart - bottomOut.top < least_px || bottomOut.riseStart - bottomOut.top < least_px) continue;
    const auto between = Thickness::between({scene.coverageOf(curve.color), area, bottomOut.x}, riseStart,
                                            bottomOut.riseStart);
    if (hidden || !between || between->usual >= kNearer * curve.thickness_px) return bottomOut;
  }
  return {};
}

/// Number of points at the curve's end that lead down from a crest beside the bottom-out. Where strokes meet
/// on it, the upper one may have been followed down the lower one's end; a crest within a few widths of it is
/// no peak of the button.
std::size_t pointsOfHook(const Curve& curve, double x) {
  const double near_px = kHook * curve.thickness_px + kHook_px;
  const auto& points = curve.points;
  const auto first = std::ranges::find_if(points, [&](Point p) { return p.x >= x - near_px; });
  const auto crest = std::min_element(first, points.end(), [](Point a, Point b) { return a.y < b.y; });
  if (first == points.begin() || crest == first || crest == points.end()) return 0;
  return static_cast<std::size_t>(points.end() - crest) - 1;
}

/// Strokes of one colour are as thick as the thinnest; overlapping lines appear thicker.
void measureThickness(std::vector<Curve>& curves, const PlotScene& scene) {
  std::vector<double> seen_px;
  for (const Curve& curve : curves)
    seen_px.push_back(scene.coverageOf(curve.color).thicknessAlong(curve.points));
  for (Curve& curve : curves)
    for (std::size_t k = 0; k < curves.size(); ++k)
      if (curves[k].color == curve.color && seen_px[k] > 0)
        curve.thickness_px = curve.thickness_px > 0 ? std::min(curve.thickness_px, seen_px[k]) : seen_px[k];
}

/// Appends the bottom-out to the trace, at its right end.
void lengthen(CurveTrace& trace, const LostBottomOut& bottomOut, bool reversed, const PlotArea& area) {
  std::vector<Point> rise;
  const int steps = trace.fromVector ? 1 : std::max(1, static_cast<int>(bottomOut.riseStart - bottomOut.top));
  for (int i = trace.fromVector ? 0 : 1; i <= steps; ++i)
    rise.push_back(
        area.toView({bottomOut.x, bottomOut.riseStart + (bottomOut.top - bottomOut.riseStart) * i / steps}));
  if (reversed) std::ranges::reverse(rise);
  const auto at = reversed ? trace.points_px.begin() : trace.points_px.end();
  if (!trace.width_px.empty()) {
    const double width_px = reversed ? trace.width_px.front() : trace.width_px.back();
    trace.width_px.insert(reversed ? trace.width_px.begin() : trace.width_px.end(), rise.size(), width_px);
  }
  trace.points_px.insert(at, rise.begin(), rise.end());
}

/// The line in a curve's colour that begins on a lane above the curve's end: there is more of the colour than
/// on the same lane below the end, and more than one of the lanes beside it and the median of the plot's
/// other columns gain at the same rows.
std::optional<UnprovenBottomOut> riseOn(double x, const Curve& curve, const std::vector<Curve>& curves,
                                        const PlotScene& scene) {
  const PlotArea& area = scene.area();
  const double w = curve.thickness_px, margin = marginOf(curve), aside = 2 * kLaneReach_px + w;
  double uppermost = curve.end().y, lowest = curve.end().y;
  for (const Curve& other : curves) {
    if (endTogether(curve, other)) uppermost = std::min(uppermost, other.end().y);
    for (const Point& p : other.points)
      if (std::abs(p.x - x) <= kLaneReach_px + w) lowest = std::max(lowest, p.y);
  }
  const auto laneAt = [&](double at) { return LaneGain(scene, at, lowest + margin, area.frame.y1 - margin); };
  const PaletteColour own = paletteColourOf(curve.color, scene.paper());
  // Pixels of neither the paper nor the curve's colour are grid, frames of legends, letters.
  const PaletteColour neutral =
      paletteColourOf(isLight(scene.paper()) ? Rgb{0, 0, 0} : Rgb{255, 255, 255}, scene.paper());
  const bool isNeutral = static_cast<double>(dot(own.direction, neutral.direction)) > kSameColourAngle;
  // Vendors draw the frame's right edge twice above a curve's end.
  if (area.frame.x1 - x <= margin && isNeutral) return {};
  const LaneGain lane = laneAt(x);
  const auto blocked = [&](double y0, double y1) {
    const Box box{x - kLaneReach_px, y0, x + kLaneReach_px, y1};
    return std::ranges::any_of(area.words, [&](const Box& word) { return word.touches(box); }) ||
           std::ranges::any_of(curves, [&](const Curve& other) {
             return std::ranges::any_of(other.points, [&](Point p) { return box.contains(p); });
           });
  };
  const auto gainOf = [&](const LaneGain& each, double y0, double y1) {
    const auto gain = each.between(y0, y1);
    if (!gain) return std::optional<double>();
    return std::optional(isNeutral ? static_cast<double>(dot(*gain, own.direction) / own.strength)
                                   : thicknessIn(own, neutral, *gain));
  };
  const auto gainsOf = [&](const std::vector<LaneGain>& lanes, double y0, double y1) {
    std::vector<double> gains;
    for (const LaneGain& each : lanes)
      if (const auto gain = gainOf(each, y0, y1)) gains.push_back(*gain);
    return gains;
  };
  std::vector<double> dashes;  // the lane's own line below the end, window by window
  for (double y = lowest + margin; y + kWindow_px < area.frame.y1 - margin; y += kWindow_px + 1)
    if (const auto gain = gainOf(lane, y, y + kWindow_px)) dashes.push_back(*gain);
  if (dashes.empty()) return {};
  const double ownDash = std::max(0.0, quantileOf(dashes, 1 - kThinRows));
  // Other rivals: lines of the plot that change there too, and what is drawn over more than the lane.
  std::vector<LaneGain> columns, beside;
  for (const double column : area.columns_px)
    if (std::abs(column - x) > aside) columns.push_back(laneAt(column));
  for (const double at : {x - aside, x + aside})
    if (at < area.frame.x1 - kLaneReach_px) beside.push_back(laneAt(at));
  const double start = uppermost - margin;
  double top = start, most_px = 0;
  for (double y = start; y - kWindow_px > area.frame.y0 + kTopReached_px; y -= kWindow_px + 1) {
    if (blocked(y - kWindow_px, y)) break;
    const auto gain = gainOf(lane, y - kWindow_px, y);
    if (!gain) continue;  // a level line of the plot
    const std::vector<double> others = gainsOf(columns, y - kWindow_px, y),
                              sides = gainsOf(beside, y - kWindow_px, y);
    const double rival = std::max({ownDash, others.empty() ? 0.0 : medianOf(others),
                                   sides.empty() ? 0.0 : *std::ranges::min_element(sides)});
    if (*gain - rival < kFaintest_px) break;
    most_px = std::max(most_px, *gain - rival);
    top = y - kWindow_px;
  }
  if (start - top < std::max(kLeastHeight * area.frame.height(), kProbed_px)) return {};
  return UnprovenBottomOut{{x, start}, {x, top}, most_px};
}

}  // namespace

std::vector<UnprovenBottomOut> unprovenBottomOuts(const std::vector<CurveTrace>& traces,
                                                  const PlotScene& scene) {
  // The last error bar stands on the end of its curve as a bottom-out does.
  if (std::ranges::any_of(traces, [](const CurveTrace& trace) { return trace.errorBars > 0; })) return {};
  std::vector<Curve> curves;
  for (const CurveTrace& trace : traces)
    if (trace.points_px.size() >= 2) curves.push_back(curveOnArea(trace, scene.area()));
  measureThickness(curves, scene);
  for (Curve& curve : curves) curve.points = densified(curve.points, 1);
  std::vector<UnprovenBottomOut> rises;
  for (const Curve& curve : curves) {
    if (curve.thickness_px <= 0 || !scene.coverageOf(curve.color).distinct()) continue;
    const double x = curve.end().x, corner = kHook * curve.thickness_px + kHook_px;
    std::vector<double> lanes{x};
    for (const double column : scene.area().columns_px)  // a level stretch up to it may have been lost
      if (column > x && column <= x + corner) lanes.push_back(column);
    for (const double at : lanes)
      if (const auto rise = riseOn(at, curve, curves, scene)) {
        rises.push_back(*rise);
        break;
      }
  }
  return rises;
}

void addLostBottomOuts(std::vector<CurveTrace>& traces, const PlotScene& scene) {
  if (traces.empty() || scene.empty()) return;
  const PlotArea& area = scene.area();
  std::vector<Curve> curves;
  for (const CurveTrace& trace : traces) {
    if (trace.points_px.size() < 2) return;
    curves.push_back(curveOnArea(trace, area));
  }
  measureThickness(curves, scene);
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const std::size_t count = pointsOfOthers(curves[i], curves, scene);
    if (count == 0) continue;
    dropEnd(traces[i], count, true);
    curves[i].points.resize(curves[i].points.size() - count);
  }
  std::vector<std::optional<LostBottomOut>> bottomOuts(traces.size());
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (!scene.coverageOf(traces[i].color).distinct() || curves[i].thickness_px <= 0) continue;
    bottomOuts[i] = bottomOutAt(curves[i], curves, scene);
    if (!bottomOuts[i]) bottomOuts[i] = sharedBottomOut(curves[i], curves, scene);
  }
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (!bottomOuts[i]) continue;
    if (const std::size_t hook = pointsOfHook(curves[i], bottomOuts[i]->x)) {
      dropEnd(traces[i], hook, true);
      bottomOuts[i]->riseStart = curves[i].points[curves[i].points.size() - 1 - hook].y;
    }
    lengthen(traces[i], *bottomOuts[i], curves[i].reversed, area);
  }
}

}  // namespace detent::importer::trace
