// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/graph_report.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/key_figures.h"
#include "model/metrics.h"
#include "model/speed_family.h"

namespace detent {
namespace {

using nlohmann::ordered_json;

template <class... Values>
std::string format(const char* pattern, Values... values) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, pattern, values...);
  return buffer;
}

std::string oneLine(const ordered_json& value) { return jsonText(value) + "\n"; }

const char* nameOf(SectionKind kind) {
  switch (kind) {
    case SectionKind::slope:
      return "slope";
    case SectionKind::jump:
      return "jump";
    case SectionKind::bottomOut:
      return "bottom-out";
  }
  return "";
}

// ---- average

std::string textOf(const StateSpread& state) {
  std::string text;
  for (const FigureSpread& each : state.figures) {
    const KeyFigureName& name = keyFigureNames()[static_cast<std::size_t>(each.figure)];
    const std::string key(name.key);
    text += each.sd ? format("  %-24s %9.4g +- %.2g (%.4g to %.4g), %zu units\n", key.c_str(), each.mean,
                             *each.sd, each.least, each.most, each.units)
                    : format("  %-24s %9.4g, 1 unit\n", key.c_str(), each.mean);
  }
  return text;
}

ordered_json jsonOf(const StateSpread& state, const std::string& name) {
  ordered_json figures = ordered_json::object();
  for (const FigureSpread& each : state.figures)
    figures[std::string(keyFigureNames()[static_cast<std::size_t>(each.figure)].key)] = {
        {"units", each.units},
        {"mean", each.mean},
        {"sd", each.sd ? ordered_json(*each.sd) : ordered_json(nullptr)},
        {"least", each.least},
        {"most", each.most}};
  const auto band = [](const ToleranceBand& points) {
    ordered_json list = ordered_json::array();
    for (const BandPoint& each : points)
      list.push_back(
          {{"displacement_mm", each.displacement_mm}, {"mean_N", each.mean_N}, {"sd_N", each.sd_N}});
    return list;
  };
  return {{"name", name},
          {"figures", std::move(figures)},
          {"press_band", band(state.press)},
          {"release_band", band(state.release)}};
}

// ---- show

std::string textOf(const StrokeMetrics& stroke, const char* name, std::size_t knots) {
  std::string text = format("%s: %zu knots, %.4g to %.4g N, work %.4g mJ\n", name, knots, stroke.minForce_N,
                            stroke.maxForce_N, stroke.work_mJ);
  for (const TactileEvent& e : stroke.tactile) {
    text += format("  tactile point %.4g N at %.4g mm", e.point.force_N, e.point.displacement_mm);
    if (e.following)
      text += format(", then %.4g N at %.4g mm", e.following->force_N, e.following->displacement_mm);
    if (e.snapRatio) text += format(", snap ratio %.1f %%", 100 * *e.snapRatio);
    if (e.jump)
      text += format(", jump to %.4g mm (%.4g mJ)", e.jump->to_mm, e.jumpArea_mJ);
    else
      text += ", inside an earlier jump";
    text += "\n";
  }
  for (const Section& s : stroke.sections)
    text += format("  %-10s %8.4g -> %8.4g mm  %8.4g -> %8.4g N\n", nameOf(s.kind), s.from_mm, s.to_mm,
                   s.fromForce_N, s.toForce_N);
  return text;
}

/// The state with its graph at another speed, to calculate the key figures of that graph.
ButtonState ofOtherSpeed(const ButtonState& state, const SpeedGraph& other) {
  return {state.name, other.graph, state.operatingPoint_mm, state.resetPoint_mm, state.damping};
}

std::string textOf(const ButtonState& state) {
  const StateMetrics m = metricsOf(state);
  std::string text;
  if (!state.name.empty()) text += "State \"" + state.name + "\"\n";
  text += format("Travel: %.6g mm\n", m.travel_mm);
  if (m.operatingPoint)
    text += format("Operating point: %.4g mm, %.4g N\n", m.operatingPoint->displacement_mm,
                   m.operatingPoint->force_N);
  if (m.resetPoint)
    text += format("Reset point: %.4g mm, %.4g N\n", m.resetPoint->displacement_mm, m.resetPoint->force_N);
  text += textOf(m.press, "Press", state.graph.press().knots().size());
  if (m.release) text += textOf(*m.release, "Release", state.graph.release()->knots().size());
  if (m.hysteresisArea_mJ) text += format("Hysteresis: %.4g mJ\n", *m.hysteresisArea_mJ);
  if (!state.damping.empty())
    text += format("Damping: %zu points, %.4g to %.4g mm\n", state.damping.size(),
                   state.damping.front().displacement_mm, state.damping.back().displacement_mm);
  if (state.speed_mm_per_s) text += format("The above: at %.6g mm/s\n", *state.speed_mm_per_s);
  for (const SpeedGraph& other : state.otherSpeeds) {
    const StateMetrics there = metricsOf(ofOtherSpeed(state, other));
    text += format("At %.6g mm/s\n", other.speed_mm_per_s) +
            textOf(there.press, "Press", other.graph.press().knots().size());
    if (there.release) text += textOf(*there.release, "Release", other.graph.release()->knots().size());
  }
  return text;
}

