// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/steps_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"

namespace detent::importer {
namespace {

using StepsJson = nlohmann::ordered_json;

/// Rounded to a hundredth of a pixel.
double rounded(double value_px) { return std::round(value_px * 100) / 100; }

StepsJson boxJson(const Box& box) {
  return {rounded(box.x0), rounded(box.y0), rounded(box.x1), rounded(box.y1)};
}

StepsJson tokensJson(const AxesFound& axes) {
  StepsJson tokens = StepsJson::array();
  for (const auto* texts : {&axes.texts, &axes.otherLines})
    for (const SeenText& text : *texts)
      tokens.push_back({{"text", text.utf8},
                        {"box", boxJson(text.box)},
                        {"angle_deg", text.angle_deg},
                        {"confidence", text.confidence},
                        {"list", texts == &axes.texts ? "texts" : "other_lines"}});
  return tokens;
}

StepsJson scaleJson(const AxisReading& axis) {
  StepsJson ticks = StepsJson::array();
  for (const TickLabel& tick : axis.ticks)
    ticks.push_back({{"text", tick.text},
                     {"value", tick.value},
                     {"position_px", rounded(tick.position_px)},
                     {"used", tick.used}});
  return {{"title", axis.title},
          {"unit", axis.unit},
          {"unit_found", axis.unitFound},
          {"other_quantity", axis.otherQuantity},
          {"min", axis.min},
          {"max", axis.max},
          {"residual_px", axis.residual_px},
          {"ticks", std::move(ticks)}};
}

StepsJson polylinesJson(const std::vector<CurveTrace>& traces) {
  StepsJson polylines = StepsJson::array();
  for (const CurveTrace& trace : traces) {
    StepsJson points = StepsJson::array();
    for (const Point p : trace.points_px) points.push_back({rounded(p.x), rounded(p.y)});
    polylines.push_back({{"color", nameOf(trace.color)},
                         {"label", trace.label},
                         {"label_box", boxJson(trace.labelBox_px)},
                         {"stroke", !trace.stroke                    ? ""
                                    : *trace.stroke == Stroke::press ? "press"
                                                                     : "release"},
                         {"vector", trace.fromVector},
                         {"confidence", trace.confidence},
                         {"points", std::move(points)}});
  }
  return polylines;
}

StepsJson switchesJson(const std::vector<PlotSwitch>& switches) {
  StepsJson all = StepsJson::array();
  for (const PlotSwitch& each : switches) all.push_back({{"name", each.name}, {"polylines", each.traces}});
  return all;
}

StepsJson findingsJson(const std::vector<StepFinding>& steps) {
  StepsJson all = StepsJson::array();
  for (const StepFinding& step : steps) {
    StepsJson evidence = StepsJson::array();
    for (const EvidenceItem& item : step.evidence) evidence.push_back(nameOf(item.code));
    all.push_back({{"step", nameOf(step.step)},
                   {"confidence", step.confidence},
                   {"given", step.by == DecidedBy::given},
                   {"evidence", std::move(evidence)}});
  }
  return all;
}

StepsJson outcomeJson(const Result<ImportReport>& report) {
  if (!report)
    return {{"status", "refused"},
            {"exit_code", report.failure().exitCode()},
            {"reason", report.failure().reason},
            {"message", report.failure().sentence()}};
  StepsJson codes = StepsJson::array();
  for (const Remark& remark : report->remarks) codes.push_back(nameOf(remark.code));
  return {{"status", "ok"}, {"confidence", report->confidence}, {"remarks", std::move(codes)}};
}

StepsJson pairJson(const StrokePair& strokes) {
  const auto ends = [](const StrokePoints& stroke) -> StepsJson {
    return {{"points", stroke.points.size()},
            {"from", {stroke.points.front().displacement_mm, stroke.points.front().force_N}},
            {"to", {stroke.points.back().displacement_mm, stroke.points.back().force_N}}};
  };
  StepsJson pair = {{"press", ends(strokes.press)}};
  if (strokes.release) pair["release"] = ends(*strokes.release);
  return pair;
}

}  // namespace

std::string stepsJson(const ImportAttempt& attempt, const std::string& input) {
  StepsJson json = {{"input", input}, {"outcome", outcomeJson(attempt.report)}};
  if (attempt.evidence) {
    const GraphEvidence& seen = *attempt.evidence;
    StepsJson frame = StepsJson::array();
    for (const Point corner : seen.frame.corners) frame.push_back({rounded(corner.x), rounded(corner.y)});
    json["frame_px"] = std::move(frame);
    json["tokens"] = tokensJson(seen.axes);
    json["axes"] = {{"x", scaleJson(seen.axes.calibration.value.x)},
                    {"y", scaleJson(seen.axes.calibration.value.y)}};
    json["polylines"] = polylinesJson(seen.traces);
    json["switches"] = switchesJson(seen.switches);
    json["steps"] = findingsJson(seen.steps);
  }
  if (attempt.report) json["pair"] = pairJson(attempt.report->strokes);
  return jsonText(json) + "\n";
}

}  // namespace detent::importer
