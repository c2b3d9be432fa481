// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/identify_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/file/button_file.h"
#include "model/file/text_file.h"
#include "playback/identification/identify.h"
#include "playback/program/json_output.h"
#include "playback/program/number_option.h"
#include "playback/program/xy_plot.h"

namespace detent::playback {

namespace {

struct IdentifyArguments {
  std::string record, outputFile, plotFile;
  IdentifySettings settings;
  bool json = false;
};

void addIdentifyOptions(CLI::App& app, IdentifyArguments& a) {
  app.add_option("RECORD", a.record, "CSV: time_s,displacement_mm,force_N")->required();
  app.add_option("-o,--output", a.outputFile,
                 "*.button.json to write: c + k(x) x, and b(x) if it was identified");
  app.add_option("--plot", a.plotFile,
                 "Haptic profile as SVG: force over position and velocity, velocity over position");
  app.add_option("--knots", a.settings.knots, "Knots of k and b over the travel; 1: constants")
      ->capture_default_str()
      ->check(numberWithin(1, 32));
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

const char* codeOf(DampingDoubt doubt) {
  switch (doubt) {
    case DampingDoubt::none:
      return "none";
    case DampingDoubt::constantSpeed:
      return "constant_speed";
    case DampingDoubt::notCertain:
      return "not_certain";
  }
  return "";
}

std::string sentenceOf(DampingDoubt doubt, double figure) {
  char text[200];
  switch (doubt) {
    case DampingDoubt::none:
      return "";
    case DampingDoubt::constantSpeed:
      std::snprintf(text, sizeof text,
                    "speed varies by %.1f %% only: damping and friction cannot be told apart; record presses "
                    "of different speeds",
                    100 * figure);
      return text;
    case DampingDoubt::notCertain:
      std::snprintf(text, sizeof text,
                    "its standard error is %.0f %% of it; record faster presses, or several in one record",
                    100 * figure);
      return text;
  }
  return "";
}

Json valueOf(const std::vector<Estimate>& estimates, double Estimate::*part) {
  if (estimates.empty()) return nullptr;
  if (estimates.size() == 1) return estimates.front().*part;
  Json list = Json::array();
  for (const Estimate& e : estimates) list.push_back(e.*part);
  return list;
}

/// Change of b if the force is recorded 1 ms later than its displacement: the spring's change within that
/// time resembles damping.
double lagEffect_Ns_per_mm(const Identification& f) {
  constexpr double lag_s = 0.001;
  double stiffest_N_per_mm = 0;
  for (const Estimate& k : f.k_N_per_mm) stiffest_N_per_mm = std::max(stiffest_N_per_mm, std::abs(k.value));
  return stiffest_N_per_mm * lag_s;
}

Json jsonOf(const IdentifyArguments& a, const Identification& f) {
  Json json{{"status", "ok"},
            {"record", a.record},
            {"k_N_per_mm", valueOf(f.k_N_per_mm, &Estimate::value)},
            {"sigma_k_N_per_mm", valueOf(f.k_N_per_mm, &Estimate::sigma)},
            {"b_Ns_per_mm", valueOf(f.b_Ns_per_mm, &Estimate::value)},
            {"sigma_b_Ns_per_mm", valueOf(f.b_Ns_per_mm, &Estimate::sigma)}};
  if (f.b_Ns_per_mm.empty()) {
    json["b_reason"] = sentenceOf(f.doubt, f.doubtFigure);
    json["b_reason_code"] = codeOf(f.doubt);
  }
  json["friction_N"] = f.friction_N ? Json(f.friction_N->value) : Json(nullptr);
  json["sigma_friction_N"] = f.friction_N ? Json(f.friction_N->sigma) : Json(nullptr);
  json["mass_kg"] = f.mass_kg ? Json(f.mass_kg->value) : Json(nullptr);
  json["sigma_mass_kg"] = f.mass_kg ? Json(f.mass_kg->sigma) : Json(nullptr);
  json["offset_N"] = f.offset_N.value;
  json["sigma_offset_N"] = f.offset_N.sigma;
  json["knots_mm"] = f.knots_mm;
  json["b_per_ms_of_lag_Ns_per_mm"] = -lagEffect_Ns_per_mm(f);
  json["condition"] = f.condition;
  json["residual_N"] = f.residual_N;
  json["step_mm"] = f.step_mm;
  json["samples"] = f.samples;
  return json;
}

void printIdentified(const Identification& f) {
  std::fprintf(stderr, "F = c + k x + b v%s%s, %zu samples, residual %.4f N, condition %.3g\n",
               f.friction_N ? " + f sgn(v)" : "", f.mass_kg ? " + m a" : "", f.samples, f.residual_N,
               f.condition);
  std::fprintf(stderr, "c = %.4f +- %.4f N\n", f.offset_N.value, f.offset_N.sigma);
  for (std::size_t i = 0; i < f.knots_mm.size(); ++i) {
    if (f.knots_mm.size() > 1) std::fprintf(stderr, "at %.3f mm: ", f.knots_mm[i]);
    std::fprintf(stderr, "k = %.5g +- %.2g N/mm", f.k_N_per_mm[i].value, f.k_N_per_mm[i].sigma);
    if (!f.b_Ns_per_mm.empty())
      std::fprintf(stderr, ", b = %.5g +- %.2g N·s/mm", f.b_Ns_per_mm[i].value, f.b_Ns_per_mm[i].sigma);
    std::fprintf(stderr, "\n");
  }
  if (f.friction_N) {
    std::fprintf(stderr, "f = %.4f +- %.4f N of friction, which no button file holds\n", f.friction_N->value,
                 f.friction_N->sigma);
  }
  if (f.mass_kg) std::fprintf(stderr, "m = %.5g +- %.2g kg\n", f.mass_kg->value, f.mass_kg->sigma);
  if (!f.b_Ns_per_mm.empty())
    std::fprintf(stderr,
                 "b holds for forces and places of one moment: a force 1 ms late takes %.2g N·s/mm off it\n",
                 lagEffect_Ns_per_mm(f));
  if (f.b_Ns_per_mm.empty())
    std::fprintf(stderr, "b is not named: %s.\n", sentenceOf(f.doubt, f.doubtFigure).c_str());
}

std::string profileSvg(const ForceRecord& r, const Identification& f) {
  constexpr const char* blue = "#1f5fa8";
  PlotLine force{"", blue, {}}, forceVelocity{"", blue, {}}, velocity{"", blue, {}};
  for (std::size_t i = 0; i < r.time_s.size(); ++i) {
    force.points.push_back({r.displacement_mm[i], r.force_N[i]});
    forceVelocity.points.push_back({f.velocity_mm_per_s[i], r.force_N[i]});
    velocity.points.push_back({r.displacement_mm[i], f.velocity_mm_per_s[i]});
  }
  return svgOf({{"Force over position", "displacement [mm]", "force [N]", {}, {force}},
                {"Force over velocity", "velocity [mm/s]", "force [N]", {}, {forceVelocity}},
                {"Velocity over position", "displacement [mm]", "velocity [mm/s]", {}, {velocity}}});
}

int runIdentify(const IdentifyArguments& a) {
  Result<ForceRecord> record = readForceRecord(a.record);
  if (!record) return fail(record.failure());
  Result<Identification> found = identify(*record, a.settings);
  if (!found) {
    Failure failure = found.failure();
    if (failure.code == FailureCode::unreadableInput) failure.subject = a.record;
    return fail(failure);
  }
  if (!a.plotFile.empty()) {
    if (Result<Done> w = writeTextFileAtomically(a.plotFile, profileSvg(*record, *found)); !w)
      return fail(w.failure());
  }
  if (!a.outputFile.empty()) {
    const double travel_mm =
        *std::max_element(record->displacement_mm.begin(), record->displacement_mm.end());
    Result<Button> button =
        buttonFrom(*found, "Identified from " + a.record.substr(a.record.find_last_of('/') + 1), travel_mm);
    if (!button) return fail(button.failure());
    if (Result<Done> w = writeButtonFile(a.outputFile, *button); !w) return fail(w.failure());
  }
  printIdentified(*found);
  if (a.json) print(jsonOf(a, *found));
  return 0;
}

}  // namespace

void addIdentifyCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand(
      "identify", "Identify stiffness, damping and mass from a recorded press. Units: mm, N, s");
  const auto arguments = std::make_shared<IdentifyArguments>();
  addIdentifyOptions(*app, *arguments);
  app->callback(
      [&chosen, arguments] { chosen = [arguments](const Cancelled&) { return runIdentify(*arguments); }; });
}

}  // namespace detent::playback
