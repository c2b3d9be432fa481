// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/trace_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "importer/trace/loop_confidence.h"
#include "importer/trace/loop_crossing.h"
#include "importer/trace/loop_pair.h"
#include "importer/trace/loop_refine.h"
#include "importer/trace/loop_structure.h"
#include "importer/trace/work_plane.h"

namespace detent::importer::trace {

namespace {

Failure noCurveFailure() {
  return {FailureCode::noForceGraph,
          "plot",
          "",
          Message("no curve of this colour runs through the plot frame"),
          {{RemedyKind::pickPress, {}}, {RemedyKind::giveFrame, "if another rectangle holds the graph"}}};
}

/// Below this the result is leaders or text: true loops, also dotted and on scans, stay above 0.3.
constexpr double kNotACurve = 0.15;

Failure doubtfulFailure(double confidence) {
  return failureOf({DoubtCode::resemblesNoLoop,
                    {{confidence, Measure::share}},
                    {{RemedyKind::pickPress, {}},
                     {RemedyKind::pickRelease, {}},
                     {RemedyKind::addMask, "over what is no curve"}}},
                   "curves");
}

/// A third curve over this share of the frame's width belongs to another switch
/// (docs/develop/decisions/0809-several-curves-in-one-colour.md).
constexpr double kAnotherCurve = 0.41;

Failure severalLoopsFailure(Rgb color) {
  return failureOf(
      {DoubtCode::tooManyCurves,
       {"two or more", nameOf(color)},
       {{RemedyKind::addMask, "over the curves of other switches"}, {RemedyKind::drawPress, {}}}},
      "curves");
}

/// On the plane, from area pixels.
std::vector<double> onPlane(std::vector<double> positions_px, double origin, double scale) {
  for (double& p : positions_px) p = (p - origin) / scale;
  return positions_px;
}

/// Boxes of read text on the plane; boxes too tall for a line of text were misread and are left out.
std::vector<Box> letteringOn(const WorkPlane& plane, const std::vector<Box>& words_px) {
  const double tallest = 0.12 * std::min(plane.frame.width(), plane.frame.height());
  std::vector<Box> out;
  for (const Box& word : words_px) {
    const Point a = plane.fromArea({word.x0, word.y0}), b = plane.fromArea({word.x1, word.y1});
    const Box box{a.x, a.y, b.x, b.y};
    if (std::min(box.width(), box.height()) <= tallest) out.push_back(box);
  }
  return out;
}

/// Points of a refined stroke at the requested spacing, with its width, in the order travelled.
CurveTrace loopTrace(const RefinedStroke& stroke, Stroke which, const PlotArea& area, double spacing_px) {
  CurveTrace trace;
  double since = spacing_px;
  Point before;
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    const Point p = area.toView(stroke.points[i]), beside = area.toView(stroke.points[i] + Point{1, 0});
    if (i > 0) since += distance(p, before);
    before = p;
    if (since < spacing_px - 1e-6 && i + 1 < stroke.points.size()) continue;
    since = 0;
    trace.points_px.push_back(p);
    trace.width_px.push_back(stroke.width_px * distance(p, beside));
  }
  if (which == Stroke::release) {
    std::reverse(trace.points_px.begin(), trace.points_px.end());
    std::reverse(trace.width_px.begin(), trace.width_px.end());
  }
  trace.stroke = which;
  return trace;
}

void showPlane(const Progress& progress, const Plane& grid, std::string_view label) {
  if (!progress.picture) return;
  Raster raster;
  raster.width_px = grid.width;
  raster.height_px = grid.height;
  for (float v : grid.values)
    raster.rgb.insert(raster.rgb.end(), 3,
                      static_cast<std::uint8_t>(std::lround(255 * (1 - std::clamp(v, 0.0F, 1.0F)))));
  progress.picture(label, raster);
}

/// Returns true if the remaining pixels are a curve of another switch.
bool showsAnother(const PlanePair& pair, const WorkPlane& plane) {
  return pair.further_px > kAnotherCurve * plane.frame.width() || pair.bottomOutLeftOver || pair.leftItsLine;
}

/// A release cannot start beyond the end of the press; two presses have separate ends.
bool comesFromFarther(const RefinedPair& strokes, bool bottomOutsCut) {
  // Of the press travel; 0.05 occurs where slanting bottom-outs are cut back to their dashes.
  const double within = bottomOutsCut ? 0.06 : 0.035;
  const auto &press = strokes.press.points, &release = strokes.release.points;
  if (press.empty() || release.empty()) return false;
  return release.back().x - press.back().x > within * (press.back().x - press.front().x);
}

/// Returns true if the strokes cross: two lines of two switches in one colour were separated into an upper
/// and a lower one.
bool strokesCross(const RefinedPair& strokes, const WorkPlane& plane) {
  const double size_px = plane.scale * std::hypot(plane.frame.width(), plane.frame.height());
  return linesCross(strokes.press.points, strokes.release.points, strokes.press.width_px, size_px);
}

}  // namespace

Result<std::vector<CurveTrace>> traceLoop(const PlotArea& area, const Plane& coverage, Rgb color,
                                          const TraceOptions& options, const Progress& progress) {
  const WorkPlane plane = makeWorkPlane(coverage, area);
  if (plane.frame.width() < 24 || plane.frame.height() < 24) return noCurveFailure();
  const std::vector<StraightLine> lines =
      findStraightLines(plane, onPlane(area.columns_px, plane.origin.x, plane.scale),
                        onPlane(area.rows_px, plane.origin.y, plane.scale));
  const Structure structure = explainStructure(plane, lines, letteringOn(plane, area.words));
  showPlane(progress, structure.remainingCoverage, "loop: ink left to the curves");
  if (progress.isCancelled()) return Failure::cancelled();

  const PlanePair pair = findPair(structure, plane);
  if (pair.press.size() < 8) return noCurveFailure();
  if (progress.isCancelled()) return Failure::cancelled();
  const RefinedPair refined = refinePair(pair, plane, coverage, lines, structure);
  const double confidence = judge(pair, refined, structure, plane).confidence();
  if (confidence < kNotACurve) return doubtfulFailure(confidence);
  if (showsAnother(pair, plane) || comesFromFarther(refined, pair.bottomOutsCut) ||
      strokesCross(refined, plane))
    return severalLoopsFailure(color);

  std::vector<CurveTrace> traces{loopTrace(refined.press, Stroke::press, area, options.pointSpacing_px)};
  if (!refined.release.points.empty())
    traces.push_back(loopTrace(refined.release, Stroke::release, area, options.pointSpacing_px));
  for (CurveTrace& trace : traces) {
    trace.color = color;
    trace.confidence = confidence;
  }
  return traces;
}

}  // namespace detent::importer::trace
