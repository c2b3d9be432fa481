// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/trace_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "importer/trace/loop_confidence.h"
#include "importer/trace/loop_pair.h"
#include "importer/trace/loop_plane.h"
#include "importer/trace/loop_refine.h"
#include "importer/trace/loop_structure.h"

namespace detent::importer {

namespace {

Failure cancelledFailure() { return {FailureCode::wrongUsage, "trace", "", "cancelled", "Start it again"}; }

Failure noCurveFailure() {
  return {FailureCode::noForceGraph, "plot", "", "no curve runs through the plot frame in this ink",
          "Pass --press-color, or --frame if another rectangle holds the graph"};
}

/// Below this what was followed is leaders, lettering or rubbish: true loops, also dotted and on scans, stay
/// above 0.3.
constexpr double kNotACurve = 0.15;

Failure doubtfulFailure(double confidence) {
  const int percent = static_cast<int>(std::lround(100 * confidence));
  return {FailureCode::notCertain, "curves", "",
          "what can be followed in this ink does not look like a force curve (confidence " +
              std::to_string(percent) + " %)",
          "Pass --press-color and --release-color, or --mask over what is no curve"};
}

InkLayer withoutMasks(InkLayer ink, const std::vector<Box>& masks) {
  for (const Box& m : masks) {
    const int x0 = std::max(0, static_cast<int>(std::floor(m.x0))),
              x1 = std::min(ink.width_px - 1, static_cast<int>(std::ceil(m.x1)));
    const int y0 = std::max(0, static_cast<int>(std::floor(m.y0))),
              y1 = std::min(ink.height_px - 1, static_cast<int>(std::ceil(m.y1)));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        ink.coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(ink.width_px) +
                     static_cast<std::size_t>(x)] = 0;
      }
    }
  }
  return ink;
}

/// The point of an edge where the given coordinate is reached.
Point onEdge(Point a, Point b, double value, bool byX) {
  const double span = byX ? b.x - a.x : b.y - a.y;
  const double f = std::abs(span) > 1e-9 ? (value - (byX ? a.x : a.y)) / span : 0;
  return {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)};
}

std::vector<double> planeColumns(const PlotFrame& frame, const loop::Plane& plane) {
  std::vector<double> out;
  for (const GridLine& l : frame.xLines) {
    if (l.spansFrame)
      out.push_back(plane.plane(onEdge(frame.corners[3], frame.corners[2], l.position_px, true)).x);
  }
  return out;
}

std::vector<double> planeRows(const PlotFrame& frame, const loop::Plane& plane) {
  std::vector<double> out;
  for (const GridLine& l : frame.yLines) {
    if (l.spansFrame)
      out.push_back(plane.plane(onEdge(frame.corners[0], frame.corners[3], l.position_px, false)).y);
  }
  return out;
}

/// Boxes of read text on the plane; what is too tall for a line of text was misread and is left out.
std::vector<Box> letteringOn(const loop::Plane& plane, const std::vector<SeenText>& texts) {
  std::vector<Box> out;
  for (const SeenText& t : texts) {
    if (t.confidence < 0.3 || t.box.empty() || t.utf8.size() < 2) continue;
    const Point a = plane.plane({t.box.x0, t.box.y0}), b = plane.plane({t.box.x1, t.box.y1});
    const Box box{std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
    if (std::min(box.width(), box.height()) > 0.12 * std::min(plane.frame.width(), plane.frame.height()))
      continue;
    if (box.x1 < 0 || box.y1 < 0 || box.x0 > plane.ink.width || box.y0 > plane.ink.height) continue;
    out.push_back(box);
  }
  return out;
}

/// Points of a refined stroke at the asked spacing, with its width.
void fillTrace(CurveTrace& trace, const loop::RefinedStroke& stroke, double spacing) {
  double since = spacing;
  for (std::size_t i = 0; i < stroke.points_px.size(); ++i) {
    if (i > 0)
      since += std::hypot(stroke.points_px[i].x - stroke.points_px[i - 1].x,
                          stroke.points_px[i].y - stroke.points_px[i - 1].y);
    if (since < spacing - 1e-6 && i + 1 < stroke.points_px.size()) continue;
    since = 0;
    trace.points_px.push_back(stroke.points_px[i]);
    trace.width_px.push_back(stroke.width_px[i]);
  }
}

void showPlane(const Progress& progress, const loop::Grid& grid, std::string_view label) {
  if (!progress.picture) return;
  Raster raster;
  raster.width_px = grid.width;
  raster.height_px = grid.height;
  for (float v : grid.values)
    raster.rgb.insert(raster.rgb.end(), 3,
                      static_cast<std::uint8_t>(std::lround(255 * (1 - std::clamp(v, 0.0F, 1.0F)))));
  progress.picture(label, raster);
}

}  // namespace

Result<std::vector<CurveTrace>> traceLoop(const InkLayer& ink, const PlotFrame& frame, const AxesFound& axes,
                                          const TraceHints& hints, const TraceOptions& options,
                                          const Progress& progress) {
  const InkLayer masked = hints.masks_px.empty() ? InkLayer{} : withoutMasks(ink, hints.masks_px);
  const InkLayer& used = hints.masks_px.empty() ? ink : masked;
  if (used.width_px < 16 || used.height_px < 16) return noCurveFailure();
  const loop::Plane plane = loop::makePlane(used, frame, {});
  if (plane.frame.width() < 24 || plane.frame.height() < 24) return noCurveFailure();
  const std::vector<loop::StraightLine> lines =
      loop::findStraightLines(plane, planeColumns(frame, plane), planeRows(frame, plane));
  const loop::Structure structure = loop::explainStructure(plane, lines, letteringOn(plane, axes.texts));
  showPlane(progress, structure.curveInk, "loop: ink left to the curves");
  if (progress.isCancelled()) return cancelledFailure();

  const loop::PlanePair pair = loop::findPair(structure, plane);
  if (pair.press.size() < 8) return noCurveFailure();
  if (progress.isCancelled()) return cancelledFailure();
  const loop::RefinedPair refined = loop::refinePair(pair, plane, used, lines, structure);
  const double confidence = loop::judge(pair, refined, structure, plane).confidence();
  if (confidence < kNotACurve) return doubtfulFailure(confidence);

  std::vector<CurveTrace> traces;
  const auto add = [&](const loop::RefinedStroke& stroke, Stroke which) {
    CurveTrace trace;
    fillTrace(trace, stroke, options.pointSpacing_px);
    if (which == Stroke::release) {
      std::reverse(trace.points_px.begin(), trace.points_px.end());
      std::reverse(trace.width_px.begin(), trace.width_px.end());
    }
    trace.color = ink.color;
    trace.confidence = confidence;
    trace.stroke = which;
    traces.push_back(std::move(trace));
  };
  add(refined.press, Stroke::press);
  if (!refined.release.empty()) add(refined.release, Stroke::release);
  return traces;
}

}  // namespace detent::importer
