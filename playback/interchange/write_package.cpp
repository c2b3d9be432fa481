// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the force-triggered package: at which force which signal is to be played, for devices that measure
// force themselves. As JSON and as a C header.

#include <algorithm>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/metrics.h"
#include "model/units.h"
#include "model/version.h"
#include "playback/interchange/export_loss_json.h"
#include "playback/interchange/limiter_gains.h"
#include "playback/interchange/reduction.h"
#include "playback/measurement/exact_number.h"
#include "playback/realtime/biquad.h"
#include "playback/realtime/grain_density.h"
#include "playback/realtime/grain_voice.h"
#include "playback/realtime/sound_chain.h"
#include "playback/realtime/voice.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

/// An event on a stroke and its wave.
struct Trigger {
  const char* kind = "";  ///< "jump" or "bottom_out"
  bool release = false;
  double at_mm = 0, to_mm = 0, at_N = 0;
  double rearm_mm = 0, rearm_N = 0;
  Burst burst;
};

/// A part of a stroke with grains; `level` is a factor on the amplitude of each.
struct SlopePiece {
  double from_mm = 0, to_mm = 0;  ///< places of its first and last grain
  double level = 1;
};

struct StatePackage {
  std::string name;
  std::vector<SlopePiece> pressSlopes, releaseSlopes;
  std::vector<Trigger> triggers;  ///< in the order travelled, press first
  std::optional<double> press_N, press_mm, release_N, release_mm;
  StateMetrics metrics;
  std::optional<double> operating_mm, operating_N, reset_mm, reset_N;
  double settled_N = 0;  ///< force at which a release reaches StateProgram::rest_mm
};

constexpr double gainTolerance = 1e-4;  // share of full scale

double inGrams(double force_N) { return force_N / newtonsPer(ForceUnit::gramForce); }

/// Force interpolated between two points of a table, of which the second is deeper.
double forceBetween(const TablePoint& a, const TablePoint& b, double displacement_mm) {
  const double share = (displacement_mm - a.displacement_mm) / (b.displacement_mm - a.displacement_mm);
  return a.force_N + (b.force_N - a.force_N) * share;
}

/// The force at which a press first reaches a displacement: the largest up to there, not the force at that
/// displacement. At a vertical rise, its lower end.
double pressedAt_N(const StateProgram& state, double displacement_mm) {
  const StrokeTable& table = state.press;
  if (table.pointCount == 0) return 0;
  double strongest_N = table.points[0].force_N;
  for (std::uint32_t i = 1; i < table.pointCount; ++i) {
    const TablePoint &a = table.points[i - 1], &b = table.points[i];
    if (displacement_mm <= a.displacement_mm) break;
    if (displacement_mm <= b.displacement_mm)
      return std::max(strongest_N, forceBetween(a, b, displacement_mm));
    strongest_N = b.displacement_mm > state.start_mm ? std::max(strongest_N, b.force_N) : b.force_N;
  }
  return strongest_N;
}

/// The same for a release, which starts at the end: the smallest force down to there; at a vertical rise, its
/// upper end.
double releasedAt_N(const StateProgram& state, double displacement_mm) {
  const StrokeTable& table = state.release;
  if (table.pointCount == 0) return 0;
  double least_N = table.points[table.pointCount - 1].force_N;
  for (std::uint32_t i = table.pointCount - 1; i > 0; --i) {
    const TablePoint &a = table.points[i - 1], &b = table.points[i];
    if (displacement_mm >= b.displacement_mm) break;
    if (displacement_mm >= a.displacement_mm) return std::min(least_N, forceBetween(a, b, displacement_mm));
    least_N = std::min(least_N, a.force_N);
  }
  return least_N;
}

/// Triggers of a stroke. A trigger is re-armed on the other stroke: a press's by a release, and never above
/// its own force.
std::vector<Trigger> triggersOf(const StateProgram& state, bool release) {
  std::vector<Trigger> triggers;
  const StrokeTable& table = release ? state.release : state.press;
  for (std::uint32_t i = 0; i < table.jumpCount; ++i) {
    const JumpEntry& jump = table.jumps[i];
    const double at_N = release ? releasedAt_N(state, jump.from_mm) : pressedAt_N(state, jump.from_mm);
    const double back_N = release ? std::max(at_N, pressedAt_N(state, jump.rearm_mm))
                                  : std::min(at_N, releasedAt_N(state, jump.rearm_mm));
    triggers.push_back({"jump", release, jump.from_mm, jump.to_mm, at_N, jump.rearm_mm, back_N, jump.burst});
  }
  return triggers;
}

