// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/traced_project.h"

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/number_table.h"
#include "model/sampling.h"

namespace detent {

namespace {

using Json = nlohmann::ordered_json;

/// A known place of the page: WebPlotDigitizer keeps the values as they were typed.
Json knownPoint(const PlotFrame& frame, double x, double y) {
  return {{"px", frame.xPx(x)},
          {"py", frame.yPx(y)},
          {"dx", shortestText(x)},
          {"dy", shortestText(y)},
          {"dz", nullptr}};
}

Json axesOf(const PlotFrame& frame, const std::string& name) {
  const double left = frame.x.first, right = frame.x.last(), low = frame.y.first, high = frame.y.last();
  return {{"name", name},
          {"type", "XYAxes"},
          {"isLogX", false},
          {"isLogY", false},
          {"noRotation", true},
          {"calibrationPoints", Json::array({knownPoint(frame, left, low), knownPoint(frame, right, low),
                                             knownPoint(frame, left, low), knownPoint(frame, left, high)})}};
}

Json setOf(const ForceGraph& graph, Stroke stroke, const PlotFrame& frame, const std::string& axes,
           const SvgPlotStyle& style) {
  Json data = Json::array();
  for (const CurvePoint& p : travelledSamples(graph, stroke)) {
    const double x = p.displacement_mm / millimetresPer(style.lengthUnit),
                 y = p.force_N / newtonsPer(style.forceUnit);
    data.push_back({{"x", frame.xPx(x)}, {"y", frame.yPx(y)}, {"value", {x, y}}});
  }
  const bool press = stroke == Stroke::press;
  return {{"name", press ? "press" : "release"},
          {"axesName", axes},
          {"metadataKeys", Json::array()},
          {"colorRGB", press ? Json{200, 0, 0, 255} : Json{0, 80, 200, 255}},
          {"data", std::move(data)},
          {"autoDetectionData", nullptr}};
}

}  // namespace

std::string tracedProjectFrom(const ButtonState& state, const SvgPlotStyle& style) {
  const PlotFrame frame = frameOfPlot(state, style);
  const std::string axes =
      std::string(symbolOf(style.lengthUnit)) + ", " + std::string(symbolOf(style.forceUnit));
  Json sets = Json::array({setOf(state.graph, Stroke::press, frame, axes, style)});
  if (state.graph.release()) sets.push_back(setOf(state.graph, Stroke::release, frame, axes, style));
  const Json project = {{"version", {4, 2}},
                        {"axesColl", Json::array({axesOf(frame, axes)})},
                        {"datasetColl", std::move(sets)},
                        {"measurementColl", Json::array()}};
  return jsonText(project) + '\n';
}

}  // namespace detent
