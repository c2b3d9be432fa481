// SPDX-License-Identifier: GPL-3.0-or-later
// Step 4, reading order: plot_scene.h (what is visible) -> trace_vector.h (paths, exact) -> here (which
// colours draw curves) -> plot_text, colour_palette, colour_coverage, curve_choice, follow_curve,
// centre_line, line_ends (curves in colours of their own) or trace_loop.h (both strokes in one colour).

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <optional>
#include <set>

#include "importer/trace/bottom_outs.h"
#include "importer/trace/centre_line.h"
#include "importer/trace/colour_shades.h"
#include "importer/trace/curve_choice.h"
#include "importer/trace/curve_trace.h"
#include "importer/trace/dashed_beside.h"
#include "importer/trace/edge_cut.h"
#include "importer/trace/legend_words.h"
#include "importer/trace/line_ends.h"
#include "importer/trace/plot_scene.h"
#include "importer/trace/trace_loop.h"
#include "importer/trace/trace_vector.h"

namespace detent::importer {

namespace {

using namespace trace;

constexpr double kCredibleLoop = 0.5;  // below this another colour may hold the curves

Failure noCurve(Message why) {
  return {FailureCode::noForceGraph,
          "plot frame",
          "",
          std::move(why),
          {{RemedyKind::giveFrame, "if the plot stands elsewhere"},
           {RemedyKind::pickPress, "with the curve's colour"}}};
}

/// Colours named by the user, as indices into the palette; -1: not named.
struct GivenColours {
  int press = -1, release = -1;