std::string textOf(const Provenance& p) {
  std::string text = "Imported from: " + p.sourceFile + format(", page %d, graph %d", p.page, p.graph);
  if (!p.quality.empty()) text += ", quality " + p.quality;
  text += format(", confidence %.2f\n", p.confidence);
  for (const std::string& given : p.given) text += "  given by hand: " + given + "\n";
  for (const RecordedWarning& warning : p.warnings) text += "  warning: " + warning.text + "\n";
  return text;
}

ordered_json jsonOf(const CurvePoint& p) {
  return {{"displacement_mm", p.displacement_mm}, {"force_N", p.force_N}};
}

ordered_json jsonOf(const Section& s) {
  return {{"kind", nameOf(s.kind)},
          {"from_mm", s.from_mm},
          {"to_mm", s.to_mm},
          {"fromForce_N", s.fromForce_N},
          {"toForce_N", s.toForce_N}};
}

ordered_json jsonOf(const TactileEvent& e) {
  ordered_json out = jsonOf(CurvePoint{e.point.displacement_mm, e.point.force_N});
  out["prominence_N"] = e.point.prominence_N;
  if (e.following) out["following"] = jsonOf(*e.following);
  if (e.snapRatio) out["snap_ratio"] = *e.snapRatio;
  if (e.jump) {
    out["jump_to_mm"] = e.jump->to_mm;
    out["jump_area_mJ"] = e.jumpArea_mJ;
  }
  return out;
}

ordered_json jsonOf(const StrokeMetrics& m, std::size_t knots) {
  ordered_json out;
  out["knots"] = knots;
  out["start_force_N"] = m.startForce_N;
  out["end_force_N"] = m.endForce_N;
  out["min_force_N"] = m.minForce_N;
  out["max_force_N"] = m.maxForce_N;
  out["work_mJ"] = m.work_mJ;
  out["bottom_out"] = jsonOf(CurvePoint{m.bottomOut.displacement_mm, m.bottomOut.force_N});
  out["bottom_out"]["wall"] = m.bottomOut.isSteep;
  out["tactile_points"] = ordered_json::array();
  for (const TactileEvent& e : m.tactile) out["tactile_points"].push_back(jsonOf(e));
  out["sections"] = ordered_json::array();
  for (const Section& s : m.sections) out["sections"].push_back(jsonOf(s));
  return out;
}

/// Key figures of the button; the names end in the unit.
ordered_json figuresJson(const ButtonState& state) {
  const KeyFigures figures = keyFiguresOf(state);
  ordered_json out = ordered_json::object();
  for (const KeyFigureName& name : keyFigureNames())
    if (const std::optional<double>& value = figures[name.figure]) out[std::string(name.key)] = *value;
  return out;
}

ordered_json jsonOf(const ButtonState& state) {
  const StateMetrics m = metricsOf(state);
  ordered_json out;
  out["name"] = state.name;
  out["travel_mm"] = m.travel_mm;
  if (m.operatingPoint) out["operating_point"] = jsonOf(*m.operatingPoint);
  if (m.resetPoint) out["reset_point"] = jsonOf(*m.resetPoint);
  if (m.hysteresisArea_mJ) out["hysteresis_mJ"] = *m.hysteresisArea_mJ;
  out["figures"] = figuresJson(state);
  out["press"] = jsonOf(m.press, state.graph.press().knots().size());
  if (m.release) out["release"] = jsonOf(*m.release, state.graph.release()->knots().size());
  out["damping_points"] = state.damping.size();
  if (state.speed_mm_per_s) out["speed_mm_per_s"] = *state.speed_mm_per_s;
  for (const SpeedGraph& other : state.otherSpeeds)
    out["other_speeds"].push_back(
        {{"speed_mm_per_s", other.speed_mm_per_s}, {"figures", figuresJson(ofOtherSpeed(state, other))}});
  return out;
}

ordered_json statusOk(const char* command, const std::string& path) {
  return {{"status", "ok"}, {"command", command}, {"file", path}};
}

std::string count(std::size_t number, const char* one, const char* many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

std::string textOf(const StrokeDistance& d, const char* name) {
  return format("%-8s mean %.4f %%  95th percentile %.4f %%  max %.4f %%\n", name, 100 * d.meanOfSpan,
                100 * d.p95OfSpan, 100 * d.maxOfSpan) +
         format("         mean %.4g mm, %.4g N  max %.4g mm, %.4g N\n", d.mean_mm, d.mean_N, d.max_mm,
                d.max_N);
}

ordered_json jsonOf(const StrokeDistance& d) {
  return {{"mean_of_span", d.meanOfSpan},
          {"p95_of_span", d.p95OfSpan},
          {"max_of_span", d.maxOfSpan},
          {"mean_mm", d.mean_mm},
          {"max_mm", d.max_mm},
          {"mean_N", d.mean_N},
          {"max_N", d.max_N}};
}

}  // namespace

