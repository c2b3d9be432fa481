// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/graph_marks.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("GraphMarks", text); }

void addStrokeMarks(const StrokeCurve& curve, const StrokeValues& values, Stroke stroke,
                    std::vector<Mark>& marks) {
  std::vector<Mark> own;
  for (std::size_t i = 0; i < values.tactile.size(); ++i)
    own.push_back({{MarkKind::tactilePoint, stroke, i},
                   {values.tactile[i].displacement_mm, values.tactile[i].force_N}});
  for (std::size_t i = 0; i < values.turns.size(); ++i)
    own.push_back({{MarkKind::turn, stroke, i}, values.turns[i]});
  for (std::size_t i = 0; i < curve.knots().size(); ++i)
    own.push_back(
        {{MarkKind::knot, stroke, i}, {curve.knots()[i].displacement_mm, curve.knots()[i].force_N}});
  // Stable, so that a tactile point comes before the knot at its place.
  std::stable_sort(own.begin(), own.end(), [&](const Mark& a, const Mark& b) {
    return stroke == Stroke::press ? a.at.displacement_mm < b.at.displacement_mm
                                   : a.at.displacement_mm > b.at.displacement_mm;
  });
  marks.insert(marks.end(), own.begin(), own.end());
}

std::optional<CurvePoint> placeOnStroke(const std::optional<double>& displacement_mm,
                                        const StrokeCurve& curve) {
  if (!displacement_mm) return {};
  return CurvePoint{*displacement_mm, curve.force_N(*displacement_mm)};
}

}  // namespace

std::vector<Mark> pointMarks(const ButtonState& state, const GraphValues& values) {
  std::vector<Mark> marks;
  const ForceGraph& graph = state.graph;
  addStrokeMarks(graph.press(), values.press, Stroke::press, marks);
  if (graph.release() && values.release)
    addStrokeMarks(*graph.release(), *values.release, Stroke::release, marks);
  if (const auto at = placeOnStroke(state.operatingPoint_mm, graph.press()))
    marks.push_back({{MarkKind::operatingPoint, Stroke::press, 0}, *at});
  if (const auto at = placeOnStroke(state.resetPoint_mm, graph.curve(Stroke::release)))
    marks.push_back({{MarkKind::resetPoint, Stroke::release, 0}, *at});
  return marks;
}

std::optional<CurvePoint> placeOf(MarkId id, const ButtonState& state, const GraphValues& values) {
  const ForceGraph& graph = state.graph;
  if (id.kind == MarkKind::operatingPoint) return placeOnStroke(state.operatingPoint_mm, graph.press());
  if (id.kind == MarkKind::resetPoint)
    return placeOnStroke(state.resetPoint_mm, graph.curve(Stroke::release));
  if (id.stroke == Stroke::release && !(graph.release() && values.release)) return {};
  const StrokeCurve& curve = graph.curve(id.stroke);
  const StrokeValues& stroke = values.of(id.stroke);
  if (id.kind == MarkKind::tactilePoint) {
    if (id.index >= stroke.tactile.size()) return {};
    return CurvePoint{stroke.tactile[id.index].displacement_mm, stroke.tactile[id.index].force_N};
  }
  if (id.kind == MarkKind::turn) {
    if (id.index >= stroke.turns.size()) return {};
    return stroke.turns[id.index];
  }
  if (id.kind == MarkKind::section) {
    if (id.index >= stroke.sections.size()) return {};
    const double middle = 0.5 * (stroke.sections[id.index].from_mm + stroke.sections[id.index].to_mm);
    return CurvePoint{middle, curve.force_N(middle)};
  }
  if (id.index >= curve.knots().size()) return {};
  return CurvePoint{curve.knots()[id.index].displacement_mm, curve.knots()[id.index].force_N};
}

SlopeHandles slopeHandlesOf(const StrokeCurve& curve, std::size_t knot, const PlotMapping& map,
                            double length_px) {
  const std::vector<Knot>& knots = curve.knots();
  SlopeHandles handles;
  if (knot >= knots.size()) return handles;
  const Knot& k = knots[knot];
  const QPointF at = map.toPixel(k.displacement_mm, k.force_N);
  const auto along = [&](double slope, double sign) {
    const QPointF direction(map.pxPerX, -slope * map.pxPerY);
    return at + sign * length_px / std::hypot(direction.x(), direction.y()) * direction;
  };
  if (knot > 0 && knots[knot - 1].displacement_mm < k.displacement_mm)
    handles.before_px = along(k.slopeBefore_N_per_mm, -1);
  if (knot + 1 < knots.size() && knots[knot + 1].displacement_mm > k.displacement_mm)
    handles.after_px = along(k.slopeAfter_N_per_mm, 1);
  return handles;
}

QString nameOf(MarkId id) {
  const bool press = id.stroke == Stroke::press;
  const QString number = QString::number(id.index + 1);
  switch (id.kind) {
    case MarkKind::tactilePoint:
      return (press ? tr("Tactile point %1 of the press") : tr("Tactile point %1 of the release"))
          .arg(number);
    case MarkKind::turn:
      return (press ? tr("Valley or peak %1 of the press") : tr("Valley or peak %1 of the release"))
          .arg(number);
    case MarkKind::knot:
      return (press ? tr("Curve point %1 of the press") : tr("Curve point %1 of the release")).arg(number);
    case MarkKind::slopeBefore:
      return (press ? tr("Slope before curve point %1 of the press")
                    : tr("Slope before curve point %1 of the release"))
          .arg(number);
    case MarkKind::slopeAfter:
      return (press ? tr("Slope after curve point %1 of the press")
                    : tr("Slope after curve point %1 of the release"))
          .arg(number);
    case MarkKind::section:
      return (press ? tr("Section %1 of the press") : tr("Section %1 of the release")).arg(number);
    case MarkKind::operatingPoint:
      return tr("Operating point");
    case MarkKind::resetPoint:
      return tr("Reset point");
  }
  return {};
}

QString placeText(CurvePoint at, const DisplayUnits& units) {
  return tr("%1 %2, %3 %4")
      .arg(numberText(units.lengthFrom(at.displacement_mm), 5), units.lengthSymbol(),
           numberText(units.forceFrom(at.force_N), 5), units.forceSymbol());
}

QString describe(const Mark& mark, const DisplayUnits& units) {
  return tr("%1, %2").arg(nameOf(mark.id), placeText(mark.at, units));
}

}  // namespace detent::editor