  bool any() const { return press >= 0 || release >= 0; }
};

/// Adds given colours to the palette; a found colour of the same direction keeps its measured shade.
GivenColours addGivenColours(std::vector<PaletteColour>& palette, const TraceHints& hints,
                             const PlotScene& scene) {
  const auto indexOf = [&](const std::optional<Rgb>& color) {
    if (!color) return -1;
    const PaletteColour colour = paletteColourOf(*color, scene.paper());
    const auto same = std::find_if(palette.begin(), palette.end(), [&](const PaletteColour& other) {
      return static_cast<double>(dot(other.direction, colour.direction)) > kSameColourAngle;
    });
    const int index = static_cast<int>(same - palette.begin());
    if (same == palette.end()) palette.push_back(colour);
    return index;
  };
  GivenColours given;
  given.press = indexOf(hints.pressColor);
  given.release = indexOf(hints.releaseColor);
  return given;
}

/// Cuts a beginning that falls along the force axis. A stroke starts at rest and rises, so the falling part
/// is the axis, which rotation smears into the curve's colour.
void cutFallAlongAxis(CurveTrace& trace, const PlotFrame& frame) {
  constexpr double within_px = 4, leastShare = 0.02;  // of the frame's height
  const Point topLeft = frame.corners[0], bottomLeft = frame.corners[3];
  const double height = distance(topLeft, bottomLeft);
  const auto besideAxis = [&](Point p) {
    return std::abs(cross(p - topLeft, bottomLeft - topLeft)) / std::max(1.0, height) <= within_px;
  };
  std::vector<Point>& points = trace.points_px;
  if (points.size() < 2 || height <= 0) return;
  if (points.front().x > points.back().x) return;  // drawn from the right, ends at rest
  const auto leaves = std::find_if_not(points.begin(), points.end(), besideAxis);
  const auto lowest = std::max_element(points.begin(), leaves, [](Point a, Point b) { return a.y < b.y; });
  if (lowest == leaves || leaves == points.end()) return;
  if (lowest->y - points.front().y < leastShare * height) return;
  dropEnd(trace, static_cast<std::size_t>(lowest - points.begin()), false);
}

/// The centre line of a curve with a known path, in the view.
CurveTrace lineAlong(const CoarseCurve& path, const CurveField& field, double thickness_px,
                     const PaletteColour& colour, const PlotColours& plot, const TraceOptions& options) {
  const PlotArea& area = plot.area();
  CentreLine line = centreLine(field, path, thickness_px);
  finishEnds(line, field, area.frame);
  CurveTrace trace;
  trace.color = plot.colorOf(colour);
  trace.errorBars = plot.errorBars;
  trace.confidence = std::clamp(0.3 + 0.7 * std::min(1.0, path.coveredShare), 0.0, 1.0);
  Point last{};
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Point p = area.toView(line.points[i]);
    const bool end = i == 0 || i + 1 == line.points.size();
    if (!end && distance(p, last) < 0.95 * options.pointSpacing_px) continue;
    trace.points_px.push_back(p);
    const Point q = area.toView({line.points[i].x + 1, line.points[i].y});
    trace.width_px.push_back(line.profile.width_px * distance(p, q));
    last = p;
  }
  return trace;
}

/// A curve in its own colour; `curveInks`: those of all curves.
CurveTrace traceOf(const CurveColour& curve, const std::vector<int>& curveColours, const PlotColours& plot,
                   const TraceOptions& options) {
  const CurveField field = fieldOf(plot, curve.entryIndex, curveColours);
  FollowOptions follow;
  follow.thickness_px = curve.thickness_px;
  const std::optional<CurveField> joined = curve.dashed ? dashesJoined(field) : std::nullopt;
  const CoarseCurve path = followCurve(joined ? *joined : field, plot.area().frame, follow);
  return lineAlong(path, curve.dashed ? besideDashesOnly(field) : field, curve.thickness_px,
                   plot.entry(curve.entryIndex), plot, options);
}

/// The palette's other colours, when pixels are attributed to a colour.
enum class OtherColours {
  compete,  ///< a pixel belongs to the colour that fits it best
  ignored   ///< for the colour of grid and text, of which other colours are no blends
};

/// Coverage of the area by one colour, for curves that share it with each other and perhaps with grid and
/// text.
Plane coverageBy(const PaletteColour& colour, OtherColours others, const PlotColours& plot) {
  const PlotArea& area = plot.area();
  Plane coverage(area.raster.width_px, area.raster.height_px);
  const float floor = std::max(4.0F, 3 * plot.scene.noise());
  for (int y = 0; y < coverage.height; ++y)
    for (int x = 0; x < coverage.width; ++x) {
      if (!area.masked.empty() && area.masked[coverage.index(x, y)]) continue;
      const Color3 difference = plot.scene.pixel(x, y) - plot.scene.paperAt(x, y);
      const float length = norm(difference);
      if (length < floor) continue;
      float own = dot(difference, colour.direction) / colour.strength;
      if (others == OtherColours::compete) {
        // Pixels that fit another colour better keep only a share of this one, as blends.
        float bestOther = 0;
        for (const PaletteColour& other : plot.palette) {
          if (static_cast<double>(dot(other.direction, colour.direction)) > kSameColourAngle) continue;
          bestOther = std::max(bestOther, dot(difference, other.direction) / length);
        }
        const float fit = dot(difference, colour.direction) / length;
        if (bestOther > fit) own *= std::max(0.0F, 1 - 8 * (bestOther - fit));
      }
      coverage.at(x, y) = std::clamp(own, 0.0F, 1.0F);
    }
  return coverage;
}

/// The palette entry of everything that is not coloured: from the paper to the darkest (on dark paper:
/// lightest) colour.
PaletteColour darkness(const PlotColours& plot) {
  PaletteColour dark;
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k) {
    const PaletteColour& colour = plot.entry(k);
    if (isNeutral(plot, k) && colour.strength > dark.strength) dark = colour;
  }
  if (dark.strength > 0) return dark;
  const Color3 paper = plot.scene.paper();
  const bool light = isLight(paper);
  dark.strength = std::max(1.0F, norm(light ? paper : Color3{255, 255, 255} - paper));
  dark.direction = (1 / dark.strength) * (light ? Color3{} - paper : Color3{255, 255, 255} - paper);
  return dark;
}

