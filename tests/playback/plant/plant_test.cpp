// SPDX-License-Identifier: GPL-3.0-or-later
// The world that judges the force engine is judged itself: energy to rounding, friction that sticks and
// slips, lag, delay, fingers.

#include <cmath>
#include <complex>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/playback/plant/faults.h"
#include "tests/playback/plant/finger.h"
#include "tests/playback/plant/handle.h"
#include "tests/playback/plant/pty_device.h"
#include "tests/playback/plant/transport.h"

using namespace detent::test;

namespace {

void run(HandleAndFinger& world, double seconds, double command_N = 0) {
  const auto steps = static_cast<std::size_t>(std::lround(seconds / HandleAndFinger::step_s));
  for (std::size_t i = 0; i < steps; ++i) world.advance(command_N);
}

double audited(const HandleAndFinger& world) {
  const EnergyAccount& energy = world.energy();
  return std::abs(energy.residual_mJ()) / std::max(energy.turnover_mJ, 1e-6);
}

HandleSettings randomHandle(Chance& chance) {
  HandleSettings handle;
  handle.mass_kg = chance.between(0.005, 0.3);
  handle.damping_Ns_per_mm = chance.between(0, 0.004);
  handle.coulomb_N = chance.once(0.2) ? 0 : chance.between(0, 0.3);
  handle.static_N = handle.coulomb_N * chance.between(1, 1.6);
  handle.motorLag_s = chance.once(0.3) ? 0 : chance.between(1e-4, 5e-3);
  handle.lowest_mm = -3;
  handle.highest_mm = chance.between(4, 9);
  return handle;
}

}  // namespace

TEST_CASE("what is put into handle and finger is stored or lost, to a millionth", "[plant]") {
  Chance chance(11);
  for (int run = 0; run < 60; ++run) {
    Presses press;
    press.to_mm = chance.between(2, 20);
    press.down_s = chance.between(0.02, 0.3);
    press.push_N = chance.between(0, 6);
    FingerSettings finger;
    finger.mass_kg = chance.between(0.003, 0.009);
    finger.tremorShare = 0.02;
    HandleAndFinger world(randomHandle(chance), finger, pressing(press));
    double command_N = 0;
    for (int k = 0; k < 28000; ++k) {
      if (k % 40 == 0) command_N = chance.between(-2, 5);
      world.advance(command_N);
    }
    INFO("run " << run);
    const EnergyAccount& energy = world.energy();
    CHECK(audited(world) < 1e-6);
    CHECK(energy.viscous_mJ >= 0);
    CHECK(energy.friction_mJ >= 0);
    CHECK(energy.pulp_mJ >= 0);
    CHECK(energy.stops_mJ >= -1e-9);
  }
}

TEST_CASE("a handle that nobody drives never gains", "[plant]") {
  Chance chance(12);
  for (int run = 0; run < 40; ++run) {
    FingerSettings limp;
    limp.stiffness_N_per_mm = limp.damping_Ns_per_mm = 0;
    HandleAndFinger world(randomHandle(chance), limp, resting(0));
    world.throwTip(chance.between(0.1, 2), chance.between(50, 400));
    double before_mJ = 1e9;
    for (int k = 0; k < 8000; ++k) {
      world.advance(0);
      REQUIRE(world.energy().stored_mJ <= before_mJ + 1e-9);
      before_mJ = world.energy().stored_mJ;
    }
    CHECK(audited(world) < 1e-6);
  }
}

TEST_CASE("friction sticks below its static force, slides above, and stops where mechanics says", "[plant]") {
  HandleSettings handle;
  handle.damping_Ns_per_mm = 0;
  handle.coulomb_N = 0.1;
  handle.static_N = 0.15;
  HandleAndFinger world(handle, {}, resting(0));
  world.takeFingerAway();
  run(world, 0.5, -0.149);
  CHECK(world.position_mm() == 0);
  run(world, 0.01, -0.151);
  CHECK(world.velocity_mm_per_s() ==
        Approx(0.051 / 0.05 * 1000 * (0.01 - HandleAndFinger::step_s)).epsilon(1e-6));
  run(world, 0.05, -0.12);  // less than static, more than Coulomb: slides on
  const double speed_mm_per_s = world.velocity_mm_per_s(), from_mm = world.position_mm();
  CHECK(speed_mm_per_s > 20);
  run(world, 0.5);
  CHECK(world.velocity_mm_per_s() == 0);
  CHECK(world.position_mm() - from_mm ==
        Approx(0.05 * speed_mm_per_s * speed_mm_per_s / 1000 / (2 * 0.1)).epsilon(1e-6));
}

TEST_CASE("damping sets the last speed, lag the first force, saturation the largest", "[plant]") {
  HandleSettings handle;
  handle.coulomb_N = handle.static_N = 0;
  handle.damping_Ns_per_mm = 0.01;
  handle.motorLag_s = 0.004;
  handle.motorLimit_N = 1;
  HandleAndFinger world(handle, {}, resting(0));
  world.takeFingerAway();
  run(world, 0.004, -7);
  CHECK(world.motorForce_N() == Approx(-(1 - std::exp(-1.0))).epsilon(1e-9));
  run(world, 0.2, -7);
  CHECK(world.motorForce_N() == Approx(-1).epsilon(1e-9));
  CHECK(world.velocity_mm_per_s() == Approx(100).epsilon(1e-6));
}

