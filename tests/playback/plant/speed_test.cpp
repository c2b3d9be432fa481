// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons with graphs at several speeds under the independent finger: at a speed it feels that speed's graph,
// and never gets back more than it gave.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "model/speed_family.h"
#include "playback/prepare/speed_change.h"
#include "playback/prepare/stability.h"
#include "tests/playback/plant/closed_loop.h"
#include "tests/playback/plant/finger.h"

using namespace detent;
using namespace detent::test;

namespace {

StrokeCurve through(const std::vector<CurvePoint>& points) { return *StrokeCurve::throughPoints(points); }

/// A dome: peak and release at 1 mm, a valley at 2 mm, 1.2 N at the bottom.
Button dome(double peak_N, double release_N, double peak_mm = 1) {
  auto graph =
      ForceGraph::fromCurves(through({{0, 0.1}, {peak_mm, peak_N}, {2, 0.7 * peak_N}, {4, 1.2}}),
                             through({{0, 0.05}, {peak_mm, release_N}, {2, 0.8 * release_N}, {4, 1.2}}));
  return *Button::fromStates("dome", {ButtonState{"", *std::move(graph), {}, {}, {}}});
}

Button family(const std::vector<Button>& members, const std::vector<double>& speeds) {
  Result<Button> made = familyOf(members, speeds);
  if (!made) throw std::runtime_error(made.failure().sentence());
  return *std::move(made);
}

/// The force a press of the family has there, straight in speed: said again, from the graphs alone.
double drawn_N(const std::vector<Button>& members, const std::vector<double>& speeds, double at_mm,
               double speed) {
  const auto at = [&](std::size_t i) { return members[i].states()[0].graph.press().force_N(at_mm); };
  if (speed <= speeds.front()) return at(0);
  for (std::size_t i = 1; i < speeds.size(); ++i)
    if (speed <= speeds[i])
      return at(i - 1) + (at(i) - at(i - 1)) * (speed - speeds[i - 1]) / (speeds[i] - speeds[i - 1]);
  return at(speeds.size() - 1);
}

}  // namespace

TEST_CASE("pressed at a speed, the force is that speed's graph", "[speeds]") {
  const std::vector<Button> members = {dome(0.6, 0.35), dome(0.75, 0.3), dome(0.95, 0.25)};
  const std::vector<double> speeds = {10, 60, 160};
  const playback::ForceDeviceProfile device = playback::simulatedDevice();
  const playback::ForceProgram program = preparedFor(family(members, speeds), device);
  for (const double speed : {5.0, 10.0, 30.0, 60.0, 100.0, 160.0, 250.0}) {
    LoopSettings settings;
    settings.handle = handleOf(device);
    settings.finger.stiffness_N_per_mm = 20;  // a machine's finger: it keeps its speed
    settings.finger.damping_Ns_per_mm = 0.02;
    settings.finger.pulpRate_per_mm = 20;
    settings.finger.muscleLag_s = 0;
    ClosedLoop loop(program, settings, sweeping(-2, speed, 0.3));
    std::vector<double> off_N;
    std::vector<LoopStep> steps = loop.runUntil(0.3 + 6.5 / speed);
    for (std::size_t i = 5; i < steps.size(); ++i) {
      const LoopStep& s = steps[i];
      if (s.position_mm < 0.3 || s.position_mm > 3.5) continue;
      const double v = (s.position_mm - steps[i - 5].position_mm) / (s.time_s - steps[i - 5].time_s);
      off_N.push_back(std::abs(s.command_N - drawn_N(members, speeds, s.position_mm, v)));
    }
    REQUIRE(off_N.size() > 10);
    std::ranges::sort(off_N);
    INFO(speed << " mm/s: median " << off_N[off_N.size() / 2] << " N, 95 % below "
               << off_N[off_N.size() * 95 / 100]);
    // The law leads the handle by 1.5 ms: at 250 mm/s that is 0.4 mm on a flank of up to 0.8 N/mm.
    CHECK(off_N[off_N.size() / 2] < 0.01 + 0.001 * speed);
    CHECK(off_N[off_N.size() * 95 / 100] < 0.02 + 0.002 * speed);
  }
}