Mask either(const Mask& a, const Mask& b) {
  if (b.empty()) return a;
  Mask bothMasks = a;
  for (std::size_t i = 0; i < bothMasks.size(); ++i) bothMasks[i] = bothMasks[i] | b[i];
  return bothMasks;
}

/// Sets the strokes of curves whose colour the user gave.
void nameGivenStrokes(std::vector<CurveTrace>& traces, const std::vector<CurveColour>& curves,
                      const GivenColours& given) {
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (curves[i].entryIndex == given.press) traces[i].stroke = Stroke::press;
    if (curves[i].entryIndex == given.release) traces[i].stroke = Stroke::release;
  }
}

/// Given colours as they are; if only one is given the other stroke is searched.
std::vector<CurveColour> findCurves(const PlotColours& plot, const GivenColours& given) {
  if (!given.any()) return chooseCurveColours(plot);
  std::vector<CurveColour> curves = curvesOfColours(plot, {given.press, given.release});
  if (given.press >= 0 && given.release >= 0) return curves;
  for (CurveColour& found : chooseCurveColours(plot))
    if (found.entryIndex != given.press && found.entryIndex != given.release)
      curves.push_back(std::move(found));
  return curves;
}

/// Curves of which two are shades of one colour, and the colours they were chosen from.
struct ShadedCurves {
  PlotColours plot;
  std::vector<CurveColour> curves;
};

/// Beside two shades of one colour a second switch in the colour of frame and text, if both its strokes have
/// a shade of it too.
ShadedCurves withNeutralShades(ShadedCurves shaded, double least_px) {
  const std::optional<CurveColour> other = neutralCurveBeside(shaded.plot, shaded.curves.front());
  if (!other) return shaded;
  const auto k = static_cast<std::size_t>(other->entryIndex);
  const auto paler =
      palerShade(shaded.plot.scene, shaded.plot.palette[k], shaded.plot.coverage.planes[k], least_px);
  if (paler) {
    std::vector<PaletteColour> palette = shaded.plot.palette;
    palette.push_back(*paler);
    ShadedCurves bothCurves{PlotColours(shaded.plot.scene, std::move(palette)), shaded.curves};
    std::vector<CurveColour> two =
        curvesInShades(bothCurves.plot, other->entryIndex, static_cast<int>(shaded.plot.palette.size()));
    if (two.size() == 2) {
      std::ranges::move(two, std::back_inserter(bothCurves.curves));
      return bothCurves;
    }
  }
  shaded.curves.push_back(*other);
  return shaded;
}

/// If directions of colour gave one curve or none: one drawn in a paler shade of another, of frame and text,
/// or of the curve itself.
std::optional<ShadedCurves> curvesByShade(const PlotColours& plot, const std::vector<CurveColour>& found) {
  const double least_px = 0.5 * plot.options.minSpan * plot.area().frame.width();
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k) {
    const bool ofCurve = !found.empty() && found.front().entryIndex == k;
    if (!ofCurve && !isNeutral(plot, k)) continue;
    const auto paler =
        palerShade(plot.scene, plot.entry(k), plot.coverage.planes[static_cast<std::size_t>(k)], least_px);
    if (!paler) continue;
    std::vector<PaletteColour> palette = plot.palette;
    palette.push_back(*paler);
    ShadedCurves shaded{PlotColours(plot.scene, std::move(palette)), {}};
    const int newIndex = static_cast<int>(plot.palette.size());
    shaded.curves =
        ofCurve || found.empty() ? curvesInShades(shaded.plot, k, newIndex) : chooseCurveColours(shaded.plot);
    if (shaded.curves.size() != 2) continue;
    return ofCurve ? withNeutralShades(std::move(shaded), least_px) : std::move(shaded);
  }
  return {};
}

/// Distance, in diagonals of the frame, before the line it runs into at which a dashed line may seem to end:
/// a dash that touches that line counts as its edge.
constexpr double kDashesEndBefore = 0.03;

