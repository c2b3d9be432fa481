// SPDX-License-Identifier: GPL-3.0-or-later
// The force law on sample-like buttons, under a simulated finger.
#include "playback/realtime/force_law.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

#include "playback/prepare/spring_button.h"
#include "tests/playback/force/force_run.h"
#include "tests/playback/force/sample_files.h"
#include "tests/playback/poisoned.h"

namespace {

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

std::vector<ForceDeviceProfile> presets() { return {simulatedDevice(), falconDevice(), voiceCoilRig()}; }

/// Slow full stroke through the law alone; gives the force at each place.
double forceAfter(ForceLaw& law, double from_mm, double to_mm) {
  const int steps = 2000;
  double force_N = 0;
  for (int i = 1; i <= steps; ++i) force_N = law.step(from_mm + (to_mm - from_mm) * i / steps, 0);
  return force_N;
}

}  // namespace

TEST_CASE("force law: full strokes lie on the two curves, and nothing happens between at rest") {
  const Button button = sampleButton("B");
  const PreparedForce prepared = forceOf(button, simulatedDevice());
  const ForceGraph& graph = button.states().front().graph;
  ForceLaw law(prepared.program);
  law.restart(0);
  for (const double x : {0.5, 1.25, 1.75, 2.5, 3.5})
    CHECK(forceAfter(law, 0, x) == Approx(graph.press().force_N(x)).margin(0.002));
  for (const double x : {3.5, 2.2, 1.55, 1.05, 0.3}) {
    CHECK(forceAfter(law, 3.9, x) == Approx(graph.release()->force_N(x)).margin(0.002));
  }
  // The same place, again and again: the same force, to the last bit.
  const double force_N = law.step(0.3, 0);
  for (int i = 0; i < 100; ++i) CHECK(law.step(0.3, 0) == force_N);
}

TEST_CASE("force law: the on/off button holds at 22.9 mm and comes back after the second press") {
  const PreparedForce prepared = forceOf(sampleButton("latch"), simulatedDevice());
  ForceLaw law(prepared.program);
  law.restart(0);
  CHECK(forceAfter(law, 0, 12) == Approx(1.2).margin(0.01));
  CHECK(forceAfter(law, 12, 5) == Approx(0.5).margin(0.01));  // not actuated: it springs back
  forceAfter(law, 5, 24.5);
  CHECK(law.actuated());
  forceAfter(law, 24.5, 22.9);
  CHECK(law.state() == 1);
  CHECK(forceAfter(law, 22.9, 22.0) < -0.4);  // the latched button holds the handle at its new rest position
  forceAfter(law, 22.0, 25.0);
  CHECK(law.actuated());
  CHECK(forceAfter(law, 25.0, 10) == Approx(1.0).margin(0.01));
  forceAfter(law, 10, 0);
  CHECK(law.state() == 0);
}

TEST_CASE(
    "force law: under a finger the on/off button stays where it was latched, and comes back at the next "
    "press") {
  for (const ForceDeviceProfile& device : presets()) {
    const PreparedForce prepared = forceOf(sampleButton("latch"), device);
    ForceRun run(prepared, device, FingerPresses{25.4, 2.6, 0.2, 0.2, 0.6});
    std::vector<std::uint32_t> states;
    double latched_mm = 0;
    run.run(8, [&](const ForceStep& s) {
      if (states.empty() || states.back() != s.state) states.push_back(s.state);
      if (s.state == 1 && !s.actuated && std::abs(s.velocity_mm_per_s) < 1) latched_mm = s.position_mm;
    });
    INFO(device.name);
    CHECK(states.size() >= 4);
    CHECK(states.size() <= 9);  // one change of state per press
    CHECK(latched_mm == Approx(22.9).margin(0.3));
  }
}

