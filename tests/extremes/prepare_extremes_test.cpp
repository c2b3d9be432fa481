// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons of any size and settings of any number, made ready to be felt.

#include <cmath>
#include <memory>

#include <catch2/catch.hpp>

#include "model/damping.h"
#include "playback/prepare/damping.h"
#include "playback/prepare/prepare_force.h"
#include "playback/prepare/prepare_program.h"
#include "playback/prepare/spring_button.h"
#include "playback/prepare/stability.h"
#include "playback/prepare/stroke_table.h"
#include "playback/realtime/force_conditioner.h"
#include "tests/extremes/extreme_values.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::tests;

namespace {

bool isSound(const Burst& burst) {
  return std::isfinite(burst.frequency_Hz) && burst.frequency_Hz >= 0 && std::isfinite(burst.duration_s) &&
         burst.duration_s >= 0 && burst.amplitude >= 0 && burst.amplitude <= 1;
}

void assertSound(const StrokeTable& table) {
  RC_ASSERT(table.pointCount >= 2u && table.pointCount <= maxTablePoints);
  for (std::uint32_t i = 0; i < table.pointCount; ++i) {
    RC_ASSERT(std::isfinite(table.points[i].displacement_mm) && std::isfinite(table.points[i].force_N));
    if (i > 0) RC_ASSERT(table.points[i].displacement_mm >= table.points[i - 1].displacement_mm);
  }
  RC_ASSERT(table.jumpCount <= maxJumps && table.slopeCount <= maxSlopes);
  for (std::uint32_t i = 0; i < table.jumpCount; ++i) RC_ASSERT(isSound(table.jumps[i].burst));
}

void assertSound(const HapticProgram& program) {
  RC_ASSERT(program.stateCount >= 1u && program.stateCount <= maxStates);
  RC_ASSERT(isSound(program.grain) && isSound(program.bottomOut));
  RC_ASSERT(program.hysteresis_N >= 0 && program.restForce_N < program.hysteresis_N);
  for (std::uint32_t s = 0; s < program.stateCount; ++s) {
    assertSound(program.states[s].press);
    assertSound(program.states[s].release);
    RC_ASSERT(std::isfinite(program.states[s].bottomOut_mm) && std::isfinite(program.states[s].rest_mm));
  }
}

/// A device of any plausible make, and beyond.
ForceDeviceProfile anyDevice() {
  ForceDeviceProfile d = simulatedDevice();
  d.mass_kg = magnitude(1e-4, 10);
  d.friction_N = oneIn(4) ? 0 : magnitude(1e-4, 10);
  d.damping_Ns_per_mm = oneIn(4) ? 0 : magnitude(1e-6, 1);
  d.step_mm = magnitude(1e-6, 1);
  d.rate_Hz = magnitude(50, 20000);
  d.delay_s = oneIn(4) ? 0 : magnitude(1e-6, 0.1);
  d.largestSlope_N_per_mm = magnitude(1e-3, 1e3);
  return d;
}

Button forceButton() { return extremeButton({magnitude(0.1, 100), magnitude(1e-9, 1e6)}); }

double dampingNow(const std::vector<DampingPoint>& points, double x) { return dampingAt(points, x); }

}  // namespace

TEST_CASE("a button of any size becomes a program, or a failure names what is out of range", "[finite]") {
  holdsAlways("prepareProgram, 1 µm to 100 m, 1 nN to 1 MN", [] {
    const auto prepared = std::make_unique<Result<PreparedProgram>>(prepareProgram(extremeButton(), {}, {}));
    if (!*prepared) return assertNamed(prepared->failure());
    assertSound((*prepared)->program);
    RC_ASSERT(std::isfinite((*prepared)->summary.tableError_N) && (*prepared)->summary.tableError_N >= 0);
    for (const PrepareWarning& w : (*prepared)->summary.warnings) RC_ASSERT(!english(w.message).empty());
  });
  holdsAlways("fitTable: in order, its vertices stand on the curve", [] {
    const StrokeCurve curve = extremeCurve();
    std::vector<double> kept;
    for (int i = count(0, 5); i > 0; --i) kept.push_back(within(curve.start_mm(), curve.end_mm()));
    const TableFit fit = fitTable(curve, curve.start_mm(), curve.end_mm(), -1e9, kept);
    RC_ASSERT(fit.points.size() >= 2u && fit.points.size() <= maxTablePoints);
    RC_ASSERT(std::isfinite(fit.error_N) && fit.error_N >= 0);
    double before = curve.start_mm();
    for (const TablePoint& p : fit.points) {
      RC_ASSERT(p.displacement_mm >= before && p.displacement_mm <= curve.end_mm());
      before = p.displacement_mm;
      RC_ASSERT(p.force_N == curve.force_N(before) || p.force_N == curve.forceBefore_N(before));
    }
  });
  holdsAlways("limitsFor: the strongest force of the button passes", [] {
    const auto prepared = std::make_unique<Result<PreparedProgram>>(prepareProgram(extremeButton(), {}, {}));
    RC_PRE(prepared->ok());
    const ConditionerSettings limits = limitsFor((*prepared)->program);
    RC_ASSERT(std::isfinite(limits.highest) && std::isfinite(limits.lowest) &&
              std::isfinite(limits.fastest_per_s));
    RC_ASSERT(limits.lowest < 0 && limits.highest >= 30);
  });
}

