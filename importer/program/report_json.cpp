// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/report_json.h"

#include <cstdio>

#include <nlohmann/json.hpp>

namespace detent::importer {
namespace {

using Json = nlohmann::ordered_json;

const char* statusOf(FailureCode code) {
  switch (code) {
    case FailureCode::internalFault:
      return "internal_fault";
    case FailureCode::wrongUsage:
      return "wrong_usage";
    case FailureCode::unreadableInput:
      return "unreadable_input";
    case FailureCode::noForceGraph:
      return "no_force_graph";
    case FailureCode::notCertain:
      return "not_certain";
    case FailureCode::deviceTrouble:
      return "device_trouble";
  }
  return "";
}

Json axisJson(const AxisReading& axis) {
  return {{"unit", axis.unit}, {"min", axis.min}, {"max", axis.max}, {"residual_px", axis.residual_px}};
}

Json strokeJson(const StrokeReport& stroke) {
  Json points = Json::array();
  for (const FittedTactilePoint& p : stroke.fit.tactilePoints) {
    points.push_back({{"displacement_mm", p.point.displacement_mm},
                      {"force_N", p.point.force_N},
                      {"sigma_mm", p.sigma_mm},
                      {"sigma_N", p.sigma_N}});
  }
  return {{"pieces", stroke.fit.pieces}, {"rms_px", stroke.rms_px}, {"tactile_points", std::move(points)}};
}

Json checksJson(const std::vector<SpecCheck>& checks) {
  Json all = Json::array();
  for (const SpecCheck& check : checks) {
    all.push_back({{"agrees", check.agrees},
                   {"read", check.read},
                   {"printed", check.spec.nominal},
                   {"page", check.spec.page},
                   {"text", check.spec.text}});
  }
  return all;
}

/// Text from a page may be anything; JSON must stay valid.
std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

void appendRows(std::string& csv, const char* stroke, const std::vector<CurvePoint>& points) {
  char row[96];
  for (const CurvePoint& p : points) {
    std::snprintf(row, sizeof row, "%s,%.9g,%.9g\n", stroke, p.displacement_mm, p.force_N);
    csv += row;
  }
}

}  // namespace

std::string reportJson(const ImportReport& report, const std::string& input,
                       const std::vector<std::string>& outputs) {
  Json json = {{"status", "ok"}, {"input", input}, {"page", report.page}, {"graph", report.graph}};
  if (report.x) json["x_axis"] = axisJson(*report.x);
  if (report.y) json["y_axis"] = axisJson(*report.y);
  json["press"] = strokeJson(report.press);
  if (report.release) json["release"] = strokeJson(*report.release);
  const ButtonState& state = report.button.states().front();
  if (state.operatingPoint_mm) json["operating_point_mm"] = *state.operatingPoint_mm;
  if (state.resetPoint_mm) json["reset_point_mm"] = *state.resetPoint_mm;
  json["travel_mm"] = state.graph.travel_mm();
  json["quality"] = nameOf(report.quality);
  json["confidence"] = report.confidence;
  json["seconds"] = report.seconds;
  json["warnings"] = report.warnings;
  if (!report.specChecks.empty()) json["printed_values"] = checksJson(report.specChecks);
  json["outputs"] = outputs;
  return dumped(json);
}

std::string failureJson(const Failure& failure, const std::string& input) {
  return dumped({{"status", statusOf(failure.code)},
                 {"input", input},
                 {"exit_code", failure.exitCode()},
                 {"problem", failure.sentence()},
                 {"place", failure.place},
                 {"remedy", failure.remedy}});
}

std::string listJson(const std::vector<ListedGraph>& graphs, const std::vector<std::string>& warnings) {
  Json listed = Json::array();
  for (const ListedGraph& g : graphs) {
    const auto axis = [](const AxisReading& a) {
      return Json{{"unit", a.unit}, {"min", a.min}, {"max", a.max}};
    };
    listed.push_back({{"page", g.page},
                      {"graph", g.graph},
                      {g.unit == PageUnit::point ? "frame_pt" : "frame_px",
                       {g.frame.x0, g.frame.y0, g.frame.x1, g.frame.y1}},
                      {"rotated_deg", 90 * g.quarterTurns},
                      {"x_axis", axis(g.x)},
                      {"y_axis", axis(g.y)},
                      {"confidence", g.confidence}});
  }
  Json json = {{"graphs", std::move(listed)}};
  if (!warnings.empty()) json["warnings"] = warnings;
  return dumped(json);
}

std::string traceCsv(const StrokePair& strokes) {
  std::string csv = "stroke,displacement_mm,force_N\n";
  appendRows(csv, "press", strokes.press.points);
  if (strokes.release) appendRows(csv, "release", strokes.release->points);
  return csv;
}

}  // namespace detent::importer
