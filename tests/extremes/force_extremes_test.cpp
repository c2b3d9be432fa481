// SPDX-License-Identifier: GPL-3.0-or-later
// The force loop on any readings and any button: never more force than the limits, never energy below what is
// held, and a record of a press back to its spring and damper.

#include <cmath>
#include <memory>

#include <catch2/catch.hpp>

#include "playback/identification/identify.h"
#include "playback/prepare/prepare_force.h"
#include "playback/realtime/force_engine.h"
#include "tests/extremes/extreme_values.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::tests;

namespace {

const ForceProgram& forceProgramOf(int button) {
  static const std::vector<ForceProgram> programs = [] {
    std::vector<ForceProgram> made;
    for (const Button& b :
         {test::linearButton(), test::tactileButton(), test::twoLevelButton(), test::lockingButton()})
      made.push_back(prepareForce(b, simulatedDevice())->program);
    return made;
  }();
  return programs[static_cast<std::size_t>(button)];
}
const ForceProgram& anyForceProgram() { return forceProgramOf(count(0, 3)); }

VelocityMethod anyMethod() { return static_cast<VelocityMethod>(count(0, 2)); }

/// Presses of a spring and damper, faster and faster, with noise.
ForceRecord recordOf(Size size, double stiffness, double damping, double noise, int samples = 400) {
  ForceRecord record;
  const double turns = within(2, 5);
  for (int i = 0; i < samples; ++i) {
    const double s = static_cast<double>(i) / samples, w = 2 * 3.14159265358979 * turns * (1 + 0.7 * s);
    const double speed = 2 * 3.14159265358979 * turns * (1 + 1.4 * s);
    record.time_s.push_back(2 * s);
    record.displacement_mm.push_back(size.travel_mm * 0.5 * (1 - std::cos(w * s)));
    const double velocity = size.travel_mm * 0.5 * std::sin(w * s) * speed / 2;
    record.force_N.push_back(0.1 * size.force_N + stiffness * record.displacement_mm.back() +
                             damping * velocity + noise * size.force_N * within(-1, 1));
  }
  return record;
}

}  // namespace

TEST_CASE("no reading gets more force out of the loop than the limits allow") {
  holdsAlways("ForceEngine, any readings", [] {
    const ForceProgram& program = anyForceProgram();
    ForceEngine engine(program);
    double before_N = 0, position = 0;
    for (int i = count(1, 400); i > 0; --i) {
      position = oneIn(100) ? within(-60, 160) : position + within(-0.5, 0.5);
      ForceReading reading;
      reading.position_mm = oneIn(30) ? anyDouble() : position;
      reading.sideways_mm = {oneIn(30) ? anyDouble() : within(-5, 5), within(-5, 5)};
      reading.fresh = !oneIn(10);
      const ForceCommand command = engine.step(reading);
      RC_ASSERT(std::isfinite(command.force_N) &&
                std::abs(command.force_N) <= program.limits.force_N * (1 + 1e-12));
      RC_ASSERT(std::isfinite(command.sideways_N[0]) && std::isfinite(command.sideways_N[1]));
      RC_ASSERT(std::isfinite(engine.last().energy_mJ) && std::isfinite(engine.lowestBalance_mJ()));
      before_N = command.force_N;
    }
    (void)before_N;
  });
  holdsAlways("ForceGuard: force and slew within their limits, nothing where it is not finite", [] {
    ForceLimits limits;
    ForceGuard guard(limits, 0.001, 0.01);
    double before_N = 0;
    for (int i = count(1, 400); i > 0; --i) {
      guard.judge(oneIn(10) ? anyDouble() : within(0, 1), !oneIn(10));
      const double requested = oneIn(4) ? anyDouble() : within(-20, 20);
      const double sent = guard.limit(requested, oneIn(10) ? anyDouble() : within(-100, 100));
      RC_ASSERT(std::isfinite(sent) && std::abs(sent) <= limits.force_N);
      if (guard.gain() == 1 && std::isfinite(requested))
        RC_ASSERT(std::abs(sent - before_N) <= limits.slew_N_per_s * 0.001 * (1 + 1e-9));
      before_N = sent;
    }
  });
  holdsAlways("ForceEngine: stopped, it falls silent within its ramp", [] {
    const ForceProgram& program = anyForceProgram();
    ForceEngine engine(program);
    for (int i = 0; i < 300; ++i) engine.step({1 + 0.002 * i, {}, true});
    engine.stop();
    const int steps = static_cast<int>(program.limits.stopRamp_s / program.period_s) + 2;
    for (int i = 0; i < steps; ++i) engine.step({1.6, {}, true});
    RC_ASSERT(engine.silent());
    RC_ASSERT(engine.last().force_N == 0);
  });
}