TEST_CASE("any setting is taken or refused by its name") {
  holdsAlways("prepareProgram, any settings", [] {
    PlaybackSettings s;
    double* const fields[] = {&s.grainsPerMm,
                              &s.grainFrequency_Hz,
                              &s.grainDuration_s,
                              &s.grainAmplitude,
                              &s.highPass_Hz,
                              &s.lowPassCutoff_Hz,
                              &s.jumpDurationPerTravel_s_per_mm,
                              &s.shortestJump_s,
                              &s.longestJump_s,
                              &s.jumpAmplitudePerArea_per_mJ,
                              &s.faintestJump,
                              &s.pressJumpFrequency_Hz,
                              &s.releaseJumpFrequency_Hz,
                              &s.bottomOutFrequency_Hz,
                              &s.bottomOutDuration_s,
                              &s.bottomOutAmplitude,
                              &s.hysteresis_N,
                              &s.hysteresis_mm,
                              &s.rearm_N,
                              &s.sensorPeriod_s,
                              &s.burstSpacing_s,
                              &s.limiterCeiling,
                              &s.sections.minProminence_N,
                              &s.sections.minProminenceOfSpan,
                              &s.sections.bottomOutSlopeRatio};
    for (int i = count(1, 3); i > 0; --i)
      *fields[static_cast<std::size_t>(count(0, static_cast<int>(std::size(fields)) - 1))] =
          oneIn(2) ? anyDouble() : magnitude(1e-9, 1e3);
    const auto prepared =
        std::make_unique<Result<PreparedProgram>>(prepareProgram(extremeButton({4, 1}), {}, s));
    if (!*prepared) return assertNamed(prepared->failure());
    assertSound((*prepared)->program);
  });
  holdsAlways("prepareProgram, any profile", [] {
    DeviceProfile profile;
    profile.gain = oneIn(2) ? anyDouble() : magnitude(1e-3, 10);
    for (int i = count(0, 3); i > 0; --i)
      profile.resonances.push_back({anyDouble(), anyDouble(), anyDouble()});
    for (int i = count(0, 18); i > 0; --i)
      profile.equalizer.push_back(
          oneIn(3) ? EqualizerBand{anyDouble(), anyDouble(), anyDouble()}
                   : EqualizerBand{magnitude(10, 1000), magnitude(0.1, 100), within(-12, 12)});
    profile.transducer = {anyDouble(), anyDouble(), anyDouble()};
    profile.sensor.coefficients = {anyDouble(), anyDouble(), anyDouble(), anyDouble()};
    profile.sensor.noise_N = oneIn(2) ? anyDouble() : 0;
    const auto prepared =
        std::make_unique<Result<PreparedProgram>>(prepareProgram(extremeButton({4, 1}), profile, {}));
    if (!*prepared) return assertNamed(prepared->failure());
    assertSound((*prepared)->program);
    RC_ASSERT((*prepared)->program.limiterCeiling > 0 && (*prepared)->program.limiterCeiling <= 1);
  });
  holdsAlways("springButton, any polynomials", [] {
    SpringPolynomials spring;
    for (int i = count(0, 13); i > 0; --i)
      spring.stiffness_N_per_mm.push_back(oneIn(3) ? anyDouble() : within(-1, 1));
    for (int i = count(0, 13); i > 0; --i)
      spring.damping_Ns_per_mm.push_back(oneIn(3) ? anyDouble() : within(0, 0.01));
    spring.travel_mm = oneIn(2) ? anyDouble() : magnitude(1e-3, 1e5);
    const auto button = springButton("spring", spring);
    if (!button) assertNamed(button.failure());
  });
  holdsAlways("prepareForce, any device", [] {
    ForceDeviceProfile d = anyDevice();
    double* const fields[] = {&d.mass_kg,
                              &d.friction_N,
                              &d.damping_Ns_per_mm,
                              &d.step_mm,
                              &d.rate_Hz,
                              &d.delay_s,
                              &d.largestSlope_N_per_mm,
                              &d.limits.force_N,
                              &d.limits.slew_N_per_s,
                              &d.limits.speed_mm_per_s,
                              &d.limits.startRamp_s,
                              &d.limits.stopRamp_s};
    for (int i = count(1, 3); i > 0; --i)
      *fields[static_cast<std::size_t>(count(0, static_cast<int>(std::size(fields)) - 1))] = anyDouble();
    const auto prepared = std::make_unique<Result<PreparedForce>>(prepareForce(forceButton(), d));
    if (!*prepared) return assertNamed(prepared->failure());
    RC_ASSERT((*prepared)->program.period_s > 0);
  });
}