/// Extends a dashed line along the solid one from where it runs into it, to the common end of both strokes
/// and to zero force. Returns false if it does not reach that end: not a stroke of the same switch, or only
/// part of one.
bool joinAtEnds(CurveTrace& dashed, const CurveTrace& solid, double most_px) {
  std::vector<Point> ownPoints = solid.points_px;
  if (ownPoints.front().x > ownPoints.back().x) std::ranges::reverse(ownPoints);
  std::vector<Point>& points = dashed.points_px;
  if (points.front().x > points.back().x) std::ranges::reverse(points), std::ranges::reverse(dashed.width_px);
  const auto nearestTo = [&](Point end) {
    return std::ranges::min_element(ownPoints, {}, [&](Point p) { return distance(p, end); });
  };
  constexpr double mostOfTravel = 0.15;  // under the other line; beyond this, dashes were lost
  const double unseen_px = mostOfTravel * (ownPoints.back().x - ownPoints.front().x);
  const double width_px = dashed.width_px.front();
  const auto endsAt = nearestTo(points.back());
  if (distance(*endsAt, points.back()) > most_px || ownPoints.back().x - points.back().x > unseen_px)
    return false;
  points.insert(points.end(), endsAt, ownPoints.end());
  const bool startsNear = points.front().x - ownPoints.front().x <= unseen_px;
  if (const auto near = nearestTo(points.front()); startsNear && distance(*near, points.front()) <= most_px)
    points.insert(points.begin(), ownPoints.begin(), std::next(near));
  dashed.width_px.resize(points.size(), width_px);
  return true;
}

/// Press and release in one colour, one solid and one dashed; empty otherwise.
std::vector<CurveTrace> partedByDashes(const CurveTrace& solid, const CurveColour& curve,
                                       const std::vector<int>& curveColours, const PlotColours& plot,
                                       const TraceOptions& options) {
  const auto beside = dashedBeside(solid, curve, curveColours, plot);
  if (!beside) return {};
  CurveTrace dashed =
      lineAlong(beside->path, beside->field, curve.thickness_px, plot.entry(curve.entryIndex), plot, options);
  if (dashed.points_px.size() < 2) return {};
  const Box& frame = plot.area().frame;
  if (!joinAtEnds(dashed, solid, kDashesEndBefore * std::hypot(frame.width(), frame.height()))) return {};
  const auto meanRow = [](const CurveTrace& trace) {
    double sum = 0;
    for (const Point& p : trace.points_px) sum += p.y;
    return sum / static_cast<double>(trace.points_px.size());
  };
  std::vector<CurveTrace> strokes{solid, std::move(dashed)};
  const bool isPress = meanRow(strokes[0]) < meanRow(strokes[1]);
  strokes[0].stroke = isPress ? Stroke::press : Stroke::release;
  strokes[1].stroke = isPress ? Stroke::release : Stroke::press;
  return strokes;
}

/// Splits every trace whose colour draws both strokes into press and release; both keep its label. A curve
/// with only marks beside it stays whole. Of one or two traces either all are split or none is.
std::vector<CurveTrace> withLoopsParted(const std::vector<CurveTrace>& traces,
                                        const std::vector<CurveColour>& curves, const PlotColours& plot,
                                        const TraceOptions& options, const Progress& progress) {
  const auto loopIn = [&](std::size_t i) {
    std::vector<CurveTrace> strokes;
    if (curves[i].secondStrand <= plot.options.secondStrand) return strokes;
    const Plane& ownPlane = plot.coverage.planes[static_cast<std::size_t>(curves[i].entryIndex)];
    auto loop = traceLoop(plot.area(), ownPlane, traces[i].color, options, progress);
    if (loop && loop->size() > 1 && loop->front().confidence >= kCredibleLoop)
      strokes = std::move(loop).value();
    return strokes;
  };
  std::vector<int> curveColours;
  for (const CurveColour& curve : curves) curveColours.push_back(curve.entryIndex);
  const bool allOrNone = traces.size() <= 2;
  std::vector<CurveTrace> all;
  for (std::size_t i = 0; i < traces.size() && !progress.isCancelled(); ++i) {
    std::vector<CurveTrace> strokes = loopIn(i);
    if (strokes.empty()) strokes = partedByDashes(traces[i], curves[i], curveColours, plot, options);
    if (strokes.empty() && allOrNone) return traces;
    if (strokes.empty()) all.push_back(traces[i]);
    for (CurveTrace& stroke : strokes) {
      stroke.label = traces[i].label;
      stroke.labelBox_px = traces[i].labelBox_px;
      all.push_back(std::move(stroke));
    }
  }
  return all;
}

