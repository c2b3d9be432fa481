// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/offline/press_speed.h"

#include <cmath>
#include <memory>

#include "model/speed_family.h"
#include "playback/realtime/stroke_tracker.h"

namespace detent::playback {

namespace {

constexpr double endShare = 0.1;    // of the travel, left out at each end: there a press begins and stops
constexpr double sameSpeed = 0.01;  // a trace of straight lines is off by its rounding, a press by far more

Result<Button> feltAtSpeed(const Button& button, double speed_mm_per_s) {
  for (const double stated : speedsOf(button))
    if (std::abs(speed_mm_per_s / stated - 1) <= sameSpeed) return atSpeed(button, stated);
  return atSpeed(button, speed_mm_per_s);
}

}  // namespace

std::optional<double> pressSpeed_mm_per_s(const HapticProgram& program, const PressTrace& trace) {
  const StrokeTable& press = program.states[0].press;
  if (program.stateCount == 0 || press.pointCount < 2) return {};
  const double start_mm = press.points[0].displacement_mm,
               end_mm = press.points[press.pointCount - 1].displacement_mm;
  const double from_mm = std::lerp(start_mm, end_mm, endShare), to_mm = std::lerp(end_mm, start_mm, endShare);
  const auto tracker = std::make_unique<StrokeTracker>();
  tracker->use(&program);
  std::optional<double> passed_s;
  double before_mm = start_mm, before_s = 0;
  bool any = false;
  for (const PressReading& reading : trace.readings) {
    if (!std::isfinite(reading.value) || !std::isfinite(reading.time_s)) continue;
    double at_mm = reading.value;
    if (trace.quantity == PressTrace::Quantity::force_N) {
      tracker->updateForce(reading.value);
      at_mm = tracker->position().displacement_mm;
    }
    const auto passes = [&](double place_mm) -> std::optional<double> {
      if (!any || before_mm >= place_mm || at_mm < place_mm) return {};
      return std::lerp(before_s, reading.time_s, (place_mm - before_mm) / (at_mm - before_mm));
    };
    if (const auto begun_s = passes(from_mm)) passed_s = begun_s;
    if (const auto ended_s = passes(to_mm); ended_s && passed_s && *ended_s > *passed_s)
      return (to_mm - from_mm) / (*ended_s - *passed_s);
    before_mm = at_mm, before_s = reading.time_s, any = true;
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