TEST_CASE("a force program holds what its header says", "[finite]") {
  holdsAlways(
      "prepareForce: finite rows, press not below release, no slope steeper than the device renders", [] {
        const ForceDeviceProfile device = anyDevice();
        const auto prepared = std::make_unique<Result<PreparedForce>>(prepareForce(forceButton(), device));
        if (!*prepared) return assertNamed(prepared->failure());
        const ForceProgram& program = (*prepared)->program;
        for (std::uint32_t s = 0; s < program.stateCount; ++s) {
          const ForceStateTable& t = program.states[s];
          RC_ASSERT(t.rowCount >= 2u && t.rowCount <= maxForceRows && t.spacing_mm > 0);
          for (std::uint32_t i = 0; i < t.rowCount; ++i) {
            const ForceRow& row = t.rows[i];
            RC_ASSERT(std::isfinite(row.press_N) && std::isfinite(row.release_N) &&
                      std::isfinite(row.pending_N));
            RC_ASSERT(std::isfinite(row.stored_mJ) && row.stored_mJ >= 0 && row.pendingStored_mJ >= 0);
            RC_ASSERT(std::isfinite(row.damping_Ns_per_mm) && row.damping_Ns_per_mm >= 0);
            RC_ASSERT(row.press_N >= row.release_N);
            if (i == 0) continue;
            const double rise = std::abs(double(row.press_N) - double(t.rows[i - 1].press_N));
            const double rounding =
                2e-7 * std::max(std::abs(double(row.press_N)), std::abs(double(t.rows[i - 1].press_N)));
            RC_ASSERT(rise <=
                      (*prepared)->summary.slopeLimit_N_per_mm * t.spacing_mm * (1 + 1e-6) + rounding);
          }
        }
        RC_ASSERT((*prepared)->summary.playRadius_mm > 0 && std::isfinite((*prepared)->summary.rest_mm));
      });
  holdsAlways("stabilityOf: finite margins over the whole travel", [] {
    const StabilityMargin margin = stabilityOf(forceButton(), anyDevice(), magnitude(50, 20000));
    for (const auto& state : margin.states)
      for (const MarginPoint& p : state)
        RC_ASSERT(std::isfinite(p.slope_N_per_mm) && std::isfinite(p.allowed_N_per_mm) &&
                  std::isfinite(p.displacement_mm));
    RC_ASSERT(std::isfinite(margin.anyFinger_N_per_mm));
  });
  holdsAlways("nearestStable is stable", [] {
    const ForceDeviceProfile device = anyDevice();
    const double rate_Hz = magnitude(50, 20000);
    const auto nearest = nearestStable(forceButton(), device, rate_Hz);
    if (!nearest) return assertNamed(nearest.failure());
    RC_ASSERT(stabilityOf(nearest->button, device, rate_Hz).stable());
  });
  holdsAlways("dampingAt, leastDamping, raiseDamping", [] {
    const double travel = magnitude(1e-3, 1e5);
    std::vector<DampingPoint> points;
    double x = 0;
    for (int i = count(0, 5); i > 0; --i)
      points.push_back({x += travel * within(1e-6, 0.3), magnitude(1e-9, 1)});
    const double least = magnitude(1e-9, 1);
    const double before = dampingNow(points, travel * share());
    RC_ASSERT(std::isfinite(before) && before >= 0);
    const double added = raiseDamping(points, least, travel);
    RC_ASSERT(std::isfinite(added) && added >= 0);
    RC_ASSERT(leastDamping(points) >= least * (1 - 1e-12));
    RC_ASSERT(dampingAt(points, travel * share()) >= least * (1 - 1e-12));
  });
}

TEST_CASE("a bottom-out of no frequency and a transducer that bears nothing are refused by name") {
  PlaybackSettings slow;
  slow.bottomOutFrequency_Hz = 5e-324;  // half a wave of it lasts for ever
  const auto endless =
      std::make_unique<Result<PreparedProgram>>(prepareProgram(test::linearButton(), {}, slow));
  REQUIRE_FALSE(*endless);
  CHECK(english(endless->failure().place) == "bottomOutFrequency_Hz");
  DeviceProfile weak;
  weak.transducer.power_W = 5e-324;
  weak.transducer.impedance_ohm = 8;
  weak.transducer.fullScale_V = 1000;
  const auto silent =
      std::make_unique<Result<PreparedProgram>>(prepareProgram(test::linearButton(), weak, {}));
  REQUIRE_FALSE(*silent);
  CHECK(silent->failure().sentence().find("power_W") != std::string::npos);
}