std::vector<SlopePiece> slopesOf(const StrokeTable& table, const HapticProgram& program) {
  std::vector<SlopePiece> slopes;
  if (!(program.grainsPerMm > 0)) return slopes;
  const auto place_mm = [&](std::int64_t grain) {
    return program.gridOrigin_mm + static_cast<double>(grain) / program.grainsPerMm;
  };
  for (std::uint32_t i = 0; i < table.slopeCount; ++i) {
    const GrainRange& slope = table.slopes[i];
    if (slope.first > slope.last) continue;
    slopes.push_back({place_mm(slope.first), place_mm(slope.last), table.slopeLevel * slope.level});
  }
  return slopes;
}

StatePackage packageOf(const ButtonState& state, const StateProgram& program, const HapticProgram& whole) {
  StatePackage package;
  package.name = state.name;
  package.pressSlopes = slopesOf(program.press, whole);
  package.releaseSlopes = slopesOf(program.release, whole);
  package.metrics = metricsOf(state);
  package.triggers = triggersOf(program, false);
  if (program.hasBottomOut) {
    Burst bottom = whole.bottomOut;
    bottom.amplitude *= program.bottomOutLevel;
    const double at_N = pressedAt_N(program, program.bottomOut_mm);
    package.triggers.push_back({"bottom_out", false, program.bottomOut_mm, program.bottomOut_mm, at_N,
                                program.bottomOutRearm_mm,
                                std::min(at_N, releasedAt_N(program, program.bottomOutRearm_mm)), bottom});
  }
  for (const Trigger& trigger : triggersOf(program, true)) package.triggers.push_back(trigger);
  if (program.hasOperatingPoint) {
    package.operating_mm = program.operating_mm;
    package.operating_N = pressedAt_N(program, program.operating_mm);
  }
  if (program.hasResetPoint) {
    package.reset_mm = program.reset_mm;
    package.reset_N = releasedAt_N(program, program.reset_mm);
  }
  package.settled_N = releasedAt_N(program, program.rest_mm);
  // The device switches at an event that is felt: the first jump; without one at the operating point, else at
  // the bottom-out.
  for (const Trigger& trigger : package.triggers) {
    auto& at_N = trigger.release ? package.release_N : package.press_N;
    auto& at_mm = trigger.release ? package.release_mm : package.press_mm;
    const bool clicks = std::string_view(trigger.kind) == "jump";
    if (at_N || !clicks) continue;
    at_N = trigger.at_N;
    at_mm = trigger.at_mm;
  }
  if (!package.press_N) {
    package.press_N = package.operating_N;
    package.press_mm = package.operating_mm;
  }
  if (!package.press_N && program.hasBottomOut) {
    package.press_N = pressedAt_N(program, program.bottomOut_mm);
    package.press_mm = program.bottomOut_mm;
  }
  if (!package.release_N) {
    package.release_N = package.reset_N;
    package.release_mm = package.reset_mm;
  }
  return package;
}

std::vector<StatePackage> statesOf(const ExportSource& source) {
  std::vector<StatePackage> states;
  for (std::size_t i = 0; i < source.program.stateCount; ++i)
    states.push_back(packageOf(source.button.states()[i], source.program.states[i], source.program));
  return states;
}

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json jsonOf(const Burst& burst) {
  const bool falling = burst.envelope == Envelope::falling;
  const double lasts_ms = 1000 * burst.duration_s;
  return {{"frequency_Hz", burst.frequency_Hz}, {"duration_ms", lasts_ms},
          {"amplitude", burst.amplitude},       {"envelope", falling ? "falling" : "rising"},
          {"rise_ms", falling ? 0 : lasts_ms},  {"fall_ms", falling ? lasts_ms : 0}};
}