TEST_CASE("the force law holds what its header says", "[finite]") {
  holdsAlways("ForceLaw: finite force, energy never below 0, share between the curves", [] {
    const Button button = extremeButton({tests::magnitude(0.1, 100), tests::magnitude(1e-9, 1e6)});
    const auto prepared = std::make_unique<Result<PreparedForce>>(prepareForce(button, simulatedDevice()));
    if (!*prepared) return assertNamed(prepared->failure());
    ForceLaw law((*prepared)->program);
    double x = (*prepared)->summary.rest_mm;
    law.restart(x);
    for (int i = count(1, 200); i > 0; --i) {
      const double velocity = within(-500, 500);
      x += velocity * (*prepared)->program.period_s;
      RC_ASSERT(std::isfinite(law.step(x, velocity)));
      RC_ASSERT(law.pressShare() >= -1e-9 && law.pressShare() <= 1 + 1e-9);
      RC_ASSERT(law.stored_mJ(x) >= 0);
      RC_ASSERT(std::isfinite(law.stateEnergy_mJ()));
      RC_ASSERT(law.state() < (*prepared)->program.stateCount);
    }
  });
  holdsAlways("PlayOperator: never farther from the position than its radius, its share within 0 and 1", [] {
    PlayOperator play;
    const double radius = tests::magnitude(1e-9, 1e3);
    double x = within(-1, 1) * radius * 1e3;
    play.restart(x, radius, share());
    for (int i = count(1, 100); i > 0; --i) {
      x += within(-3, 3) * radius;
      const double centre = play.update(x, radius);
      RC_ASSERT(std::abs(centre - x) <= radius * (1 + 1e-9));
      RC_ASSERT(play.pressShare(x, radius) >= -1e-9 && play.pressShare(x, radius) <= 1 + 1e-9);
    }
  });
  holdsAlways("PlayOperator: a way in many steps ends where it ends in one", [] {
    PlayOperator one, many;
    const double radius = tests::magnitude(1e-6, 10), to = within(-100, 100);
    one.restart(0, radius, 0.5);
    many.restart(0, radius, 0.5);
    one.update(to, radius);
    const int steps = count(1, 100);
    for (int i = 1; i <= steps; ++i) many.update(i == steps ? to : to * i / steps, radius);
    RC_ASSERT(one.centre_mm() == many.centre_mm());
  });
  holdsAlways("ForceLaw: at rest force and energy do not creep", [] {
    const ForceProgram& program = anyForceProgram();
    ForceLaw law(program);
    const double x = within(0.2, 1.5);
    law.restart(x);
    const double first = law.step(x, 0);
    for (int i = 0; i < 2000; ++i) law.step(x, 0);
    const double later = law.step(x, 0), stored = law.stored_mJ(x);
    for (int i = 0; i < 2000; ++i) law.step(x, 0);
    RC_ASSERT(law.step(x, 0) == later && law.stored_mJ(x) == stored);
    RC_ASSERT(std::isfinite(first));
  });
}

