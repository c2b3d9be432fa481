// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/offline/render_press.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

namespace detent::playback {

namespace {

constexpr double silenceCheck_s = 0.01;
constexpr double gapInPeriods = 1.5;   // a gap of this length is filled with interpolated readings
constexpr double mostBetween = 20000;  // interpolated readings per gap
// number of readings from which a recording's noise is estimated
constexpr std::size_t heardBeforehand = 1024;
constexpr double longestRender_s = 7 * 24 * 3600.0;

ConditionerSettings conditionerFor(PressTrace::Quantity quantity, const HapticProgram& program) {
  ConditionerSettings settings = limitsFor(program);
  if (quantity == PressTrace::Quantity::displacement_mm) {
    // A trace in mm was recorded or drawn deliberately, so any finite, ordered value is accepted.
    settings.lowest = -1e9;
    settings.highest = 1e9;
    settings.fastest_per_s = 1e12;
    settings.mostNoise = 0;
  }
  // A drawn trace may have two readings a second apart, so only a live sensor can be silent.
  settings.silentAfter_s = 1e12;
  return settings;
}

Failure tooLong(const PressTrace& trace) {
  const double begins_s = trace.readings.front().time_s;
  if (begins_s > longestRender_s)
    return {FailureCode::wrongUsage, "press trace", "", Message("the first time is %1 s", begins_s),
            Message("Subtract this from all times, so that they begin at 0")};
  return {FailureCode::wrongUsage, "press trace", "", Message("the recording is longer than a week"),
          Message("Cut the recording into parts")};
}

Failure noneIsReading(const PressTrace& trace) {
  const bool force = trace.quantity == PressTrace::Quantity::force_N;
  return {FailureCode::unreadableInput, "press trace", "",
          Message("none of the %1 readings can be used, because each is out of range or not a number",
                  trace.readings.size()),
          force ? Message("Give the forces of a pressing finger in N") : Message("Give displacements in mm")};
}

}  // namespace

Result<Done> checkRendering(const PressTrace& trace, const RenderSettings& s) {
  const auto wrong = [](Message what, double value, double least, double most) {
    return Failure{FailureCode::wrongUsage, "rendered press", std::move(what),
                   Message("%1 lies outside %2 to %3", value, least, most),
                   Message("Give a value inside this range")};
  };
  if (!(s.sampleRate_Hz >= HapticEngine::lowestSampleRate_Hz &&
        s.sampleRate_Hz <= HapticEngine::highestSampleRate_Hz)) {
    return wrong(Message("sample rate in Hz"), s.sampleRate_Hz, HapticEngine::lowestSampleRate_Hz,
                 HapticEngine::highestSampleRate_Hz);
  }
  if (s.block < 1 || s.block > 8192)
    return wrong(Message("block length in samples"), static_cast<double>(s.block), 1, 8192);
  if (!(s.tail_s >= 0 && s.tail_s <= 60)) return wrong(Message("time after the press in s"), s.tail_s, 0, 60);
  if (trace.readings.empty()) {
    return Failure{FailureCode::wrongUsage, "press trace", "",
                   Message("the press trace contains no readings"), Message("Give at least one reading")};
  }
  if (trace.readings.front().time_s > longestRender_s) return tooLong(trace);
  return Done{};
}

std::vector<EngineInput> conditionedInputs(const PressTrace& trace, const HapticProgram& program,
                                           double sampleRate_Hz, double origin_s, ConditionerCounts& counts) {
  const double period_s = program.interpolationDelay_s;
  ForceConditioner conditioner(conditionerFor(trace.quantity, program));
  // A live sensor sends readings long before a press; a recording may begin with it, so its noise is learnt
  // first.
  const std::size_t heard = std::min(trace.readings.size(), heardBeforehand);
  for (std::size_t i = 0; i < heard; ++i) conditioner.learn(trace.readings[i].value);
  std::vector<EngineInput> inputs;
  inputs.reserve(trace.readings.size());
  EngineInput input;
  input.kind = trace.quantity == PressTrace::Quantity::force_N ? InputKind::force : InputKind::displacement;
  PressReading last;
  const auto put = [&](double time_s, double value) {
    input.time_frames = (time_s - origin_s) * sampleRate_Hz;
    input.value = value;
    inputs.push_back(input);
  };
  for (const PressReading& r : trace.readings) {
    if (conditioner.judge(r.time_s, r.value) == ConditionerVerdict::reject) continue;
    const PressReading now{r.time_s, conditioner.value()};
    // Later readings prove an earlier time stamp wrong: remove the inputs that came from it.
    while (!inputs.empty() && now.time_s <= last.time_s &&
           inputs.back().time_frames >= (now.time_s - origin_s) * sampleRate_Hz) {
      inputs.pop_back();
    }
    const double gap_s = now.time_s - last.time_s;
    if (!inputs.empty() && now.value != last.value && gap_s > gapInPeriods * period_s) {
      const double pieces = std::min(std::ceil(gap_s / period_s), mostBetween);
      for (double k = 1; k < pieces; ++k) {
        put(last.time_s + gap_s * (k / pieces), last.value + (now.value - last.value) * (k / pieces));
      }
    }
    put(now.time_s, now.value);
    last = now;
  }
  counts = conditioner.counts();
  return inputs;
}

Result<RenderSummary> renderPress(const HapticProgram& program, const PressTrace& trace,
                                  const RenderSettings& settings, const SampleSink& sink) {
  if (Result<Done> ok = checkRendering(trace, settings); !ok) return ok.failure();
  const auto began = std::chrono::steady_clock::now();
  RenderSummary summary;
  const double origin_s = std::min(0.0, trace.readings.front().time_s);
  const std::vector<EngineInput> inputs =
      conditionedInputs(trace, program, settings.sampleRate_Hz, origin_s, summary.sensor);
  if (inputs.empty()) return noneIsReading(trace);
  const double last_frames = inputs.back().time_frames;
  if (last_frames > longestRender_s * settings.sampleRate_Hz) return tooLong(trace);
  const auto end = static_cast<std::int64_t>(std::ceil(last_frames));
  const auto latest = end + static_cast<std::int64_t>(settings.tail_s * settings.sampleRate_Hz);

  const auto engine = std::make_unique<HapticEngine>(settings.sampleRate_Hz);
  engine->use(&program);
  std::vector<float> block(settings.block);
  std::size_t next = 0;
  EngineEvent event;
  // After the last reading the sound ends at the first of fixed times at which nothing sounds. The times are
  // independent of the block size, so the length is too.
  const auto checkEvery = static_cast<std::int64_t>(settings.sampleRate_Hz * silenceCheck_s);
  std::int64_t nextCheck = end + 1;
  while (engine->frame() < latest) {
    if (engine->frame() == nextCheck) {
      if (engine->idle()) break;
      nextCheck += checkEvery;
    }
    const std::int64_t stop = std::min(nextCheck, latest);
    auto count = static_cast<std::size_t>(
        std::min<std::int64_t>(static_cast<std::int64_t>(settings.block), stop - engine->frame()));
    const auto until = static_cast<double>(engine->frame() + static_cast<std::int64_t>(count));
    while (next < inputs.size() && inputs[next].time_frames < until && engine->push(inputs[next])) ++next;
    // A trace with more readings than the engine's ring holds ends the block early, so that no reading is
    // applied late.
    if (next < inputs.size() && inputs[next].time_frames < until)
      count =
          std::clamp<std::size_t>(static_cast<std::size_t>(std::max(
                                      0.0, inputs[next].time_frames - static_cast<double>(engine->frame()))),
                                  1, count);
    engine->render(block.data(), count);
    while (engine->nextEvent(event)) summary.events.push_back(event);
    for (std::size_t i = 0; i < count; ++i) summary.peak = std::max(summary.peak, std::fabs(block[i]));
    if (settings.cancelled && settings.cancelled()) {
      return Failure::cancelled("rendered press");
    }
    if (!sink(block.data(), count)) break;
  }
  summary.duration_s = static_cast<double>(engine->frame()) / settings.sampleRate_Hz;
  summary.counts = engine->counts();
  summary.computing_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return summary;
}

Result<RenderedPress> renderPress(const HapticProgram& program, const PressTrace& trace,
                                  const RenderSettings& settings) {
  RenderedPress rendered;
  Result<RenderSummary> summary =
      renderPress(program, trace, settings, [&](const float* samples, std::size_t count) {
        rendered.samples.insert(rendered.samples.end(), samples, samples + count);
        return true;
      });
  if (!summary) return summary.failure();
  rendered.summary = std::move(*summary);
  return rendered;
}

}  // namespace detent::playback
