// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/identification/identify.h"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "playback/identification/force_record.h"
#include "tests/playback/identification/pressed_record.h"

namespace {

using namespace detent;
using namespace detent::playback;

constexpr double k = 0.3, b = 0.003;

/// A press and release of 4 mm at 1 kHz, 10 µm steps and 10 mN of noise.
ForceRecord pressRecord(double press_s, unsigned seed, double mass_kg = 0) {
  test::PressedRecord press;
  press.presses_s = {press_s};
  press.k = [](double) { return k; };
  press.b = [](double) { return b; };
  press.mass_kg = mass_kg;
  return test::recordOf(press, seed);
}

}  // namespace

TEST_CASE("identify: k within 2 % and b within 5 % from presses of 60 to 500 ms, with honest errors") {
  int kInside = 0, bInside = 0, runs = 0;
  for (const double press_s : {0.06, 0.1, 0.2, 0.5}) {
    double kMean = 0, bMean = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
      const Result<Identification> found = identify(pressRecord(press_s, seed));
      REQUIRE(found);
      REQUIRE(found->b_Ns_per_mm.size() == 1);
      const Estimate &ke = found->k_N_per_mm[0], &be = found->b_Ns_per_mm[0];
      INFO("press of " << press_s << " s, seed " << seed);
      CHECK(std::abs(ke.value / k - 1) <= 0.02);
      CHECK(std::abs(be.value / b - 1) <= 0.05 + (press_s > 0.4 ? 0.05 : 0));
      kMean += ke.value / 50;
      bMean += be.value / 50;
      kInside += std::abs(ke.value - k) <= ke.sigma ? 1 : 0;
      bInside += std::abs(be.value - b) <= be.sigma ? 1 : 0;
      ++runs;
    }
    CHECK(kMean == Approx(k).epsilon(0.005));
    CHECK(bMean == Approx(b).epsilon(0.02));
  }
  CHECK(kInside == Approx(0.68 * runs).margin(0.1 * runs));
  CHECK(bInside == Approx(0.68 * runs).margin(0.1 * runs));
}

TEST_CASE("identify: a finger's mass is found where there is one, and not where there is none") {
  const Result<Identification> with = identify(pressRecord(0.08, 1, 0.05));
  REQUIRE(with);
  REQUIRE(with->mass_kg);
  CHECK(with->mass_kg->value == Approx(0.05).epsilon(0.1));
  CHECK_FALSE(identify(pressRecord(0.08, 1))->mass_kg);
}

TEST_CASE(
    "identify: friction is found where there is some, b and its error stay true, and it is not where there "
    "is none") {
  int named = 0, bInside = 0, fInside = 0, runs = 0;
  for (const double friction_N : {0.02, 0.05, 0.2}) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      test::PressedRecord press;
      press.presses_s = {0.1, 0.3};
      press.k = [](double) { return k; };
      press.b = [](double) { return b; };
      press.friction_N = friction_N;
      const Result<Identification> found = identify(test::recordOf(press, seed));
      REQUIRE(found);
      REQUIRE(found->b_Ns_per_mm.size() == 1);
      REQUIRE(found->friction_N);
      INFO(friction_N << " N, seed " << seed << ": b " << found->b_Ns_per_mm[0].value << " +- "
                      << found->b_Ns_per_mm[0].sigma << ", f " << found->friction_N->value << " +- "
                      << found->friction_N->sigma);
      CHECK(found->b_Ns_per_mm[0].value == Approx(b).epsilon(0.08));
      CHECK(found->friction_N->value == Approx(friction_N).margin(0.004));
      bInside += std::abs(found->b_Ns_per_mm[0].value - b) <= 2 * found->b_Ns_per_mm[0].sigma ? 1 : 0;
      fInside += std::abs(found->friction_N->value - friction_N) <= 2 * found->friction_N->sigma ? 1 : 0;
      ++runs;
    }
  }
  for (unsigned seed = 0; seed < 100; ++seed) named += identify(pressRecord(0.2, seed))->friction_N ? 1 : 0;
  CHECK(named <= 2);
  INFO(bInside << " and " << fInside << " of " << runs << " within two standard errors");
  CHECK(bInside >= 0.85 * runs);
  CHECK(fInside >= 0.85 * runs);
}

TEST_CASE("identify: at constant speed b is not named, and the reason is") {
  for (const double direction : {1.0, -1.0}) {
    ForceRecord record;
    for (int i = 0; i < 800; ++i) {
      const double t = i * 0.001, x = direction > 0 ? 5 * t : 4 - 5 * t;
      record.time_s.push_back(t);
      record.displacement_mm.push_back(std::round(x / 0.01) * 0.01);
      record.force_N.push_back(k * x + 5 * direction * b);
    }
    const Result<Identification> found = identify(record);
    REQUIRE(found);
    CHECK(found->b_Ns_per_mm.empty());
    CHECK(found->doubt == DampingDoubt::constantSpeed);
    CHECK(found->k_N_per_mm[0].value == Approx(k).epsilon(0.02));
  }
}

TEST_CASE("identify: damping that drowns in the sensor's noise is not named, and how far it drowns is") {
  test::PressedRecord press;
  press.presses_s = {0.3};
  press.noise_N = 1;
  const Result<Identification> found = identify(test::recordOf(press, 1));
  REQUIRE(found);
  CHECK(found->b_Ns_per_mm.empty());
  CHECK(found->doubt == DampingDoubt::notCertain);
  CHECK(found->doubtFigure > IdentifySettings{}.largestSpread);
}

TEST_CASE("identify: records that are none are refused with the line") {
  CHECK(parseForceRecord("", "r.csv").failure().code == FailureCode::unreadableInput);
  CHECK(english(parseForceRecord("a,b\n", "r.csv").failure().place) == "line 1");
  const std::string header = "time_s,displacement_mm,force_N\n";
  for (const char* line : {"0,0\n", "0,x,1\n", "0,nan,1\n", "0,1,inf\n"}) {
    CHECK(english(parseForceRecord(header + line, "r.csv").failure().place) == "line 2");
  }
  CHECK(english(parseForceRecord(header + "0,0,0\n0,0,0\n", "r.csv").failure().place) == "line 3");
  CHECK(parseForceRecord("\xEF\xBB\xBF" + header + "# note\r\n0,0,0\r\n", "r.csv").ok());
  CHECK_FALSE(identify(*parseForceRecord(header + "0,0,0\n", "r.csv")));
  ForceRecord still = pressRecord(0.1, 0);
  for (double& x : still.displacement_mm) x = 1;
  CHECK_FALSE(identify(still));
}