Report showReport(const Button& button, const std::string& path) {
  Report report;
  report.text = button.name().empty() ? "Button\n" : "Button \"" + button.name() + "\"\n";
  if (button.selfLocking()) report.text += "Self-locking: its states alternate at each actuation\n";
  ordered_json json = statusOk("show", path);
  json["name"] = button.name();
  json["self_locking"] = button.selfLocking();
  json["states"] = ordered_json::array();
  for (const ButtonState& state : button.states()) {
    report.text += textOf(state);
    json["states"].push_back(jsonOf(state));
  }
  if (button.provenance()) {
    report.text += textOf(*button.provenance());
    json["source"] = {{"file", button.provenance()->sourceFile},
                      {"sha256", button.provenance()->sourceSha256},
                      {"page", button.provenance()->page},
                      {"graph", button.provenance()->graph},
                      {"confidence", button.provenance()->confidence}};
  }
  report.json = oneLine(json);
  return report;
}

Report checkReport(const Button& button, const std::vector<Warning>& warnings, const std::string& path) {
  Report report;
  report.text = path + ": valid, " + count(button.states().size(), "state", "states") + ", " +
                (warnings.empty() ? "nothing odd" : count(warnings.size(), "warning", "warnings")) + "\n";
  ordered_json json = statusOk("check", path);
  json["states"] = button.states().size();
  json["warnings"] = ordered_json::array();
  for (const Warning& warning : warnings) {
    report.text += "  warning [" + std::string(nameOf(warning.rule)) + "] " + warning.sentence() + "\n";
    json["warnings"].push_back({{"rule", nameOf(warning.rule)},
                                {"place", warning.place},
                                {"value", warning.value},
                                {"unit", warning.unit},
                                {"message", warning.sentence()}});
  }
  report.json = oneLine(json);
  return report;
}

Report convertReport(const Button& button, const std::string& inPath, const std::string& outPath,
                     const char* command) {
  std::size_t knots = 0;
  const auto add = [&](const ForceGraph& graph) {
    knots += graph.press().knots().size() + (graph.release() ? graph.release()->knots().size() : 0);
  };
  for (const ButtonState& state : button.states()) {
    add(state.graph);
    for (const SpeedGraph& other : state.otherSpeeds) add(other.graph);
  }
  Report report;
  report.text = inPath + " -> " + outPath + " (" + count(button.states().size(), "state", "states") + ", " +
                count(knots, "knot", "knots") + ")\n";
  ordered_json json = statusOk(command, inPath);
  json["output"] = outPath;
  json["states"] = button.states().size();
  json["knots"] = knots;
  report.json = oneLine(json);
  return report;
}

Report compareReport(const GraphDistance& distance, const std::string& first, const std::string& second) {
  Report report;
  report.text =
      first + " against " + second +
      format(": mean %.4f %% of span, max %.4f %% (spans %.6g mm, %.6g N)\n", 100 * distance.meanOfSpan,
             100 * distance.maxOfSpan, distance.span_mm, distance.span_N);
  ordered_json json = statusOk("compare", first);
  json["other"] = second;
  json["span_mm"] = distance.span_mm;
  json["span_N"] = distance.span_N;
  json["mean_of_span"] = distance.meanOfSpan;
  json["max_of_span"] = distance.maxOfSpan;
  if (distance.press) {
    report.text += textOf(*distance.press, "press");
    json["press"] = jsonOf(*distance.press);
  }
  if (distance.release) {
    report.text += textOf(*distance.release, "release");
    json["release"] = jsonOf(*distance.release);
  }
  report.json = oneLine(json);
  return report;
}

Report averageReport(const UnitSpread& spread, const std::vector<std::string>& units,
                     const std::string& out) {
  Report report;
  ordered_json json = statusOk("average", out);
  json["units"] = ordered_json::array();
  for (std::size_t i = 0; i < units.size(); ++i) {
    const bool outlier = std::ranges::find(spread.outliers, i) != spread.outliers.end();
    report.text += format("%.4f N from the median: ", spread.distance_N[i]) + units[i] +
                   (outlier ? "  OUTLIER: leave it out and average again, or measure it once more" : "") +
                   "\n";
    json["units"].push_back({{"file", units[i]}, {"distance_N", spread.distance_N[i]}, {"outlier", outlier}});
  }
  json["states"] = ordered_json::array();
  for (std::size_t i = 0; i < spread.states.size(); ++i) {
    const std::string& name = spread.mean.states()[i].name;
    if (!name.empty()) report.text += "state \"" + name + "\"\n";
    report.text += textOf(spread.states[i]);
    json["states"].push_back(jsonOf(spread.states[i], name));
  }
  report.json = oneLine(json);
  return report;
}

Report failureReport(const Failure& failure) {
  return {failure.sentence() + "\n", oneLine({{"status", "failed"},
                                              {"exit_code", failure.exitCode()},
                                              {"code", nameOf(failure.code)},
                                              {"subject", english(failure.subject.name)},
                                              {"place", english(failure.place)},
                                              {"problem", english(failure.problem)},
                                              {"remedy", commandLineWords(failure.remedies)},
                                              {"message", failure.sentence()}})};
}

}  // namespace detent
