// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/split_strokes.h"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::importer;

namespace {

std::vector<CurvePoint> sweep(std::vector<double> turns, double step = 0.01, double jitter = 0) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-jitter, jitter);
  std::vector<CurvePoint> run;
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    const int steps = static_cast<int>(std::lround(std::abs(turns[k + 1] - turns[k]) / step));
    for (int i = 0; i < steps; ++i) {
      const double x = turns[k] + (turns[k + 1] - turns[k]) * i / steps;
      run.push_back({x + noise(random), 10 * x});
    }
  }
  run.push_back({turns.back(), 10 * turns.back()});
  return run;
}

}  // namespace

TEST_CASE("a run is cut where the displacement turns") {
  const auto run = sweep({0, 4, 0}, 0.01, 0.004);
  const auto spans = spansOf(run, 0.2);
  REQUIRE(spans.size() == 2);
  CHECK(spans[0].stroke == Stroke::press);
  CHECK(spans[0].from == 0);
  CHECK(spans[0].to == spans[1].from);
  CHECK(run[spans[0].to].displacement_mm == Approx(4).margin(0.01));
  CHECK(spans[1].stroke == Stroke::release);
  CHECK(run[spans[1].to].displacement_mm == Approx(0).margin(0.01));
}

TEST_CASE("noise comes out of second differences, steps and slopes do not count") {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.02);
  std::vector<double> values;
  for (int i = 0; i < 4000; ++i) values.push_back((i > 2000 ? 5.0 : 0.0) + 1e-3 * i + noise(random));
  CHECK(noiseOf(values) == Approx(0.02).epsilon(0.1));
  std::vector<double> quantised;
  for (int i = 0; i < 1000; ++i) quantised.push_back(std::floor(i / 10.0) * 0.1);
  CHECK(noiseOf(quantised) == Approx(0.1 / std::sqrt(12.0)));
}

TEST_CASE("fewer than 16 values cannot tell noise from shape") {
  CHECK(noiseOf({0.3, 0.4, 0.7, 0.5, 0.6, 0.8}) == 0);
  CHECK(noiseOf({}) == 0);
}

TEST_CASE("noise has the unit of its values") {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0, 0.02);
  std::vector<double> values, small;
  for (int i = 0; i < 400; ++i) values.push_back(1e-3 * i + noise(random));
  for (const double value : values) small.push_back(value * 0x1p-50);
  CHECK(noiseOf(small) == noiseOf(values) * 0x1p-50);
}

TEST_CASE("a press ends before the handle dwells at the bottom and the force relaxes") {
  std::vector<CurvePoint> press;
  for (int i = 0; i <= 400; ++i) press.push_back({0.01 * i, 0.3 + 0.001 * i});
  const std::vector<CurvePoint> whole = press;
  SECTION("no dwell: nothing goes") { endBeforeDwell(press, 0.003, 0.001); }
  SECTION("a dwell goes, also where its place jitters") {
    for (int i = 1; i < 100; ++i) press.push_back({4 + 0.003 * std::sin(i), 0.7 - 0.001 * i});
    endBeforeDwell(press, 0.003, 0.001);
  }
  SECTION("the first sample of the release, at the same place") {
    press.push_back({4, 0.62});
    endBeforeDwell(press, 0.003, 0.001);
  }
  CHECK(press == whole);
}

TEST_CASE("a vertical rise at the end of a press is no dwell") {
  std::vector<CurvePoint> press;
  for (int i = 0; i <= 400; ++i) press.push_back({0.01 * i, 0.3 + 0.001 * i});
  for (int i = 0; i < 100; ++i) press.push_back({4.0001 + 0.0001 * i, 0.7 + 0.01 * i});
  const std::vector<CurvePoint> whole = press;
  endBeforeDwell(press, 0.003, 0.001);
  CHECK(press == whole);
}

TEST_CASE("rows in even steps are no rounding: the last digit decides") {
  std::vector<double> positions;
  for (int i = 0; i < 80; ++i) positions.push_back(0.05 * i);
  CHECK(noiseOf(positions) == Approx(0.05 / std::sqrt(12.0)));
  CHECK(noiseOf(positions, 0.001) == Approx(0.001 / std::sqrt(12.0)));
}

TEST_CASE("before contact the force is flat, early and small") {
  std::vector<CurvePoint> press;
  for (int i = 0; i <= 400; ++i) {
    const double x = 0.01 * i;
    press.push_back({x, x < 0.5 ? 0.02 : 0.02 + 0.4 * (x - 0.5)});
  }
  const auto before = beforeContact(press, 1e-3);
  REQUIRE(before);
  CHECK(before->force_N == Approx(0.02));
  CHECK(before->contact_mm == Approx(0.5).margin(0.011));
  for (CurvePoint& p : press) p.force_N = 0.5;
  CHECK_FALSE(beforeContact(press, 1e-3));
  for (CurvePoint& p : press) p.force_N = 0.3 + 0.1 * p.displacement_mm;
  CHECK_FALSE(beforeContact(press, 1e-3));
}

TEST_CASE("the steep start of a press in contact is no offset, however noisy the gauge is") {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0, 0.02);
  std::vector<CurvePoint> press;
  for (int i = 0; i <= 400; ++i) {
    const double x = 0.01 * i;
    press.push_back({x, (x < 0.4 ? 1.2 * x : 0.48 + 0.1 * (x - 0.4)) + noise(random)});
  }
  CHECK_FALSE(beforeContact(press, 0.02));
}