/// A coloured loop and, if drawn, a second one in the colour of frame and text, each with its label.
std::vector<CurveTrace> withNeutralLoop(std::vector<CurveTrace> loop, const CurveColour& ownColour,
                                        const PlotColours& plot, const AxesFound& axes, const PageView& view,
                                        const TraceOptions& options, const Progress& progress) {
  if (loop.size() != 2) return loop;
  const std::optional<CurveColour> other = neutralCurveBeside(plot, ownColour);
  if (!other) return loop;
  const Plane& coverage = plot.coverage.planes[static_cast<std::size_t>(other->entryIndex)];
  auto second =
      traceLoop(plot.area(), coverage, plot.colorOf(plot.entry(other->entryIndex)), options, progress);
  if (!second || second->size() != 2 || second->front().confidence < kCredibleLoop) return loop;
  std::vector<CurveTrace> named{loop.front(), second->front()};
  labelTraces(named, axes, view, plot.scene);
  std::ranges::move(*second, std::back_inserter(loop));
  for (std::size_t i = 0; i < loop.size(); ++i)
    loop[i].label = named[i / 2].label, loop[i].labelBox_px = named[i / 2].labelBox_px;
  return loop;
}

/// Returns true if a traced point is near. The straight connection across a gap of the trace does not count.
bool isNearPointOf(const CurveTrace& trace, Point p, double within_px) {
  return std::ranges::any_of(trace.points_px, [&](Point q) { return distance(p, q) <= within_px; });
}

/// Share of a trace's points that are near traced points of another one.
double shareNearPointsOf(const CurveTrace& other, const CurveTrace& trace) {
  constexpr double within_px = 1.5;
  const auto on =
      std::ranges::count_if(trace.points_px, [&](Point p) { return isNearPointOf(other, p, within_px); });
  return static_cast<double>(on) / static_cast<double>(std::max<std::size_t>(1, trace.points_px.size()));
}

/// Returns true if a trace begins later or ends earlier than the others, or lies on another one: its colour
/// was lost.
bool anyLost(const std::vector<CurveTrace>& traces) {
  constexpr double mostOf = 0.93,
                   same = 0.8;  // of the travel of all traces; of a path that lies on another
  double from = std::numeric_limits<double>::max(), to = std::numeric_limits<double>::lowest();
  const auto extent = [](const CurveTrace& t) {
    const auto [left, right] = std::ranges::minmax(t.points_px, {}, &Point::x);
    return std::pair(left.x, right.x);
  };
  for (const CurveTrace& trace : traces) {
    if (trace.points_px.empty()) return true;
    from = std::min(from, extent(trace).first);
    to = std::max(to, extent(trace).second);
  }
  return std::ranges::any_of(traces, [&](const CurveTrace& trace) {
    const auto [left, right] = extent(trace);
    const bool onAnother = std::ranges::any_of(traces, [&](const CurveTrace& other) {
      return &other != &trace && shareNearPointsOf(other, trace) > same;
    });
    return right - left < mostOf * (to - from) || onAnother;
  });
}