TEST_CASE("force law: a handle far below its rest is let go at every speed, damped or not") {
  for (const double damping_Ns_per_mm : {0.0, 0.004}) {
    const Result<Button> button = springButton("damped", {{0.4}, {damping_Ns_per_mm}, 4});
    REQUIRE(button);
    for (const ForceDeviceProfile& device : presets()) {
      const PreparedForce prepared = forceOf(*button, device);
      ForceLaw law(prepared.program);
      law.restart(-2);
      CHECK(law.step(-2, -100) < 0);
      law.restart(-6);
      for (const double speed_mm_per_s : {-500.0, 0.0, 500.0}) CHECK(law.step(-6, speed_mm_per_s) == 0);
    }
  }
}

TEST_CASE("force law: what a button does not have is not computed") {
  const PreparedForce spring = forceOf(sampleButton("push"), simulatedDevice());
  CHECK_FALSE(spring.program.states[0].hysteresis);
  CHECK(spring.program.states[0].damped);
  const PreparedForce graph = forceOf(sampleButton("A"), simulatedDevice());
  CHECK(graph.program.states[0].hysteresis);
  CHECK_FALSE(graph.program.states[0].damped);
  ForceSettings settings;
  settings.law = ForceLawKind::spring;
  CHECK_FALSE(forceOf(sampleButton("A"), simulatedDevice(), settings).program.states[0].hysteresis);
}

TEST_CASE("force law: no number is read of what a button does not have") {
  ForceSettings spring;
  spring.law = ForceLawKind::spring;
  const auto presses = [](PreparedForce prepared) {
    ForceRun run(prepared, simulatedDevice(),
                 FingerPresses{1.05 * prepared.summary.travel_mm, 1, 0.2, 0.2, 0.3});
    return meetsPoison([&] { run.run(2); });
  };
  for (const std::string& name : sampleNames()) {
    for (const ForceSettings& settings : {ForceSettings{}, spring}) {
      PreparedForce prepared = forceOf(sampleButton(name), simulatedDevice(), settings);
      prepared.program = poisoned(prepared.program);
      INFO(name);
      CHECK_FALSE(presses(prepared));
    }
  }
  // Properties that a button has are used: push has damping.
  PreparedForce push = forceOf(sampleButton("push"), simulatedDevice());
  for (ForceRow& row : push.program.states[0].rows) poison({&row.damping_Ns_per_mm});
  CHECK(presses(push));
}

TEST_CASE("force law: a resting finger feels nothing move, on every device and sample") {
  for (const ForceDeviceProfile& device : presets()) {
    for (const std::string& name : sampleNames()) {
      const Button button = sampleButton(name);
      const PreparedForce prepared = forceOf(button, device);
      for (const double share : {0.0, 0.3, 0.55, 0.8}) {
        const double at_mm = share * prepared.summary.travel_mm;
        const double carried_N = button.states().front().graph.press().force_N(at_mm) + device.friction_N;
        ForceRun run(prepared, device, FingerHold{at_mm, carried_N, 0.4});
        run.run(2);
        Quiet quiet;
        run.run(0.8, [&](const ForceStep& s) { quiet.add(s.position_mm, s.force_N); });
        INFO(device.name << ", " << name << " at " << at_mm << " mm");
        CHECK(quiet.peakToPeak_mm() <= device.step_mm * 1.0001);
        CHECK(quiet.rms_N() <= 0.005);
        CHECK(quiet.largestJump_N() <= 0.05);
      }
    }
  }
}

TEST_CASE("force law: a finger never gets back more than it gave") {
  std::mt19937 random(20131008);
  std::uniform_real_distribution<> share(0, 1);
  for (const ForceDeviceProfile& device : presets()) {
    for (const std::string& name : sampleNames()) {
      const PreparedForce prepared = forceOf(sampleButton(name), device);
      for (int i = 0; i < 6; ++i) {
        FingerPresses presses{prepared.summary.travel_mm * (0.3 + 0.75 * share(random)),
                              0.3 + 2 * share(random), 0.04 + 0.3 * share(random), 0.03 + 0.3 * share(random),
                              0.25};  // a finger that waits in the start's ramp gets energy from that
        FingerMechanics finger;
        finger.stiffness_N_per_mm = 0.2 + 0.6 * share(random);
        ForceRun run(prepared, device, presses, finger);
        double most_mJ = 0;
        run.run(1.5, [&](const ForceStep& step) { most_mJ = std::max(most_mJ, step.energy_mJ); });
        INFO(device.name << ", " << name << ", press " << i);
        CHECK(run.leastFingerWork_mJ() >= -1e-6);
        // The balance at the motor is sampled once in a period, which hides up to a percent of the energy.
        CHECK(run.engine().lowestBalance_mJ() >= -0.02 - 0.01 * most_mJ);
        CHECK(run.engine().counts().frozen == 0);
      }
    }
  }
}

