// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/hit_test.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/curve_path.h"

namespace detent::editor {
namespace {

int rankOf(MarkKind kind) {
  switch (kind) {
    case MarkKind::slopeBefore:
    case MarkKind::slopeAfter:
      return 0;
    case MarkKind::tactilePoint:
      return 1;
    case MarkKind::operatingPoint:
    case MarkKind::resetPoint:
      return 2;
    case MarkKind::turn:
      return 3;
    case MarkKind::knot:
      return 4;
    case MarkKind::section:
      return 5;
  }
  return 6;
}

struct Candidate {
  Mark mark;
  double distance_px;
};

double hitDistance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

void addHandles(const GraphCanvas& canvas, const PlotMapping& map, QPointF at_px, double within_px,
                std::vector<Candidate>& found) {
  const auto& selected = canvas.selected();
  if (!selected || (selected->kind != MarkKind::knot && !isSlope(selected->kind))) return;
  const SlopeHandles handles =
      slopeHandlesOf(canvas.state().graph.curve(selected->stroke), selected->index, map);
  const auto offer = [&](const std::optional<QPointF>& end, MarkKind kind) {
    if (!end || hitDistance(*end, at_px) > within_px) return;
    const QPointF place = map.toPlot(*end);
    found.push_back(
        {{{kind, selected->stroke, selected->index}, {place.x(), place.y()}}, hitDistance(*end, at_px)});
  };
  offer(handles.before_px, MarkKind::slopeBefore);
  offer(handles.after_px, MarkKind::slopeAfter);
}

// Nearest place of a polyline's lines to a point.
void nearestOfLine(QPointF a, QPointF b, QPointF p, QPointF& best, double& reach) {
  const QPointF along = b - a;
  const double length = QPointF::dotProduct(along, along);
  const double t = length > 0 ? std::clamp(QPointF::dotProduct(p - a, along) / length, 0.0, 1.0) : 0;
  const QPointF place = a + t * along;
  if (hitDistance(place, p) > reach) return;
  best = place;
  reach = hitDistance(place, p);
}

}  // namespace

std::vector<Mark> marksAt(const GraphCanvas& canvas, QPointF at_px, double within_px) {
  const PlotMapping map = canvas.mapping();
  std::vector<Candidate> found;
  addHandles(canvas, map, at_px, within_px, found);
  for (const Mark& mark : pointMarks(canvas.state(), canvas.values())) {
    const double d = hitDistance(map.toPixel(mark.at.displacement_mm, mark.at.force_N), at_px);
    if (d <= within_px) found.push_back({mark, d});
  }
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    const int ra = rankOf(a.mark.id.kind), rb = rankOf(b.mark.id.kind);
    return ra != rb ? ra < rb : a.distance_px < b.distance_px;
  });
  std::vector<Mark> marks;
  for (const Candidate& candidate : found) marks.push_back(candidate.mark);
  return marks;
}

std::optional<CurveHit> curveAt(const GraphCanvas& canvas, QPointF at_px, double within_px) {
  PlotMapping near = canvas.mapping();
  near.clip_px = QRectF(at_px.x() - within_px, at_px.y() - within_px, 2 * within_px, 2 * within_px);
  std::optional<CurveHit> hit;
  double reach = within_px;
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    const ForceGraph& graph = canvas.state().graph;
    if (stroke == Stroke::release && !graph.release()) continue;
    const StrokeCurve& curve = graph.curve(stroke);
    QPointF best;
    double d = reach;
    bool found = false;
    const QPolygonF line = curveOutline(curve, near.toPlot(near.clip_px.topLeft()).x(),
                                        near.toPlot(near.clip_px.topRight()).x(), near);
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
      const double before = d;
      nearestOfLine(line[i], line[i + 1], at_px, best, d);
      found = found || d < before;
    }
    if (!found) continue;
    reach = d;
    const double x = std::clamp(near.toPlot(best).x(), curve.start_mm(), curve.end_mm());
    hit = CurveHit{stroke, {x, curve.force_N(x)}, d};
  }
  return hit;
}

std::optional<std::size_t> sectionAt(const StrokeValues& values, double displacement_mm) {
  for (std::size_t i = 0; i < values.sections.size(); ++i) {
    const auto [from, to] = std::minmax(values.sections[i].from_mm, values.sections[i].to_mm);
    if (displacement_mm >= from && displacement_mm <= to && from < to) return i;
  }
  return {};
}

}  // namespace detent::editor