TEST_CASE("velocity", "[finite]") {
  holdsAlways("VelocityEstimator: finite for any encoder and rate", [] {
    const double period = tests::magnitude(5e-5, 0.02), step = tests::magnitude(1e-9, 10);
    VelocityEstimator estimator(anyMethod(), period, step);
    estimator.restart(0);
    double x = 0;
    for (int i = count(1, 200); i > 0; --i) {
      x += within(-5, 5) * step;
      RC_ASSERT(std::isfinite(estimator.update(std::floor(x / step) * step)));
    }
  });
  holdsAlways("VelocityEstimator: a constant velocity is found, to two steps a period", [] {
    const double period = 0.001, step = 0.001, velocity = within(5, 200);
    VelocityEstimator estimator(anyMethod(), period, step);
    estimator.restart(0);
    double found = 0;
    for (int i = 1; i <= 400; ++i) found = estimator.update(std::floor(velocity * period * i / step) * step);
    RC_ASSERT(std::abs(found - velocity) <= 2 * step / period);
  });
  holdsAlways("VelocityEstimator: at rest it comes to nothing", [] {
    VelocityEstimator estimator(anyMethod(), 0.001, 0.01);
    estimator.restart(0);
    for (int i = 0; i < 50; ++i) estimator.update(0.01 * std::floor(within(0, 50)));
    double last = 1;
    for (int i = 0; i < 2000; ++i) last = estimator.update(0.2);
    RC_ASSERT(std::abs(last) <= 0.01 / (1990 * 0.001));
  });
}

TEST_CASE("identification from records of any size", "[finite]") {
  holdsAlways("identify: finite figures, the truth within its errors", [] {
    const Size size = anySize();
    const double k = within(0.2, 1) * size.force_N / size.travel_mm,
                 b = within(0.002, 0.02) * size.force_N / size.travel_mm;
    const auto found = identify(recordOf(size, k, b, 1e-3));
    if (!found) RC_FAIL(found.failure().sentence());
    RC_ASSERT(std::abs(found->k_N_per_mm[0].value - k) <= 8 * found->k_N_per_mm[0].sigma + 0.01 * k);
    RC_ASSERT(!found->b_Ns_per_mm.empty());
    RC_ASSERT(std::abs(found->b_Ns_per_mm[0].value - b) <= 8 * found->b_Ns_per_mm[0].sigma + 0.05 * b);
    RC_ASSERT(std::isfinite(found->condition) && found->condition >= 1 && std::isfinite(found->residual_N));
  });
  holdsAlways("identify: the same in any unit", [] {
    ForceRecord record = recordOf({4, 1}, within(0.05, 0.3), within(0.0005, 0.005), 1e-3);
    const auto one = identify(record);
    const double newton = std::ldexp(1.0, count(-30, 16));
    for (double& f : record.force_N) f *= newton;
    const auto other = identify(record);
    RC_ASSERT(one.ok() && other.ok());
    RC_ASSERT(other->k_N_per_mm[0].value == one->k_N_per_mm[0].value * newton);
    RC_ASSERT(other->k_N_per_mm[0].sigma == one->k_N_per_mm[0].sigma * newton);
    RC_ASSERT(other->b_Ns_per_mm.size() == one->b_Ns_per_mm.size());
  });
  holdsAlways("identify: the same at any time of day", [] {
    ForceRecord record = recordOf({4, 1}, 0.2, 0.002, 1e-3);
    const auto one = identify(record);
    const double start = std::ldexp(1.0, count(0, 30));
    for (double& t : record.time_s) t += start;
    const auto other = identify(record);
    RC_ASSERT(one.ok() && other.ok());
    RC_ASSERT(alike(other->k_N_per_mm[0].value, one->k_N_per_mm[0].value, 1e-3));
  });
  holdsAlways("buttonFrom: a button, or what of it is out of range", [] {
    const Size size{tests::magnitude(0.1, 100), tests::magnitude(1e-6, 1e3)};
    const auto found =
        identify(recordOf(size, size.force_N / size.travel_mm, 0.01 * size.force_N / size.travel_mm, 1e-3));
    RC_PRE(found.ok());
    const auto button = buttonFrom(*found, "found", oneIn(4) ? anyFinite() : size.travel_mm);
    if (!button) assertNamed(button.failure());
  });
}