TEST_CASE(
    "prepare force: impossible buttons and devices are refused with a sentence, hard ones are softened and "
    "told") {
  const auto steep = StrokeCurve::fromKnots({{0, 0.1, 0, 0}, {1, 0.2, 0, 0}, {1.0001, 1e5, 0, 0}});
  REQUIRE(steep);
  const Button hard = buttonOf("hard", {{"", *ForceGraph::fromCurves(*steep, {}), {}, {}, {}}});
  const PreparedForce prepared = forceOf(hard, voiceCoilRig());
  CHECK(prepared.summary.remarks.size() >= 2);
  for (const ForceRow& row : prepared.program.states[0].rows) CHECK(std::abs(row.press_N) <= 10);

  CHECK(prepareForce(buttonOf("tiny", {stateOf("", {{0, 0}, {0.05, 1}}, {})}), simulatedDevice())
            .failure()
            .code == FailureCode::wrongUsage);
  CHECK(prepareForce(buttonOf("long", {stateOf("", {{0, 0}, {150, 1}}, {})}), simulatedDevice())
            .failure()
            .code == FailureCode::wrongUsage);
  ForceDeviceProfile broken = simulatedDevice();
  broken.step_mm = std::numeric_limits<double>::quiet_NaN();
  CHECK(prepareForce(sampleButton("A"), broken).failure().code == FailureCode::wrongUsage);
  ForceSettings settings;
  settings.rate_Hz = 10;
  CHECK(prepareForce(sampleButton("A"), simulatedDevice(), settings).failure().code ==
        FailureCode::wrongUsage);
  CHECK(prepareForce(buttonOf("shortest", {stateOf("", {{0, 0}, {0.1, 1}}, {})}), simulatedDevice()).ok());
}

TEST_CASE("force engine: another button under a pressing finger takes over without a jump") {
  const PreparedForce soft = forceOf(sampleButton("A"), voiceCoilRig()),
                      hard = forceOf(sampleButton("C"), voiceCoilRig());
  ForceEngine engine(soft.program);
  ForceReading reading;
  for (int i = 1; i <= 400; ++i) {
    reading.position_mm = 0.003 * i;
    engine.step(reading);
  }
  const double before_N = engine.last().force_N;
  engine.setProgram(hard.program);
  double worst_N = 0, last_N = before_N;
  for (int i = 0; i < 250; ++i) {
    engine.step(reading);
    worst_N = std::max(worst_N, std::abs(engine.last().force_N - last_N));
    last_N = engine.last().force_N;
  }
  const double after_N = last_N;
  CHECK(std::abs(after_N - before_N) > 0.05);
  CHECK(after_N == Approx(sampleButton("C").states().front().graph.press().force_N(1.2)).margin(0.01));
  CHECK(worst_N < 0.01);
  CHECK(engine.last().index == 650);
  CHECK(engine.counts().readings == 650);
}

TEST_CASE("spring button: k(x) and b(x) as polynomials are the paper's equation") {
  const SpringPolynomials parabolas{{0.3325, -0.25, 0.05}, {0.001, 0.004, -0.0008}, 5};
  const Result<Button> made = springButton("parabolas", parabolas);
  REQUIRE(made);
  const PreparedForce prepared = forceOf(*made, simulatedDevice());
  ForceLaw law(prepared.program);
  for (const double x : {0.5, 1.7, 2.5, 4.4}) {
    const double k = 0.3325 - 0.25 * x + 0.05 * x * x, b = 0.001 + 0.004 * x - 0.0008 * x * x;
    CHECK(made->states().front().graph.press().force_N(x) == Approx(k * x).epsilon(1e-9));
    law.restart(x);
    CHECK(law.step(x, 0) == Approx(k * x).margin(1e-3));
    CHECK(law.step(x, -20) - law.step(x, 0) <= -20 * b + 1e-3);
  }
  CHECK(springButton("undamped", {{0.2}, {}, 4})->states().front().damping.empty());
  for (const SpringPolynomials& wrong : {SpringPolynomials{{}, {}, 4},
                                         {{0.2}, {-0.001}, 4},
                                         {{0.2}, {}, 0},
                                         {{0.2}, {}, std::nan("")},
                                         {{std::nan("")}, {}, 4},
                                         {{0.2}, {std::nan("")}, 4},
                                         {std::vector<double>(13, 0.1), {}, 4}}) {
    CHECK_FALSE(springButton("wrong", wrong));
  }
}

