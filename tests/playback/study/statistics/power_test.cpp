// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/power.h"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/study/statistics/paired_difference.h"

using namespace detent::playback;

TEST_CASE("power: the sign flips by sums are those that are printed, person by person") {
  StudyRandom random = randomSeededBy("power_test");
  for (int study = 0; study < 200; ++study) {
    std::vector<int> steps;
    std::vector<double> rates;
    for (std::size_t i = 0; i < 1 + drawBelow(random, 11); ++i) {
      steps.push_back(static_cast<int>(drawBelow(random, 11)) - 4);
      rates.push_back(steps.back() / 10.0);
    }
    CHECK(signFlipP(steps) == Approx(pairedDifference(rates).p).margin(1e-12));
  }
  CHECK(signFlipP({}) == 1);
  CHECK(signFlipP(std::vector<int>(8, 1)) == Approx(2.0 / 256));
  CHECK(signFlipP(std::vector<int>(40, 1)) == Approx(std::ldexp(2, -40)));
}

TEST_CASE("power: without a difference a study finds one at most as often as its level says") {
  const ErrorRates none{20, 0.2, 0};
  const double found =
      signFlipPower(9, [&](StudyRandom& random) { return drawErrorDifference(none, random); });
  CHECK(found < 0.05 + 3 * 0.004);
  CHECK(found > 0.02);  // the test is exact, its steps are coarse
}

TEST_CASE("power: fewer than six people find nothing, a great difference is found by all") {
  const auto always = [](StudyRandom&) { return 1; };
  CHECK(signFlipPower(5, always, 0.05, 100) == 0);
  CHECK(signFlipPower(6, always, 0.05, 100) == 1);
}

TEST_CASE("power: normal numbers are normal") {
  StudyRandom random = randomSeededBy("normal");
  double sum = 0, squares = 0, beyond = 0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const double x = drawNormal(random);
    sum += x;
    squares += x * x;
    beyond += std::fabs(x) > 1.959964 ? 1 : 0;
  }
  CHECK(sum / count == Approx(0).margin(0.015));
  CHECK(squares / count == Approx(1).margin(0.02));
  CHECK(beyond / count == Approx(0.05).margin(0.003));
}
