// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/press_plan.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace detent::playback {

namespace {

constexpr double nearCeiling = 0.99;  // below this level the limiter had no effect

Burst burstOf(const EngineEvent& event, const HapticProgram& program) {
  const StateProgram& state = program.states[event.state];
  switch (event.kind) {
    case EventKind::grain:
      return program.grain;
    case EventKind::pressJump:
      return state.press.jumps[event.jump].burst;
    case EventKind::releaseJump:
      return state.release.jumps[event.jump].burst;
    case EventKind::bottomOut:
      return program.bottomOut;
    case EventKind::contactClosed:
    case EventKind::contactOpened:
    case EventKind::trigger:
      break;
  }
  return {};
}

/// The events that sound; the others are only marks for displays.
std::vector<PlannedBurst> sounding(const std::vector<EngineEvent>& events, const HapticProgram& program) {
  std::vector<PlannedBurst> bursts;
  for (const EngineEvent& event : events) {
    Burst burst = burstOf(event, program);
    burst.amplitude = event.amplitude;
    if (!(burst.amplitude > 0 && burst.duration_s > 0)) continue;
    bursts.push_back({event.kind, event.frame, burst, event.displacement_mm,
                      event.kind == EventKind::grain ? event.count : 0});
  }
  return bursts;
}

/// Frame of the strongest reading that the engine accepts, without invalid values and those out of range.
std::int64_t turnFrame(const PressTrace& trace, const HapticProgram& program,
                       const RenderSettings& settings) {
  ConditionerCounts counts;
  const double origin_s = std::fmin(0, trace.readings.front().time_s);
  const std::vector<EngineInput> inputs =
      conditionedInputs(trace, program, settings.sampleRate_Hz, origin_s, counts);
  const auto strongest = std::ranges::max_element(inputs, {}, &EngineInput::value);
  return strongest == inputs.end() ? 0 : std::llround(strongest->time_frames);
}

/// Samples without the limiter, rendered far below its ceiling.
Result<std::vector<float>> unlimited(const HapticProgram& program, const PressTrace& trace,
                                     const RenderSettings& settings) {
  constexpr double below = 1.0 / 64;  // a power of two, so that scaling causes no rounding
  const auto quiet = std::make_unique<HapticProgram>(program);
  quiet->gain *= below;
  Result<RenderedPress> rendered = renderPress(*quiet, trace, settings);
  if (!rendered) return rendered.failure();
  for (float& sample : rendered->samples) sample *= static_cast<float>(1 / below);
  return std::move(rendered->samples);
}

Failure nothingFelt(const ConditionerCounts& readings) {
  if (readings.rejected() > 0)
    return {FailureCode::wrongUsage, Subject::option("--press"), "",
            Message("this press produces no vibration: %1 of its %2 readings are out of range, out of order "
                    "or not numbers",
                    static_cast<std::size_t>(readings.rejected()),
                    static_cast<std::size_t>(readings.rejected() + readings.accepted)),
            Message("Correct these readings")};
  return {FailureCode::wrongUsage, Subject::option("--press"), "",
          Message("this press produces no vibration"),
          Message("Press harder or deeper, or give the button a tactile point")};
}

}  // namespace

Result<PressPlan> planPress(const Button& button, const HapticProgram& program, const PressTrace& trace,
                            const std::string& pressName, const RenderSettings& settings) {
  if (Result<Done> ok = checkRendering(trace, settings); !ok) return ok.failure();
  const double lasts_s = trace.readings.back().time_s - std::fmin(0, trace.readings.front().time_s);
  if (!(lasts_s <= longestExport_s))
    return Failure{FailureCode::wrongUsage, Subject::option("--press"), "",
                   Message("the press lasts %1 s; an export holds at most %2 s", lasts_s, longestExport_s),
                   Message("Give a shorter press")};
  Result<RenderedPress> rendered = renderPress(program, trace, settings);
  if (!rendered) return rendered.failure();
  PressPlan plan;
  plan.button = button.name();
  plan.press = pressName;
  plan.sampleRate_Hz = settings.sampleRate_Hz;
  plan.slopeUnderJump = program.slopeUnderJump;
  plan.turn_frame = turnFrame(trace, program, settings);
  plan.bursts = sounding(rendered->summary.events, program);
  plan.samples = std::move(rendered->samples);
  if (static_cast<double>(rendered->summary.peak) > nearCeiling * program.limiterCeiling) {
    Result<std::vector<float>> whole = unlimited(program, trace, settings);
    if (!whole) return whole.failure();
    if (*whole != plan.samples) plan.unlimited = *std::move(whole);
  }
  if (plan.bursts.empty()) return nothingFelt(rendered->summary.sensor);
  return plan;
}

}  // namespace detent::playback