TEST_CASE("records and settings of any kind are identified or refused by name") {
  holdsAlways("identify, any numbers", [] {
    ForceRecord record = recordOf({4, 1}, 0.2, 0.002, 1e-3, 60);
    for (int i = count(1, 5); i > 0; --i) {
      const auto at = static_cast<std::size_t>(count(0, 59));
      (oneIn(2) ? record.displacement_mm : record.force_N)[at] = anyFinite();
    }
    const auto found = identify(record, {static_cast<std::size_t>(count(0, 34)), 10, 0.2});
    if (!found) return assertNamed(found.failure());
    for (const Estimate& k : found->k_N_per_mm) RC_ASSERT(std::isfinite(k.value) && std::isfinite(k.sigma));
    for (const Estimate& b : found->b_Ns_per_mm) RC_ASSERT(std::isfinite(b.value) && std::isfinite(b.sigma));
  });
  holdsAlways("parseForceRecord, any text", [] {
    std::string text = "time_s,displacement_mm,force_N\n";
    for (int i = count(0, 40); i > 0; --i)
      text += "0123456789.,-e\nnai "[static_cast<std::size_t>(count(0, 18))];
    const auto record = parseForceRecord(text, "any");
    if (!record) return assertNamed(record.failure());
    for (std::size_t i = 1; i < record->time_s.size(); ++i)
      RC_ASSERT(record->time_s[i] > record->time_s[i - 1]);
  });
}

TEST_CASE("a record beyond any button is refused with the sample that is") {
  ForceRecord record;
  for (int i = 0; i < 200; ++i) {
    record.time_s.push_back(0.005 * i);
    record.displacement_mm.push_back(2 - 2 * std::cos(0.05 * i));
    record.force_N.push_back(0.2 * record.displacement_mm.back());
  }
  record.force_N[17] = 1e300;
  const auto found = identify(record);
  REQUIRE_FALSE(found);
  CHECK(english(found.failure().place) == "sample 18");
  CHECK(found.failure().code == FailureCode::unreadableInput);
}

TEST_CASE("a button that pulls in at the bottom keeps its energy at the bottom-out, too") {
  // The force ends at -3,500 N; the device pulls as steeply as it can and comes to rest inside the end stop.
  const Result<StrokeCurve> press = StrokeCurve::throughPoints({{0, 0}, {1.5, -3000}, {4, -3500}});
  const auto prepared = prepareForce(
      test::buttonOf("pulls", {{"", *ForceGraph::fromCurves(*press, {}), {}, {}, {}}}), simulatedDevice());
  REQUIRE(prepared);
  const ForceStateTable& table = prepared->program.states[0];
  const double end_N = static_cast<double>(table.rows[table.rowCount - 1].release_N),
               rest_mm = prepared->summary.rest_mm;
  CHECK(end_N < -5);
  CHECK(rest_mm == Approx(4 - end_N / table.bottomOutSlope_N_per_mm));
  ForceLaw law(prepared->program);
  CHECK(law.stored_mJ(rest_mm) == Approx(0).margin(1e-5));
  // The stored energy differs by the force times the way, before the end stop and in it, on both sides of the
  // rest.
  for (const double x : {3.9, 4.1, rest_mm - 0.05, rest_mm + 0.05, rest_mm + 1}) {
    CHECK(law.stored_mJ(x) > 0);
    CHECK((law.stored_mJ(x + 0.005) - law.stored_mJ(x - 0.005)) / 0.01 ==
          Approx(law.step(x, 0)).margin(0.02));
  }
}
