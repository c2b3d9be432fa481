// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/perception/felt_button.h"

#include <algorithm>
#include <utility>

#include "playback/offline/standard_press.h"
#include "playback/prepare/prepare_program.h"
#include "playback/realtime/biquad.h"

namespace detent::playback {

namespace {

constexpr double hold_s = 0.08;
constexpr double releaseShare = 0.83;  // "releasing strokes are often faster than pressing strokes" (K&L)
constexpr double rest_s = 0.02;        // rest at the beginning of standardPress

/// Movement of the surface: the played samples after the device's resonances.
std::vector<float> throughDevice(const std::vector<float>& samples, const DeviceProfile& device) {
  std::vector<double> moved(samples.begin(), samples.end());
  for (const Resonance& r : device.resonances) {
    Biquad section;
    section.setCoefficients(peaking(perceptionRate_Hz, r.frequency_Hz, r.q, r.gain_dB));
    section.process(moved.data(), moved.size());
  }
  return {moved.begin(), moved.end()};
}

std::size_t grainsBetween(const std::vector<EngineEvent>& events, std::size_t from, std::size_t to) {
  std::size_t grains = 0;
  for (const EngineEvent& e : events) {
    const auto at = static_cast<std::size_t>(std::max<std::int64_t>(e.frame, 0));
    if (e.kind == EventKind::grain && at >= from && at < to) grains += e.count;
  }
  return grains;
}

FeltStroke strokeOf(const std::vector<float>& moved, const std::vector<EngineEvent>& events, std::size_t from,
                    std::size_t to, const PerceptionSettings& settings) {
  FeltStroke stroke;
  const std::size_t end = std::min(to, moved.size());
  if (from < end)
    stroke.samples.assign(moved.begin() + static_cast<std::ptrdiff_t>(from),
                          moved.begin() + static_cast<std::ptrdiff_t>(end));
  stroke.excitation = masked(excitationOf(stroke.samples, settings.thresholds), settings.masking);
  stroke.grains = grainsBetween(events, from, end);
  return stroke;
}

Result<FeltPress> feelPress(const HapticProgram& program, std::size_t length,
                            const PerceptionSettings& settings) {
  StandardPress press;
  const double press_s = pressLengths_s[length];
  press.peak_N = std::max(settings.hand.least_N[length], standardPeak_N(program));
  press.press_s = press_s;
  press.hold_s = hold_s;
  press.release_s = releaseShare * press_s;
  Result<RenderedPress> rendered = renderStandardPress(program, perceptionRate_Hz, press);
  if (!rendered) return rendered.failure();
  const std::vector<float> moved = throughDevice(rendered->samples, settings.device);
  const auto begin = static_cast<std::size_t>(rest_s * perceptionRate_Hz);
  const auto turn = begin + static_cast<std::size_t>((press_s + hold_s) * perceptionRate_Hz);
  const std::vector<EngineEvent>& events = rendered->summary.events;
  FeltPress felt{strokeOf(moved, events, begin, turn, settings),
                 strokeOf(moved, events, turn, moved.size(), settings)};
  felt.press.length_s = press.press_s;
  felt.release.length_s = press.release_s;
  return felt;
}

/// Forces along the finger's way. Without a release curve, the release has the forces of the press.
void feelForces(FeltPress& felt, const ForceGraph& graph) {
  const auto meanOf = [](const StrokeCurve& curve) {
    return curve.area_mJ(curve.start_mm(), curve.end_mm()) / curve.travel_mm();
  };
  felt.press.meanForce_N = meanOf(graph.press());
  felt.release.meanForce_N = graph.release() ? meanOf(*graph.release()) : felt.press.meanForce_N;
}

}  // namespace

DeviceProfile kimLeeApparatus() {
  constexpr double q = 8, gain_dB = 12;
  DeviceProfile device;
  device.name = "Kim & Lee 2013, mock-up";
  for (const double frequency_Hz : {260.0, 390.0, 780.0})
    device.resonances.push_back({frequency_Hz, q, gain_dB});
  return device;
}

Result<FeltButton> feel(const Button& button, const PerceptionSettings& settings,
                        const std::function<bool()>& cancelled) {
  Result<PreparedProgram> prepared = prepareProgram(button, settings.device, settings.playback);
  if (!prepared) return prepared.failure();
  FeltButton felt{button.name(), {}};
  HapticProgram program = prepared->program;
  for (std::size_t s = 0; s < program.stateCount; ++s) {
    felt.states.emplace_back();
    for (std::size_t i = 0; i < pressLengths_s.size(); ++i) {
      if (cancelled && cancelled())
        return Failure{FailureCode::wrongUsage, button.name(), "", Message("the step was cancelled"),
                       Message("Start the step again")};
      Result<FeltPress> press = feelPress(program, i, settings);
      if (!press) return press.failure();
      feelForces(*press, button.states()[s].graph);
      felt.states.back()[i] = *std::move(press);
    }
    if (program.stateCount > 1) std::swap(program.states[0], program.states[1]);
  }
  return felt;
}

}  // namespace detent::playback