TEST_CASE("released at a speed, the force is that speed's release; at rest the slowest graph's", "[speeds]") {
  const std::vector<double> speeds = {10, 100};
  const auto program = std::make_unique<playback::ForceProgram>(
      preparedFor(family({dome(0.6, 0.35), dome(0.9, 0.2)}, speeds), playback::simulatedDevice()));
  playback::ForceLaw law(*program);
  law.restart(0);
  law.step(3.5, 10);
  CHECK(law.step(3.5, 0) == Approx(dome(0.6, 0.35).states()[0].graph.press().force_N(3.5)).margin(2e-4));
  for (double at_mm = 3.5; at_mm > 2; at_mm -= 0.01) law.step(at_mm, -50);
  for (const auto& [speed, share] :
       {std::pair{5.0, 0.0}, {10.0, 0.0}, {55.0, 0.5}, {100.0, 1.0}, {400.0, 1.0}}) {
    const double slow_N = dome(0.6, 0.35).states()[0].graph.release()->force_N(1.5),
                 fast_N = dome(0.9, 0.2).states()[0].graph.release()->force_N(1.5);
    // The lower of the forces here and 1.5 ms ahead.
    double least_N = 10;
    for (double lead = 0; lead < 1; lead += 0.01) {
      const double x = 1.5 - lead * speed * program->law.holdLead_s;
      least_N = std::min(least_N, std::lerp(dome(0.6, 0.35).states()[0].graph.release()->force_N(x),
                                            dome(0.9, 0.2).states()[0].graph.release()->force_N(x), share));
    }
    INFO(speed << " mm/s, " << slow_N << " and " << fast_N << " N");
    CHECK(law.step(1.5, -speed) == Approx(least_N).margin(3e-3));
  }
}

TEST_CASE("graphs that are all the same play bit for bit as one", "[speeds]") {
  const Button one = dome(0.7, 0.3), three = family({one, one, one}, {10, 50, 200});
  for (const playback::ForceDeviceProfile& device : {playback::simulatedDevice(), playback::falconDevice()}) {
    LoopSettings settings;
    settings.handle = handleOf(device);
    settings.encoderStep_mm = device.step_mm;
    const auto runOf = [&](const Button& button) {
      ClosedLoop loop(preparedFor(button, device), settings, pressing({}));
      std::vector<double> forces;
      for (const LoopStep& step : loop.runUntil(0.9)) forces.push_back(step.command_N);
      forces.push_back(loop.engine().lowestBalance_mJ());
      return forces;
    };
    CHECK(runOf(three) == runOf(one));
  }
}

TEST_CASE("no press of a family gives a finger more than it took, at whatever speeds", "[speeds]") {
  Chance chance(1111);
  int refused = 0, felt = 0;
  for (int run = 0; run < 400; ++run) {
    playback::ForceDeviceProfile device = playback::simulatedDevice();
    const double delay_s = std::round(chance.between(0, 2) * 40) * 25e-6, lag_s = chance.between(0, 0.002);
    device.delay_s = delay_s + lag_s;
    device.friction_N = chance.between(0, 0.1);
    std::vector<Button> members;
    std::vector<double> speeds;
    const std::size_t count = 2 + chance.below(3);
    double peak_N = chance.between(0.5, 0.9), release_N = chance.between(0.1, 0.45),
           speed = chance.between(5, 30);
    for (std::size_t i = 0; i < count; ++i) {
      members.push_back(dome(peak_N, release_N, chance.between(0.95, 1.05)));
      speeds.push_back(speed);
      peak_N = std::max(0.3, peak_N + chance.between(-0.1, 0.25));
      release_N = std::max(0.05, release_N + chance.between(-0.15, 0.08));
      speed *= chance.between(1.5, 4);
    }
    const Result<playback::PreparedForce> prepared = playback::prepareForce(family(members, speeds), device);
    if (!prepared) {
      ++refused;
      continue;
    }
    ++felt;
    // The reason: in every row no release force is above any press force.
    const playback::ForceStateTable& t = prepared->program.states[0];
    bool ordered = true;
    for (std::size_t i = 0; i < t.rowCount; ++i) {
      float strongest_N = t.rows[i].release_N, least_N = t.rows[i].press_N;
      for (std::size_t k = 1; k < t.speedCount; ++k) {
        strongest_N = std::max(strongest_N, t.faster[k - 1][i].release_N);
        least_N = std::min(least_N, t.faster[k - 1][i].press_N);
      }
      ordered = ordered && strongest_N <= least_N;
    }
    CHECK(ordered);
    LoopSettings settings;
    settings.handle = handleOf(device);
    settings.handle.motorLag_s = lag_s;
    settings.sending.delay_s = delay_s;
    settings.finger.mass_kg = chance.between(0.003, 0.009);
    settings.finger.stiffness_N_per_mm = chance.between(0.2, 0.8);
    settings.finger.damping_Ns_per_mm = chance.between(0.002, 0.005);
    Presses press;
    press.to_mm = chance.between(4, 9);
    press.down_s = chance.between(0.03, 0.4);
    press.up_s = chance.between(0.03, 0.4);
    press.rest_s = chance.between(0.02, 0.15);
    ClosedLoop loop(prepared->program, settings, pressing(press));
    loop.runUntil(0.3 + press.down_s + press.rest_s + press.up_s + 0.3);
    INFO("run " << run << ", lowest balance " << loop.engine().lowestBalance_mJ() << " mJ");
    CHECK(loop.world().energy().finger_mJ >= -0.01);
  }
  INFO(felt << " felt, " << refused << " refused");
  CHECK(felt >= 100);
  CHECK(refused >= 20);
}

