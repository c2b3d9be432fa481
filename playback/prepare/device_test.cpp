// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/device_test.h"

#include <algorithm>

namespace detent::playback {

namespace {

constexpr double halfOfRange = 0.25;  // the rest is room for the overshoot of a heavy handle
// Each wave of the chirp has at least this many periods; with coarse encoder steps, its amplitude is larger.
constexpr double periodsPerWave = 7, quickest_Hz = 150, slowestTest_Hz = 8, shake_mm = 0.6, shakeSteps = 30;

}  // namespace

ForceExcitation relayTest(const ForceProgram& program, double range_mm) {
  ForceExcitation e;
  e.kind = ForceExcitation::Kind::relay;
  e.middle_mm = range_mm / 2;
  e.half_mm = halfOfRange * range_mm;
  e.largest_N = program.limits.force_N;
  e.lead_s = 1.5 * program.period_s;
  return e;
}

ForceExcitation chirpTest(const ForceProgram& program, double range_mm, double mass_kg, double friction_N) {
  ForceExcitation e = relayTest(program, range_mm);
  e.kind = ForceExcitation::Kind::chirp;
  e.mass_kg = mass_kg;
  e.friction_N = friction_N;
  e.shake_mm = std::min(std::max(shake_mm, shakeSteps * program.step_mm), range_mm / 5);
  e.from_Hz = slowestTest_Hz;
  e.to_Hz = std::clamp(1 / (periodsPerWave * program.period_s), 2 * slowestTest_Hz, quickest_Hz);
  e.sweep_s = chirpTest_s / 2;
  return e;
}

}  // namespace detent::playback