TEST_CASE("prepare force: bottom-outs of 1e5 N and of 0.1 um are rendered within the device's limits") {
  for (const ForceDeviceProfile& device : presets()) {
    for (const double bottomOut_mm : {1e-4, 0.01}) {
      const auto curve =
          StrokeCurve::fromKnots({{0, 0.1, 0, 0}, {2, 0.3, 0, 0}, {2 + bottomOut_mm, 1e5, 0, 0}});
      REQUIRE(curve);
      const PreparedForce prepared =
          forceOf(buttonOf("wall", {{"", *ForceGraph::fromCurves(*curve, {}), {}, {}, {}}}), device);
      CHECK(prepared.summary.remarks.size() >= 2);
      ForceRun run(prepared, device, FingerPresses{2.5, 5, 0.05, 0.05, 0.25});
      double most_N = 0;
      run.run(1, [&](const ForceStep& step) { most_N = std::max(most_N, std::abs(step.force_N)); });
      INFO(device.name << ", " << bottomOut_mm);
      CHECK(most_N <= device.limits.force_N);
      CHECK(run.leastFingerWork_mJ() >= -1e-6);
    }
  }
}

TEST_CASE("prepare force: a travel beyond the device's reach is refused, with the device's name") {
  const auto button = [](double travel_mm) {
    SpringPolynomials spring;
    spring.stiffness_N_per_mm = {0.01};
    spring.travel_mm = travel_mm;
    Result<Button> made = springButton("long", spring);
    REQUIRE(made);
    return *std::move(made);
  };
  CHECK(prepareForce(button(70), falconDevice()));
  const Result<PreparedForce> tooFar = prepareForce(button(71), falconDevice());
  REQUIRE_FALSE(tooFar);
  CHECK(tooFar.failure().code == FailureCode::wrongUsage);
  CHECK_THAT(tooFar.failure().sentence(),
             Catch::Contains("71 mm") && Catch::Contains("Novint Falcon reaches only 70 mm"));
  CHECK(prepareForce(button(71), voiceCoilRig()));
}

// DETENT_SIMULATED_HOURS=24 for the whole day (.ci/nightly extremes).
TEST_CASE("force law: a finger that rests for a day drifts by nothing") {
  const char* setting = std::getenv("DETENT_SIMULATED_HOURS");
  const double hours = setting != nullptr ? std::atof(setting) : 0.1;
  REQUIRE(hours > 0.05);
  const Button button = sampleButton("B");
  for (const ForceDeviceProfile& device : presets()) {
    const PreparedForce prepared = forceOf(button, device);
    ForceRun run(prepared, device,
                 FingerHold{2, button.states().front().graph.press().force_N(2) + device.friction_N, 0.4});
    run.run(60);
    const ForceStep begin = run.engine().last();
    run.run(3600 * hours - 60);
    const ForceStep& end = run.engine().last();
    INFO(device.name << ", " << hours << " h");
    CHECK(static_cast<double>(end.index) >= 3599 * hours / prepared.program.period_s);
    CHECK(std::abs(end.position_mm - begin.position_mm) <= 1.0001 * device.step_mm);
    CHECK(std::abs(end.force_N - begin.force_N) <= 0.005);
    CHECK(end.energy_mJ == Approx(begin.energy_mJ).margin(1e-3));
    CHECK(run.engine().counts().frozen == 0);
  }
}