Json jsonOf(const Trigger& trigger) {
  return {{"stroke", trigger.release ? "release" : "press"},
          {"kind", trigger.kind},
          {"force_N", trigger.at_N},
          {"force_g", inGrams(trigger.at_N)},
          {"displacement_mm", trigger.at_mm},
          {"to_displacement_mm", trigger.to_mm},
          {"rearm_displacement_mm", trigger.rearm_mm},
          {"rearm_force_N", trigger.rearm_N},
          {"quietens_slope", trigger.burst.quietensSlope},
          {"wave", jsonOf(trigger.burst)}};
}

Json jsonOf(const std::vector<SlopePiece>& slopes) {
  Json list = Json::array();
  for (const SlopePiece& slope : slopes)
    list.push_back({{"from_mm", slope.from_mm}, {"to_mm", slope.to_mm}, {"level", slope.level}});
  return list;
}

Json threshold(const std::optional<double>& force_N, const std::optional<double>& displacement_mm) {
  if (!force_N) return nullptr;
  return {
      {"force_N", *force_N}, {"force_g", inGrams(*force_N)}, {"displacement_mm", orNull(displacement_mm)}};
}

/// The key figures under the names used in data sheets of tact switches.
Json tactFigures(const StatePackage& state) {
  Json figures{{"Fa_N", nullptr},
               {"Fra_N", nullptr},
               {"click_ratio_percent", nullptr},
               {"travel_to_make_mm", nullptr}};
  const std::vector<TactileEvent>& events = state.metrics.press.tactile;
  if (!events.empty()) {
    figures["Fa_N"] = events.front().point.force_N;
    if (events.front().snapRatio) figures["click_ratio_percent"] = 100 * *events.front().snapRatio;
  } else if (state.operating_N) {
    figures["Fa_N"] = *state.operating_N;
  }
  figures["Fra_N"] = orNull(state.release_N);
  figures["travel_to_make_mm"] = orNull(state.operating_mm);
  return figures;
}

Json pointsOf(const StrokeTable& table) {
  Json points = Json::array();
  for (std::uint32_t i = 0; i < table.pointCount; ++i)
    points.push_back({table.points[i].displacement_mm, table.points[i].force_N});
  return points;
}

Json coefficients(const BiquadCoefficients& c) {
  return {{"b0", c.b0}, {"b1", c.b1}, {"b2", c.b2}, {"a1", c.a1}, {"a2", c.a2}};
}

/// The filters after the bursts, so that a reader can reproduce the engine's samples.
Json chainOf(const HapticProgram& program, double sampleRate_Hz) {
  Json equalizer = Json::array();
  for (std::uint32_t i = 0; i < program.equalizerBandCount; ++i) {
    const EqualizerBand& band = program.equalizer[i];
    equalizer.push_back(
        {{"frequency_Hz", band.frequency_Hz},
         {"q", band.q},
         {"gain_dB", band.gain_dB},
         {"coefficients", coefficients(peaking(sampleRate_Hz, band.frequency_Hz, band.q, band.gain_dB))}});
  }
  const LowPass& low = program.lowPass;
  const char* acts = low.placement == LowPassPlacement::none        ? "none"
                     : low.placement == LowPassPlacement::slopeOnly ? "grains"
                                                                    : "all";
  return {{"sample_rate_Hz", sampleRate_Hz},
          {"grain_low_pass",
           {{"acts_on", acts},
            {"cutoff_Hz", low.cutoff_Hz},
            {"order", low.order},
            {"coefficients", coefficients(lowPass(sampleRate_Hz, low.cutoff_Hz, low.order))}}},
          {"grain_high_pass",
           {{"cutoff_Hz", program.highPass_Hz},
            {"coefficients", coefficients(highPass(sampleRate_Hz, program.highPass_Hz))}}},
          {"grain_carrier", program.grainCarrier == GrainCarrier::running ? "running" : "retriggered"},
          {"slope_under_jump", {{"level", program.slopeUnderJump}, {"turn_ms", 1000 * slopeTurn_s}}},
          {"equalizer", equalizer},
          {"gain", program.gain},
          {"limiter_ceiling", program.limiterCeiling}};
}

const char* eventName(EventKind kind) {
  return kind == EventKind::grain       ? "grain"
         : kind == EventKind::pressJump ? "press_jump"
         : kind == EventKind::bottomOut ? "bottom_out"
                                        : "release_jump";
}