/// Returns true if a trace stops below the others' tops, which happens when its colour is lost on the
/// bottom-out.
bool anyStopsLow(const std::vector<CurveTrace>& traces) {
  constexpr double lower = 0.12;  // of the height of all traces
  std::vector<double> tops;
  double bottom = 0;
  for (const CurveTrace& trace : traces) {
    if (trace.points_px.empty()) return false;  // a colour without a path says nothing about a bottom-out
    const auto [top, low] = std::ranges::minmax(trace.points_px, {}, &Point::y);
    tops.push_back(top.y);
    bottom = std::max(bottom, low.y);
  }
  const auto [highest, lowest] = std::ranges::minmax(tops);
  return lowest > highest + lower * (bottom - highest);
}

/// Returns true if the part of a stroke beyond its trace runs where no other trace does.
bool goesOnAlone(const CurveTrace& stroke, const CurveTrace& ownTrace,
                 const std::vector<CurveTrace>& traces) {
  constexpr double apart_px = 3, alone = 0.25;  // px; share of the part beyond
  double beyond = 0, shared = 0;
  for (Point p : stroke.points_px) {
    if (isNearPointOf(ownTrace, p, apart_px)) continue;
    ++beyond;
    shared += std::ranges::any_of(traces,
                                  [&](const CurveTrace& other) { return isNearPointOf(other, p, apart_px); })
                  ? 1
                  : 0;
  }
  return shared <= (1 - alone) * beyond;
}

/// Returns true if a stroke reaches the frame's top before its end: the frame is a part of the plot's.
bool leavesByTheTop(const CurveTrace& stroke, const PlotArea& area) {
  constexpr double touching_px = 2, endsWithin = 0.15;  // px; the last share of the stroke's width
  const Box& frame = area.frame;
  const double top = area.toView({frame.x0, frame.y0}).y;
  const auto [left, right] = std::ranges::minmax(stroke.points_px, {}, &Point::x);
  const double before = right.x - endsWithin * (right.x - left.x);
  return std::ranges::any_of(stroke.points_px,
                             [&](Point p) { return p.x < before && p.y < top + touching_px; });
}

/// Returns true if a stroke continues to the right of all coloured traces: colours are lost on steep
/// stretches, not along a horizontal line, which is the plot's own.
bool outrunsColours(const CurveTrace& stroke, const std::vector<CurveTrace>& traces, double frame_px) {
  constexpr double most = 0.04;  // share of the frame's width
  const auto rightOf = [](const CurveTrace& trace) {
    return std::ranges::max(trace.points_px, {}, &Point::x).x;
  };
  double known_px = std::numeric_limits<double>::lowest();
  for (const CurveTrace& trace : traces)
    if (!trace.points_px.empty()) known_px = std::max(known_px, rightOf(trace));
  return rightOf(stroke) > known_px + most * frame_px;
}

/// Follows both strokes as one colour if a stroke was lost by its colour. In a small picture colours blend,
/// and close strokes have none of their own; in medium ones steep thin lines lose theirs at half-resolution
/// colour. Accepted if the coloured traces lie on the result and each legend name stays with one stroke
/// (docs/develop/decisions/0408-small-print.md).
std::optional<std::vector<CurveTrace>> withoutColours(const std::vector<CurveTrace>& traces,
                                                      const PlotColours& plot, const TraceOptions& options,
                                                      const Progress& progress) {
  constexpr double smallFrame_px = 360, mediumFrame_px = 720,
                   agreeing = 0.9;  // widths; of a path that lies on a stroke
  const double width_px = plot.area().frame.width();
  if (traces.size() < 2 || width_px > mediumFrame_px || plot.errorBars > 0) return {};
  const bool small = width_px <= smallFrame_px && anyLost(traces);
  if (!small && !anyStopsLow(traces)) return {};
  auto loop = traceLoop(plot.area(), coverageBy(darkness(plot), OtherColours::ignored, plot),
                        traces.front().color, options, progress);
  if (!loop || loop->size() != 2 || loop->front().confidence < kCredibleLoop) return {};
  std::vector<CurveTrace> strokes = std::move(loop).value();
  for (const CurveTrace& stroke : strokes)
    if (leavesByTheTop(stroke, plot.area()) || outrunsColours(stroke, traces, width_px)) return {};
  for (const CurveTrace& trace : traces)
    if (std::max(shareNearPointsOf(strokes[0], trace), shareNearPointsOf(strokes[1], trace)) < agreeing)
      return {};
  for (CurveTrace& stroke : strokes) {
    const auto nearer = [&](const CurveTrace& a, const CurveTrace& b) {
      return shareNearPointsOf(a, stroke) < shareNearPointsOf(b, stroke);
    };
    const CurveTrace& ownTrace = *std::ranges::max_element(traces, nearer);
    if (!small && !goesOnAlone(stroke, ownTrace, traces)) return {};
    stroke.color = ownTrace.color, stroke.label = ownTrace.label, stroke.labelBox_px = ownTrace.labelBox_px;
    stroke.stroke.reset();  // their positions tell which is which, as with colours
  }
  const auto isKept = [&](const CurveTrace& trace) {
    return trace.label.empty() || std::ranges::count(strokes, trace.label, &CurveTrace::label) == 1;
  };
  if (!std::ranges::all_of(traces, isKept)) return {};
  return strokes;
}