TEST_CASE("a family that would feed the handle is refused with the place, the speeds and the remedy",
          "[speeds]") {
  const auto sentence = [](const Button& button) {
    const auto prepared = playback::prepareForce(button, playback::simulatedDevice());
    return prepared ? std::string() : prepared.failure().sentence();
  };
  CHECK(sentence(family({dome(0.6, 0.3), dome(0.9, 0.25)}, {10, 100})).empty());
  // Pressed fast and released slowly.
  CHECK_THAT(sentence(family({dome(0.8, 0.6), dome(0.4, 0.1)}, {10, 100})),
             Catch::Contains("the release at 10 mm/s lies up to") &&
                 Catch::Contains("above the press at 100 mm/s") && Catch::Contains("mJ a press") &&
                 Catch::Contains("detent-graph convert makes one"));
  // Every press above every release, but weaker the faster: a damper turned round.
  CHECK_THAT(sentence(family({dome(1.1, 0.2), dome(0.8, 0.15)}, {10, 60})),
             Catch::Contains("from 10 to 60 mm/s the force drives the handle by 0.006 N·s/mm at 1.00 mm; "
                             "simulated device takes 0.0005"));
  // The button's own damping provides the lost energy.
  std::vector<ButtonState> states = family({dome(1.1, 0.2), dome(1.0, 0.15)}, {10, 60}).states();
  const auto damped = [&](double damping) {
    states[0].damping = {{0, damping}, {4, damping}};
    return sentence(*Button::fromStates("damped", states));
  };
  CHECK_THAT(damped(0), Catch::Contains("drives the handle"));
  CHECK(damped(0.0025).empty());
}

TEST_CASE("without a release curve the least of the presses is the release", "[speeds]") {
  const auto pressOnly = [](double peak_N) {
    return *Button::fromStates(
        "p", {ButtonState{
                 "", *ForceGraph::fromCurves(through({{0, 0.1}, {1, peak_N}, {4, 1.2}}), {}), {}, {}, {}}});
  };
  const auto prepared = playback::prepareForce(family({pressOnly(0.5), pressOnly(0.7)}, {10, 100}),
                                               playback::simulatedDevice());
  REQUIRE(prepared.ok());
  CHECK(prepared->summary.remarks.empty());
  const playback::ForceStateTable& t = prepared->program.states[0];
  REQUIRE(t.speedCount == 2);
  for (std::size_t i = 0; i < t.rowCount; i += 64) {
    CHECK(t.rows[i].release_N == t.rows[i].press_N);
    CHECK(t.faster[0][i].release_N == t.rows[i].release_N);
    CHECK(t.faster[0][i].press_N >= t.rows[i].press_N);
  }
}

TEST_CASE("the margin sees how force changes with speed, either way", "[speeds]") {
  playback::ForceDeviceProfile device = playback::simulatedDevice();
  device.largestSlope_N_per_mm = 80;
  const auto allowed = [&](const Button& button) {
    return playback::stabilityOf(button, device, 1000).least.allowed_N_per_mm;
  };
  const Button still = dome(0.8, 0.3);
  const double same = allowed(still);
  CHECK(allowed(family({still, still}, {10, 100})) == same);
  const Button damped = family({dome(0.8, 0.3), dome(1.2, 0.2)}, {10, 60}),
               driven = family({dome(0.8, 0.3), dome(0.77, 0.3)}, {10, 60});
  CHECK(allowed(driven) < 0.9 * same);
  CHECK(allowed(damped) <= same);
  CHECK(playback::stabilityOf(damped, device, 1000).anyFinger_N_per_mm <
        playback::stabilityOf(still, device, 1000).anyFinger_N_per_mm);
  const playback::SpeedDamping change = playback::speedDampingAt(damped.states()[0], 1);
  CHECK(change.most == Approx(0.4 / 50));
  CHECK(change.least == 0);
}