Json examplePress(const PressPlan& plan) {
  Json events = Json::array();
  for (const PlannedBurst& planned : plan.bursts)
    events.push_back({{"sample", planned.frame},
                      {"time_s", plan.time_s(planned.frame)},
                      {"kind", eventName(planned.kind)},
                      {"displacement_mm", planned.displacement_mm},
                      {"quietens_slope", planned.burst.quietensSlope},
                      {"wave", jsonOf(planned.burst)}});
  Json gains = Json::array();
  if (!plan.unlimited.empty())
    for (const GainPoint& point : limiterGains(plan.unlimited, plan.samples, gainTolerance))
      gains.push_back({point.frame, point.gain});
  return {{"press", plan.press},
          {"samples", plan.samples.size()},
          {"events", events},
          {"limiter_gain", {{"columns", {"sample", "gain"}}, {"points", gains}}}};
}

std::string packageText(const ExportSource& source, const ExportLoss& loss) {
  Json states = Json::array();
  const std::vector<StatePackage> packages = statesOf(source);
  for (std::size_t i = 0; i < packages.size(); ++i) {
    const StatePackage& state = packages[i];
    const StateProgram& program = source.program.states[i];
    Json triggers = Json::array();
    for (const Trigger& trigger : state.triggers) triggers.push_back(jsonOf(trigger));
    states.push_back(
        {{"name", state.name},
         {"press_threshold", threshold(state.press_N, state.press_mm)},
         {"release_threshold", threshold(state.release_N, state.release_mm)},
         {"operating_point", threshold(state.operating_N, state.operating_mm)},
         {"reset_point", threshold(state.reset_N, state.reset_mm)},
         {"start_displacement_mm", program.start_mm},
         {"settled", threshold(state.settled_N, program.rest_mm)},
         {"tact_switch_figures", tactFigures(state)},
         {"triggers", triggers},
         {"slopes", {{"press", jsonOf(state.pressSlopes)}, {"release", jsonOf(state.releaseSlopes)}}},
         {"curve",
          {{"columns", {"displacement_mm", "force_N"}},
           {"press", pointsOf(program.press)},
           {"release", pointsOf(program.release)}}}});
  }
  const Json file{
      {"format", "detent-force-triggered-package"},
      {"version", 1},
      {"made_by", std::string("Detent ") + version()},
      {"button", source.plan.button},
      {"feel", feels.word(source.plan.feel)},
      {"self_locking", source.program.stateCount > 1},
      {"states", states},
      {"grains",
       {{"per_mm", source.program.grainsPerMm},
        {"origin_mm", source.program.gridOrigin_mm},
        {"wave", jsonOf(source.program.grain)},
        {"loudest_density_per_s", source.program.loudestDensity_per_s},
        {"level_by_density", levelByDensity}}},
      {"strokes",
       {{"hysteresis_N", source.program.hysteresis_N}, {"rest_force_N", source.program.restForce_N}}},
      {"turns",
       {{"longest_bottom_out_wait_ms", 1000 * source.program.longestBottomOutWait_s},
        {"burst_spacing_ms", 1000 * source.program.burstSpacing_s}}},
      {"chain", chainOf(source.program, source.plan.sampleRate_Hz)},
      {"example_press", examplePress(source.plan)},
      {"loss", jsonOf(loss)}};
  return jsonText(file, 1) + "\n";
}

// ---- the package as a C header for firmware

Burst heard(Burst burst, const HapticProgram& program) {
  burst.amplitude *= program.gain;
  return burst;
}

/// A grain with the amplitude that remains of a long one after the filters.
Burst heardGrain(const Burst& played, const ExportSource& source) {
  Burst grain = heard(played, source.program);
  const double rate_Hz = source.plan.sampleRate_Hz;
  const LowPass& low = source.program.lowPass;
  if (low.placement != LowPassPlacement::none)
    grain.amplitude *= magnitude(lowPass(rate_Hz, low.cutoff_Hz, low.order), rate_Hz, grain.frequency_Hz);
  grain.amplitude *= magnitude(highPass(rate_Hz, source.program.highPass_Hz), rate_Hz, grain.frequency_Hz);
  return grain;
}