Result<std::vector<CurveTrace>> traceRaster(const PlotScene& scene, const PageView& view,
                                            const AxesFound& axes, const TraceHints& hints,
                                            const TraceOptions& options, const Progress& progress) {
  std::vector<PaletteColour> palette =
      findColours(scene, either(scene.lettering().mask, scene.area().masked));
  addLetterColour(palette, scene);
  const GivenColours given = addGivenColours(palette, hints, scene);
  if (palette.empty()) return noCurve(Message("the plot frame is empty: it shows only paper and gridlines"));
  if (progress.isCancelled()) return Failure::cancelled();

  const PlotColours plot(scene, std::move(palette));
  std::vector<CurveColour> curves = findCurves(plot, given);
  if (given.any() && curves.empty())
    return noCurve(Message("no line in the plot frame has one of the given colours"));
  const std::optional<ShadedCurves> shaded =
      !given.any() && curves.size() < 2 ? curvesByShade(plot, curves) : std::nullopt;
  if (shaded) curves = shaded->curves;
  if (progress.isCancelled()) return Failure::cancelled();
  const bool oneColourBothStrokes =
      curves.size() == 1 && curves.front().secondStrand > plot.options.secondStrand;
  if (curves.empty() || oneColourBothStrokes) {
    // A press alone keeps its words: a legend with both keys in its colour names a release that was not
    // found.
    const auto loopIn = [&](const PaletteColour& colour, OtherColours others) {
      auto loop =
          traceLoop(scene.area(), coverageBy(colour, others, plot), plot.colorOf(colour), options, progress);
      if (loop && loop->size() == 1) labelTraces(*loop, axes, view, scene);
      return loop;
    };
    if (curves.empty()) return loopIn(darkness(plot), OtherColours::ignored);
    Result<std::vector<CurveTrace>> loop =
        loopIn(plot.entry(curves.front().entryIndex), OtherColours::compete);
    const double believed = loop.ok() ? loop->front().confidence : 0;
    if (given.any() || progress.isCancelled()) return loop;
    if (believed >= kCredibleLoop)
      return withNeutralLoop(std::move(loop).value(), curves.front(), plot, axes, view, options, progress);
    // Coloured leaders and dots can resemble a colour of curves; then the curves have the neutral colour.
    Result<std::vector<CurveTrace>> neutral = loopIn(darkness(plot), OtherColours::ignored);
    return neutral.ok() && neutral->front().confidence > believed ? neutral : loop;
  }

  const std::vector<CurveColour> chosen = curves;
  const PlotColours finalPlot(scene, reducedPalette(shaded ? shaded->plot : plot, curves));
  std::vector<int> curveColours;
  for (const CurveColour& curve : curves) curveColours.push_back(curve.entryIndex);
  std::vector<CurveTrace> traces;
  for (const CurveColour& curve : curves) traces.push_back(traceOf(curve, curveColours, finalPlot, options));
  for (std::size_t i = 1; shaded && i < chosen.size(); ++i)
    if (areShades(shaded->plot.entry(chosen[i - 1].entryIndex), shaded->plot.entry(chosen[i].entryIndex)))
      leadBeside(traces[i], traces[i - 1]), leadBeside(traces[i - 1], traces[i]);
  nameGivenStrokes(traces, chosen, given);
  labelTraces(traces, axes, view, scene);
  if (given.any()) return traces;
  if (auto strokes = withoutColours(traces, finalPlot, options, progress)) return std::move(*strokes);
  std::vector<CurveTrace> parted = withLoopsParted(traces, curves, finalPlot, options, progress);
  for (std::size_t i = 1; i < parted.size(); ++i)
    if (parted[i].color == parted[i - 1].color) nameByDashes(parted[i - 1], parted[i], axes, view, scene);
  return parted;
}

