// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/offline/press_speed.h"

#include <cmath>

#include "model/speed_family.h"
#include "playback/realtime/speed_tracker.h"

namespace detent::playback {

namespace {

// a trace of straight lines deviates only by rounding; a recorded press by far more
constexpr double sameSpeed = 0.01;

Result<Button> feltAtSpeed(const Button& button, double speed_mm_per_s) {
  for (const double stated : speedsOf(button))
    if (std::abs(speed_mm_per_s / stated - 1) <= sameSpeed) return atSpeed(button, stated);
  return atSpeed(button, speed_mm_per_s);
}

}  // namespace

std::optional<double> pressSpeed_mm_per_s(const HapticProgram& program, const PressTrace& trace) {
  if (program.stateCount == 0 || program.states[0].press.pointCount < 2) return {};
  const PressMarks marks = trace.quantity == PressTrace::Quantity::force_N ? forceMarks(program.states[0])
                                                                           : placeMarks(program.states[0]);
  if (!(marks.way_mm > 0)) return {};
  std::optional<double> passed_s;
  std::optional<PressReading> before;
  for (const PressReading& reading : trace.readings) {
    if (!std::isfinite(reading.value) || !std::isfinite(reading.time_s)) continue;
    const auto passes = [&](double mark) -> std::optional<double> {
      if (!before || before->value >= mark || reading.value < mark) return {};
      return std::lerp(before->time_s, reading.time_s,
                       (mark - before->value) / (reading.value - before->value));
    };
    if (const auto begun_s = passes(marks.from)) passed_s = begun_s;
    if (const auto ended_s = passes(marks.to); ended_s && passed_s && *ended_s > *passed_s)
      return marks.way_mm / (*ended_s - *passed_s);
    before = reading;
  }
  return {};
}

Result<PressedButton> asPressed(const Button& button, const PreparedProgram& front, const PressTrace& trace,
                                const DeviceProfile& profile, const PlaybackSettings& settings) {
  const std::vector<double> speeds = speedsOf(button);
  if (speeds.empty()) return PressedButton{button, front, {}};
  const std::optional<double> speed_mm_per_s = pressSpeed_mm_per_s(front.program, trace);
  Result<Button> felt = feltAtSpeed(button, speed_mm_per_s.value_or(speeds.front()));
  if (!felt) return felt.failure();
  Result<PreparedProgram> prepared = prepareProgram(*felt, profile, settings);
  if (!prepared) return prepared.failure();
  return PressedButton{*std::move(felt), *std::move(prepared), speed_mm_per_s};
}

}  // namespace detent::playback