std::string cBurst(const Burst& burst) {
  const bool falling = burst.envelope == Envelope::falling;
  const double lasts_ms = 1000 * burst.duration_s;
  return "{" + cFloat(burst.frequency_Hz) + ", " + cFloat(lasts_ms) + ", " + cFloat(burst.amplitude) + ", " +
         cFloat(falling ? 0 : lasts_ms) + ", " + cFloat(falling ? lasts_ms : 0) + "}";
}

std::string cTable(const char* name, std::size_t state, const StrokeTable& table) {
  if (table.pointCount == 0) return {};
  const auto column = [&](const char* what, auto member) {
    std::string text = "static const float detent_" + std::string(name) + "_" + what + "_" +
                       std::to_string(state) + "[] DETENT_FLASH = {";
    std::vector<double> numbers;
    for (std::uint32_t i = 0; i < table.pointCount; ++i) numbers.push_back(table.points[i].*member);
    return text + rows(numbers, cFloat) + "};\n";
  };
  return column("mm", &TablePoint::displacement_mm) + column("N", &TablePoint::force_N);
}

std::string cTriggers(std::size_t index, const StatePackage& state, const HapticProgram& program) {
  std::string text =
      "static const detent_trigger detent_triggers_" + std::to_string(index) + "[] DETENT_FLASH = {\n";
  for (const Trigger& t : state.triggers)
    text += "  {" + std::string(t.release ? "1" : "0") + ", " +
            (std::string_view(t.kind) == "jump" ? "0" : "1") + ", " + cFloat(t.at_N) + ", " +
            cFloat(t.rearm_N) + ", " + cFloat(t.at_mm) + ", " + cFloat(t.rearm_mm) + ", " +
            cBurst(heard(t.burst, program)) + "},\n";
  // C has no empty arrays, so a trigger is written that no force reaches.
  if (state.triggers.empty())
    text += "  {0, 0, 1.0e30f, 0.0f, 1.0e30f, 0.0f, {0.0f, 0.0f, 0.0f, 0.0f, 0.0f}},\n";
  return text + "};\n";
}

std::string cSlopes(const char* name, std::size_t state, const std::vector<SlopePiece>& slopes) {
  if (slopes.empty()) return {};
  std::string text = "static const detent_slope detent_" + std::string(name) + "_slopes_" +
                     std::to_string(state) + "[] DETENT_FLASH = {\n";
  for (const SlopePiece& slope : slopes)
    text += "  {" + cFloat(slope.from_mm) + ", " + cFloat(slope.to_mm) + ", " + cFloat(slope.level) + "},\n";
  return text + "};\n";
}

std::string cState(std::size_t index, const StatePackage& state, const StateProgram& program) {
  const std::string n = std::to_string(index);
  const auto number = [](const std::optional<double>& value) { return cFloat(value.value_or(-1)); };
  const auto column = [&](const char* name, const StrokeTable& table, const char* what) {
    return table.pointCount == 0 ? std::string("0") : "detent_" + std::string(name) + "_" + what + "_" + n;
  };
  const auto slopes = [&](const char* name, const std::vector<SlopePiece>& pieces) {
    return (pieces.empty() ? "0" : "detent_" + std::string(name) + "_slopes_" + n) + ", " +
           std::to_string(pieces.size()) + "u, ";
  };
  const auto triggers = "detent_triggers_" + n + ", " + std::to_string(state.triggers.size()) + "u";
  return "  {detent_name_" + n + ", " + number(state.press_N) + ", " + number(state.release_N) + ", " +
         number(state.operating_N) + ", " + number(state.reset_N) + ", " + cFloat(state.settled_N) + ", " +
         number(state.operating_mm) + ", " + number(state.reset_mm) + ", " + cFloat(program.start_mm) + ", " +
         cFloat(program.rest_mm) + ", " + triggers + "\n   DETENT_CURVES(" +
         slopes("press", state.pressSlopes) + slopes("release", state.releaseSlopes) +
         column("press", program.press, "mm") + ", " + column("press", program.press, "N") + ", " +
         std::to_string(program.press.pointCount) + "u, " + column("release", program.release, "mm") + ", " +
         column("release", program.release, "N") + ", " + std::to_string(program.release.pointCount) +
         "u)},\n";
}

constexpr const char* cTypes = R"(#ifndef DETENT_BUTTON_H
#define DETENT_BUTTON_H