TEST_CASE("messages arrive in order, late as requested, and as often lost as requested", "[plant]") {
  Transport<int> line({0.002, 0, 0}, 3);
  line.send(0, 7);
  CHECK_FALSE(line.newest(0.0019));
  CHECK(line.newest(0.002) == 7);
  Transport<int> rough({0.001, 0.003, 0.25}, 4);
  int last = -1, arrived = 0;
  for (int k = 0; k < 4000; ++k) {
    rough.send(k * 0.005, k);
    if (const auto message = rough.newest(k * 0.005 + 0.0049)) {
      CHECK(*message > last);
      last = *message;
      ++arrived;
    }
  }
  CHECK(arrived == Approx(3000).margin(120));
  CHECK(quantised_mm(1.2344, 0.01) == Approx(1.23));
}

TEST_CASE("fingers press, hold, slap and let go as fingers do", "[plant]") {
  HandleSettings table;  // a table: nothing gives
  table.lowest_mm = table.highest_mm = 0;
  FingerSettings finger;
  SECTION("a finger that rests carries its weight, trembling by 2 % at 9.5 Hz") {
    finger.tremorShare = 0.02;
    HandleAndFinger world(table, finger, resting(0.8));
    run(world, 1);
    std::complex<double> tremor{};
    double mean_N = 0;
    const int count = 80000;
    for (int k = 0; k < count; ++k) {
      world.advance(0);
      mean_N += world.fingerForce_N() / count;
      tremor += world.fingerForce_N() * std::polar(2.0 / count, -2 * 3.14159265358979 * 9.5 * world.time_s());
    }
    // The joint aims at the table's height, so the pulp's compression takes a part of the 0.8 N.
    const double depth_mm = std::log1p(mean_N / finger.pulpForce_N) / finger.pulpRate_per_mm;
    CHECK(mean_N + finger.stiffness_N_per_mm * depth_mm == Approx(0.8).epsilon(0.01));
    CHECK(std::abs(tremor) / mean_N == Approx(0.02).epsilon(0.2));
  }
  SECTION("a slap at 200 mm/s meets the table with newtons for some milliseconds") {
    HandleAndFinger world(table, finger, resting(0.5));
    world.throwTip(1, 200);
    double peak_N = 0;
    for (int k = 0; k < 2000; ++k) {
      world.advance(0);
      peak_N = std::max(peak_N, world.fingerForce_N());
    }
    CHECK(peak_N > 0.5);
    CHECK(peak_N < 6);
  }
  SECTION("one that lets go is gone within 0.2 s") {
    HandleAndFinger world(table, finger, lettingGo(2, 1, 0.5));
    run(world, 0.5);
    CHECK(world.fingerForce_N() > 0.8);
    run(world, 0.2);
    CHECK(world.fingerForce_N() == 0);
  }
  SECTION("a press that takes 0.1 s has pushed a free handle to its stop and left it") {
    HandleSettings free;
    free.highest_mm = 4;
    HandleAndFinger world(free, finger, pressing({}));
    run(world, 0.55);
    CHECK(world.position_mm() == Approx(4).margin(0.2));
    run(world, 0.6);
    CHECK(world.fingerForce_N() == 0);
  }
}

TEST_CASE("faults do to readings what their names say", "[plant]") {
  FaultyEncoder encoder({{FaultKind::silent, 2, 4, 0},
                         {FaultKind::notFinite, 5, 7, 0},
                         {FaultKind::stuck, 10, 12, 0},
                         {FaultKind::flicker, 14, 16, 1.5},
                         {FaultKind::jump, 20, 0, 50}});
  for (std::int64_t k = 0; k < 30; ++k) {
    const auto reading = encoder.reading(k, 0.1 * static_cast<double>(k));
    INFO("step " << k);
    CHECK(reading.fresh == (k != 2 && k != 3));
    CHECK(std::isfinite(reading.position_mm) == (k != 5 && k != 6));
    if (k == 11) CHECK(reading.position_mm == Approx(1.0));
    if (k == 14) CHECK(reading.position_mm == Approx(2.9));
    if (k == 29) CHECK(reading.position_mm == Approx(52.9));
  }
}

TEST_CASE("of repeated runs the first fine one counts, else one with a punctual device, else none",
          "[plant]") {
  struct Run {
    bool fine = false;
    Witness device{};
  };
  const Run fine{true, {}}, wrong{}, late{false, {.punctual = false}},
      strong{false, {.punctual = false, .tooStrong = true}};
  struct Row {
    std::vector<Run> runs;
    std::size_t made;
    bool fine, judged, tooStrong;
  };
  const std::vector<Row> rows = {{{fine}, 1, true, true, false},
                                 {{late, late, fine}, 3, true, true, false},
                                 {{wrong, fine}, 2, true, true, false},
                                 {{late, strong, fine}, 2, false, true, true},
                                 {{wrong, wrong, wrong, wrong, wrong}, 5, false, true, false},
                                 {{late, wrong, late, late, late}, 5, false, true, false},
                                 {{late, late, late, late, late}, 5, false, false, false}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    std::size_t made = 0;
    const Run run = undisturbed([&] { return row.runs.at(made++); }, [](const Run& r) { return r.fine; });
    INFO("row " << i);
    CHECK(made == row.made);
    CHECK(run.fine == row.fine);
    CHECK(run.device.judged == row.judged);
    CHECK(run.device.tooStrong == row.tooStrong);
  }
}
