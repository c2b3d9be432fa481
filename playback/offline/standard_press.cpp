// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/offline/standard_press.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "playback/realtime/finger_profile.h"

namespace detent::playback {

namespace {

constexpr double tremorOfForce = 0.01;  // physiological tremor, 8-12 Hz
constexpr double tremor_Hz = 10;
constexpr double overPress = 1.25;  // a quarter more than the bottom-out needs
constexpr double rest_s = 0.02;     // before and after, so that beginning and end are visible

}  // namespace

double standardPeak_N(const HapticProgram& program) {
  return std::max(overPress * strongestForce_N(program), 4 * program.hysteresis_N);
}

PressTrace standardPress(const HapticProgram& program, const StandardPress& press) {
  const double peak_N = press.peak_N > 0 ? press.peak_N : standardPeak_N(program);
  PressTrace trace;
  const double up_s = rest_s + press.press_s, hold_s = up_s + press.hold_s, down_s = hold_s + press.release_s;
  const auto count = static_cast<std::size_t>(std::ceil((down_s + rest_s) * press.sensor_Hz));
  for (std::size_t i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / press.sensor_Hz;
    double force = t < hold_s ? peak_N * minimumJerk((t - rest_s) / press.press_s)
                              : peak_N * (1 - minimumJerk((t - hold_s) / press.release_s));
    if (t > up_s && t < hold_s)
      force *= 1 + tremorOfForce * std::sin(2 * std::numbers::pi * tremor_Hz * (t - up_s));
    trace.readings.push_back({t, force});
  }
  return trace;
}

Result<RenderedPress> renderStandardPress(const HapticProgram& program, double sampleRate_Hz,
                                          const StandardPress& press) {
  if (!(press.press_s > 0 && press.release_s > 0 && press.hold_s >= 0 && press.peak_N >= 0 &&
        press.sensor_Hz >= 10 && press.sensor_Hz <= 100000 &&
        press.press_s + press.hold_s + press.release_s <= 600)) {
    return Failure{FailureCode::wrongUsage, "standard press", "",
                   Message("a time, the force or the sensor rate is out of range"),
                   Message("Give positive times that add up to at most 600 s")};
  }
  RenderSettings settings;
  settings.sampleRate_Hz = sampleRate_Hz;
  // The force of a tactile button may increase strongly within one reading; in a press made from its curve
  // that is no glitch.
  return renderPress(program, standardPress(program, press), settings);
}

}  // namespace detent::playback