/* Arrays of constants stay in flash, where an AVR reaches them by these two alone: a number, and a whole structure. What a
   structure points to is in flash as well. Single numbers and detent_grain are read as they are. */
#if defined(__AVR__)
#include <avr/pgmspace.h>
#define DETENT_FLASH PROGMEM
#define DETENT_NUMBER(place) pgm_read_float(&(place))
#define DETENT_COPY(to, place) memcpy_P(&(to), &(place), sizeof(to))
#else
#define DETENT_FLASH
#define DETENT_NUMBER(place) (place)
#define DETENT_COPY(to, place) ((to) = (place))
#endif

/* Define DETENT_TRIGGERS_ONLY before this file is included to leave the curves and slopes out: they are most of it. */
#if defined(DETENT_TRIGGERS_ONLY)
#define DETENT_CURVES(...)
#else
#define DETENT_CURVES(...) , __VA_ARGS__
#endif

/* A sine of frequency_Hz for duration_ms whose amplitude (share of full scale) rises over rise_ms and falls over fall_ms. */
typedef struct { float frequency_Hz, duration_ms, amplitude, rise_ms, fall_ms; } detent_wave;

/* Play `wave` when the force passes force_N: upwards on a press (release == 0), downwards on a release; again only after it
   has been back at rearm_N, and what a release plays not before it has been there. Who follows the curves plays it instead
   when a stroke leaves displacement_mm (a jump) or arrives there (a bottom-out), and again only after it has been back at
   rearm_displacement_mm. kind: 0 jump, 1 bottom-out. */
typedef struct {
  unsigned char release, kind;
  float force_N, rearm_N, displacement_mm, rearm_displacement_mm;
  detent_wave wave;
} detent_trigger;

/* A piece of a slope: grains from from_mm to to_mm, both included, each as strong as level says of detent_grain. */
typedef struct { float from_mm, to_mm, level; } detent_slope;

/* Points that a state does not have are -1. Curves and slopes by rising displacement, triggers in the order met.
   A press follows its curve from start_mm to where the curve bears the force, a release to where it pushes back no more.
   The contact closes when a press comes to operating_mm, opens when a release comes to reset_mm or ends.
   A release ends at start_mm; one that follows an actuation (a press that came to operating_mm or, where that is -1, left
   start_mm) at rest_mm, where the force is settled_N. Then the next of several states answers, armed as at the start; after the last
   comes the first. The next press begins at start_mm. */
typedef struct {
  const char* name;
  float press_threshold_N, release_threshold_N, operating_N, reset_N, settled_N;
  float operating_mm, reset_mm, start_mm, rest_mm;
  const detent_trigger* triggers;
  unsigned trigger_count;
#if !defined(DETENT_TRIGGERS_ONLY)
  const detent_slope* press_slopes;
  unsigned press_slope_count;
  const detent_slope* release_slopes;
  unsigned release_slope_count;
  const float *press_mm, *press_N;
  unsigned press_points;
  const float *release_mm, *release_N;
  unsigned release_points;
#endif
} detent_state;

)";

/// Relative levels of grains and jumps, and which event waits for which.
std::string cOrder(const HapticProgram& program) {
  const auto constant = [](const char* name, double value) {
    return std::string("static const float detent_") + name + " = " + cFloat(value) + ";\n";
  };
  return "/* Grains that come n times a second are (n / loudest)^detent_grain_level_power as strong, n at "
         "least "
         "1000 / duration_ms and at\n   most loudest; 0: all alike. Grains that begin while a jump sounds "
         "are "
         "quieter by detent_slope_under_jump. */\n" +
         constant("loudest_grains_per_s", program.loudestDensity_per_s) +
         constant("grain_level_power", levelByDensity) +
         constant("slope_under_jump", program.slopeUnderJump) +
         "/* A bottom-out lets the jump before it end, and waits for it at most "
         "detent_longest_bottom_out_wait_ms. "
         "No jump or bottom-out\n   begins within detent_burst_spacing_ms of the one before. */\n" +
         constant("longest_bottom_out_wait_ms", 1000 * program.longestBottomOutWait_s) +
         constant("burst_spacing_ms", 1000 * program.burstSpacing_s) +
         "/* A stroke turns when the force has come back by detent_hysteresis_N; at detent_rest_N and below "
         "nobody presses. */\n" +
         constant("hysteresis_N", program.hysteresis_N) + constant("rest_N", program.restForce_N);
}

