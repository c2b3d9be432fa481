// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/graph_values.h"

#include <algorithm>
#include <tuple>

namespace detent::editor {
namespace {

StrokeValues strokeValuesOf(const StrokeCurve& curve, Stroke stroke) {
  StrokeValues values{tactilePoints(curve, stroke), sectionsOf(curve, stroke), {}, bottomOutOf(curve)};
  std::vector<CurvePoint> turns = curve.localMaxima();
  for (const CurvePoint& p : curve.localMinima()) turns.push_back(p);
  std::sort(turns.begin(), turns.end(),
            [](const CurvePoint& a, const CurvePoint& b) { return a.displacement_mm < b.displacement_mm; });
  for (const CurvePoint& p : turns) {
    const bool tactile =
        std::any_of(values.tactile.begin(), values.tactile.end(),
                    [&](const TactilePoint& t) { return t.displacement_mm == p.displacement_mm; });
    if (!tactile) values.turns.push_back(p);
  }
  return values;
}

}  // namespace

GraphValues valuesOf(const ForceGraph& graph) {
  GraphValues values{strokeValuesOf(graph.press(), Stroke::press), {}, 0, 0};
  std::tie(values.lowest_N, values.highest_N) = graph.press().forceRange_N();
  if (graph.release()) {
    values.release = strokeValuesOf(*graph.release(), Stroke::release);
    const auto [lowest, highest] = graph.release()->forceRange_N();
    values.lowest_N = std::min(values.lowest_N, lowest);
    values.highest_N = std::max(values.highest_N, highest);
  }
  return values;
}

}  // namespace detent::editor
