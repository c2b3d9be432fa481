// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/report_json.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"

namespace detent::importer {
namespace {

using Json = nlohmann::ordered_json;

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
  return {{"pieces", stroke.fit.pieces},
          {"rms_px", stroke.rms_px},
          {"condition", stroke.fit.condition},
          {"tactile_points", std::move(points)}};
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

Json curvesJson(const std::vector<PlotSwitch>& switches) {
  Json curves = Json::array();
  for (const PlotSwitch& each : switches) {
    Json curve = {
        {"curve", curves.size() + 1}, {"name", each.name}, {"press_color", nameOf(each.pressColor)}};
    if (each.releaseColor) curve["release_color"] = nameOf(*each.releaseColor);
    curves.push_back(std::move(curve));
  }
  return curves;
}

Json readingsJson(const std::vector<ReadingSummary>& readings) {
  Json all = Json::array();
  for (const ReadingSummary& pageReading : readings) {
    Json each = {{"magnification", pageReading.magnification},
                 {"confidence", pageReading.confidence},
                 {"taken", pageReading.taken}};
    if (pageReading.travel_mm) {
      each["travel_mm"] = *pageReading.travel_mm;
      each["highest_force_N"] = *pageReading.highest_N;
      each["release"] = pageReading.release;
    }
    if (!pageReading.problem.empty()) each["problem"] = english(pageReading.problem);
    all.push_back(std::move(each));
  }
  return all;
}

/// Adds "warnings" as sentences, for people and old scripts, and their codes in the same order.
void addRemarks(Json& json, const std::vector<Remark>& remarks) {
  json["warnings"] = Json::array();
  json["warning_codes"] = Json::array();
  for (const Remark& remark : remarks) {
    json["warnings"].push_back(commandLineWords(remark));
    json["warning_codes"].push_back(nameOf(remark.code));
  }
}

void addInterpretations(Json& json, const std::vector<ExplainedInterpretation>& explained) {
  for (const ExplainedInterpretation& each : explained) {
    Json terms = Json::array();
    for (const EvidenceTerm& term : each.evidence.terms())
      terms.push_back({{"name", term.name}, {"about", term.about}, {"log_likelihood", term.logLikelihood}});
    json["interpretations"].push_back(
        {{"reading", each.reading}, {"sum", each.evidence.total()}, {"evidence", std::move(terms)}});
  }
}

void appendRows(std::string& csv, const char* stroke, const std::vector<CurvePoint>& points) {
  char row[96];
  for (const CurvePoint& p : points) {
    std::snprintf(row, sizeof row, "%s,%.9g,%.9g\n", stroke, p.displacement_mm, p.force_N);
    csv += row;
  }
}

}  // namespace

std::string reportJson(const ImportReport& report, const std::string& input,
                       const std::vector<std::string>& outputs,
                       const std::vector<ExplainedInterpretation>& explained) {
  Json json = {{"status", "ok"}, {"input", input}, {"page", report.page}, {"graph", report.graph}};
  if (report.curve) {
    const std::vector<PlotSwitch>& all = report.evidence->switches;
    json["curve"] = {{"number", *report.curve}, {"name", all[*report.curve - 1].name}, {"of", all.size()}};
  }
  if (report.x) json["x_axis"] = axisJson(*report.x);
  if (report.y) json["y_axis"] = axisJson(*report.y);
  json["press"] = strokeJson(report.press);
  if (report.release) json["release"] = strokeJson(*report.release);
  const ButtonState& state = report.button.states().front();
  if (state.operatingPoint_mm) json["operating_point_mm"] = *state.operatingPoint_mm;
  if (state.resetPoint_mm) json["reset_point_mm"] = *state.resetPoint_mm;
  json["travel_mm"] = state.graph.travel_mm();
  if (report.pressSpeed) json["press_speed_mm_per_s"] = report.pressSpeed->mean_mm_per_s;
  if (report.releaseSpeed) json["release_speed_mm_per_s"] = report.releaseSpeed->mean_mm_per_s;
  json["quality"] = nameOf(report.quality);
  json["confidence"] = report.confidence;
  if (report.pageClass) json["page_class"] = nameOf(*report.pageClass);
  json["seconds"] = Json::object();
  for (const auto& [step, seconds] : report.seconds) json["seconds"][std::string(nameOf(step))] = seconds;
  if (!report.readings.empty()) json["looks"] = readingsJson(report.readings);
  if (report.endedByTimeLimit) json["ended_by_time_limit"] = true;
  addRemarks(json, report.remarks);
  if (!report.specChecks.empty()) json["printed_values"] = checksJson(report.specChecks);
  addInterpretations(json, explained);
  json["outputs"] = outputs;
  return jsonText(json);
}

std::string failureJson(const Failure& failure, const std::string& input,
                        const std::vector<PlotSwitch>& switches, const std::optional<Question>& question,
                        const std::vector<ExplainedInterpretation>& explained) {
  Json remedies = Json::array();
  for (const Remedy& remedy : failure.remedies) remedies.push_back(nameOf(remedy.kind));
  Json json = {{"status", nameOf(failure.code)},     {"input", input},
               {"exit_code", failure.exitCode()},    {"problem", failure.sentence()},
               {"place", english(failure.place)},    {"remedy", commandLineWords(failure.remedies)},
               {"remedy_codes", std::move(remedies)}};
  if (!failure.reason.empty()) json["reason"] = failure.reason;
  if (switches.size() > 1) json["curves"] = curvesJson(switches);
  if (question) {
    Json choices = Json::array();
    for (const Choice& choice : question->choices)
      choices.push_back({{"text", choice.text}, {"option", choice.option}});
    json["question"] = {{"what", question->what}, {"choices", std::move(choices)}};
  }
  addInterpretations(json, explained);
  return jsonText(json);
}

std::string recordsJson(const std::vector<ListedRecord>& records) {
  Json all = Json::array();
  for (const ListedRecord& each : records)
    all.push_back({{"record", all.size() + 1},
                   {"name", each.name},
                   {"travel_mm", each.travel_mm},
                   {"highest_force_N", each.highest_N},
                   {"release", each.release}});
  return jsonText(Json{{"records", std::move(all)}});
}

std::string listJson(const std::vector<ListedPlot>& plots, const std::vector<Remark>& remarks) {
  Json listed = Json::array();
  for (const auto& [g, switches] : plots) {
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
                      {"confidence", g.confidence},
                      {"curves", curvesJson(switches)}});
  }
  Json json = {{"graphs", std::move(listed)}};
  if (!remarks.empty()) addRemarks(json, remarks);
  return jsonText(json);
}

std::string traceCsv(const StrokePair& strokes) {
  std::string csv = "stroke,displacement_mm,force_N\n";
  appendRows(csv, "press", strokes.press.points);
  if (strokes.release) appendRows(csv, "release", strokes.release->points);
  return csv;
}

}  // namespace detent::importer