std::string headerText(const ExportSource& source, const ExportLoss& loss) {
  const std::vector<StatePackage> states = statesOf(source);
  std::string tables, list;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const StateProgram& program = source.program.states[i];
    tables += "static const char detent_name_" + std::to_string(i) +
              "[] DETENT_FLASH = " + cString(states[i].name) + ";\n" +
              cTriggers(i, states[i], source.program) + "#if !defined(DETENT_TRIGGERS_ONLY)\n" +
              cSlopes("press", i, states[i].pressSlopes) + cSlopes("release", i, states[i].releaseSlopes) +
              cTable("press", i, program.press) + cTable("release", i, program.release) + "#endif\n";
    list += cState(i, states[i], program);
  }
  return cComment(headLines(source, loss)) + cTypes + tables +
         "\nstatic const detent_state detent_states[] DETENT_FLASH = {\n" + list +
         "};\nstatic const unsigned detent_state_count = " + std::to_string(states.size()) +
         "u;\n\n/* The slope: a grain where a press comes to detent_grain_origin_mm + a multiple of "
         "1/detent_grains_per_mm, and where a release\n   leaves one. It takes the place of the last" +
         (source.program.grainCarrier == GrainCarrier::running
              ? ", whose sine runs on; after silence the sine begins anew"
              : "; its sine begins anew") +
         ". */\nstatic const float detent_grain_origin_mm = " + cFloat(source.program.gridOrigin_mm) +
         ";\nstatic const float detent_grains_per_mm = " + cFloat(source.program.grainsPerMm) +
         ";\nstatic const detent_wave detent_grain = " + cBurst(heardGrain(source.program.grain, source)) +
         ";\n" + cOrder(source.program) + "\n#endif\n";
}

/// The press as a small device plays the header: without filters, grains with their amplitude after the
/// filters, and each new grain replacing the previous one.
std::vector<double> unfiltered(const ExportSource& source) {
  const PressPlan& plan = source.plan;
  std::vector<double> samples(plan.samples.size(), 0);
  GrainVoice grain;
  std::size_t at = 0;
  std::int64_t quietUntil = 0;
  const auto play = [&](std::size_t until) {
    if (until > at) grain.addTo(samples.data() + at, until - at);
    at = std::max(at, until);
  };
  for (const PlannedBurst& planned : plan.bursts) {
    const auto frame =
        std::min(static_cast<std::size_t>(std::max<std::int64_t>(0, planned.frame)), samples.size());
    if (planned.kind == EventKind::grain) {
      play(frame);
      Burst played = heardGrain(planned.burst, source);
      if (planned.frame < quietUntil) played.amplitude *= source.program.slopeUnderJump;
      grain.start(played, source.program.grainCarrier, plan.sampleRate_Hz);
      continue;
    }
    if (planned.burst.quietensSlope)
      quietUntil = planned.frame + std::llround(planned.burst.duration_s * plan.sampleRate_Hz);
    Voice voice;
    voice.start(heard(planned.burst, source.program), plan.sampleRate_Hz);
    voice.addTo(samples.data() + frame, samples.size() - frame);
  }
  play(samples.size());
  return samples;
}

}  // namespace

Reduction packageOf(const ExportSource& source) {
  Reduction reduction;
  reduction.played.emplace_back(source.plan.samples.begin(), source.plan.samples.end());
  if (!source.plan.unlimited.empty())
    reduction.loss.dropped.emplace_back(
        "how the limiter turns other presses down (the example's gain is in the file)");
  reduction.write = [source](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", packageText(source, loss)}};
  };
  return reduction;
}

Reduction cHeaderOf(const ExportSource& source) {
  Reduction reduction;
  reduction.played = {unfiltered(source)};
  reduction.loss.dropped = {"the grains' filters, equalizer and limiter (the package has them)"};
  reduction.write = [source](const ExportLoss& loss) {
    return std::vector<ExportedFile>{{"", "", headerText(source, loss)}};
  };
  return reduction;
}

}  // namespace detent::playback