/// Names curves of a drawing whose legend shows no lines as in a picture, by filled squares and letters. Both
/// strokes of a colour get the same name.
void labelDrawn(std::vector<CurveTrace>& traces, const AxesFound& axes, const PageView& view,
                const PlotScene& scene) {
  if (scene.empty() || std::ranges::any_of(traces, [](const CurveTrace& t) { return !t.label.empty(); }))
    return;
  std::vector<CurveTrace> firstOfColours;
  for (const CurveTrace& trace : traces) {
    const bool isNew =
        std::ranges::find(firstOfColours, trace.color, &CurveTrace::color) == firstOfColours.end();
    if (!isNew && !trace.stroke) return;  // the dash pattern distinguishes a line from another of its colour
    if (isNew) firstOfColours.push_back(trace);
  }
  labelTraces(firstOfColours, axes, view, scene);
  for (CurveTrace& trace : traces) {
    const CurveTrace& ownTrace = *std::ranges::find(firstOfColours, trace.color, &CurveTrace::color);
    trace.label = ownTrace.label, trace.labelBox_px = ownTrace.labelBox_px;
  }
}

}  // namespace

std::string nameOf(Rgb color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color.r, color.g, color.b);
  return text;
}

std::optional<Rgb> colorFrom(std::string_view text) {
  if (text.starts_with('#')) text.remove_prefix(1);
  unsigned value = 0;
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, value, 16);
  if (text.size() != 6 || error != std::errc() || after != end) return {};
  const auto part = [&](unsigned shift) { return static_cast<std::uint8_t>(value >> shift & 0xFFU); };
  return Rgb{part(16), part(8), part(0)};
}

Result<std::vector<CurveTrace>> traceCurves(const PageView& view, const PlotScene& scene,
                                            const AxesFound& axes, const TraceHints& hints,
                                            const TraceOptions& options, const Progress& progress) {
  if (!(options.pointSpacing_px > 0 && options.pointSpacing_px <= 16))
    return Failure{FailureCode::wrongUsage, "point spacing", "",
                   Message("the point spacing must be above 0 and at most 16 px"),
                   Message("Leave the value at 1")};
  std::vector<CurveTrace> exact = traceVector(view, scene.plotFrame(), axes, hints);
  if (!exact.empty()) {
    addLostBottomOuts(exact, scene);
    labelDrawn(exact, axes, view, scene);
    return exact;
  }
  if (scene.empty()) return noCurve(Message("the plot frame lies outside the picture or has no area"));
  auto traces = traceRaster(scene, view, axes, hints, options, progress);
  if (!traces) return traces;
  for (CurveTrace& trace : *traces) cutFallAlongAxis(trace, scene.plotFrame());
  cutAcrossToEdges(*traces, scene);
  // The last error bar stands on the end of its curve as a bottom-out does.
  if (std::ranges::none_of(*traces, [](const CurveTrace& trace) { return trace.errorBars > 0; }))
    addLostBottomOuts(*traces, scene);
  return traces;
}

}  // namespace detent::importer
