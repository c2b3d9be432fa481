// SPDX-License-Identifier: GPL-3.0-or-later
// Labels against ticks: consensus, exact places, lines rounded to whole pixels.

#include "importer/axes/progression.h"

#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "importer/axes/snapped_lines.h"

using namespace detent::importer;

namespace {

struct DrawnAxis {
  std::vector<LabelPlace> labels;
  std::vector<GridLine> ticks;
};

/// Labels `values` at start + k·pitch, each a few pixels off its tick.
DrawnAxis drawnAxis(const std::vector<std::string>& texts, double start, double pitch, bool spans = true) {
  DrawnAxis axis;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const double at = start + static_cast<double>(k) * pitch;
    axis.ticks.push_back({at, 1, spans});
    if (texts[k].empty()) continue;
    axis.labels.push_back({at + (k % 2 ? 1.5 : -1.0), 6, numberReadings(texts[k])});
  }
  return axis;
}

}  // namespace

TEST_CASE("all labels right: exact") {
  const auto axis = drawnAxis({"0", "0.5", "1", "1.5", "2"}, 100.25, 80.1);
  const auto p = fitProgression(axis.labels, axis.ticks, true);
  REQUIRE(p);
  CHECK(p->labels == 5);
  CHECK(p->fromTicks);
  CHECK(p->value(100.25) == Approx(0).margin(1e-9));
  CHECK(p->value(100.25 + 4 * 80.1) == Approx(2));
  CHECK(p->residual_px == Approx(0).margin(1e-9));
  CHECK(p->step == Approx(0.5));
}

TEST_CASE("one misread label changes nothing") {
  const std::vector<std::string> right{"0", "20", "40", "60", "80", "100", "120"};
  const auto axis = drawnAxis(right, 60, 70);
  const auto truth = fitProgression(axis.labels, axis.ticks, true);
  REQUIRE(truth);
  REQUIRE(rc::check("misread", [&] {
    auto texts = right;
    const auto at = *rc::gen::inRange<std::size_t>(0, right.size());
    texts[at] = std::to_string(*rc::gen::inRange(0, 999));
    const auto bad = drawnAxis(texts, 60, 70);
    const auto p = fitProgression(bad.labels, bad.ticks, true);
    RC_ASSERT(p.has_value());
    RC_ASSERT(p->offset == Approx(truth->offset).margin(1e-9));
    RC_ASSERT(p->perPx == Approx(truth->perPx));
  }));
}

TEST_CASE("lost decimal points are put back by their neighbours") {
  const auto axis = drawnAxis({"0", "05", "1", "15", "2", "25", "3"}, 50, 90);
  const auto p = fitProgression(axis.labels, axis.ticks, true);
  REQUIRE(p);
  CHECK(p->labels == 7);
  CHECK(p->value(50 + 6 * 90) == Approx(3));
}

TEST_CASE("labels at every second line, minor lines between") {
  const auto axis = drawnAxis({"0", "", "1", "", "2", "", "3"}, 40, 55.5);
  const auto p = fitProgression(axis.labels, axis.ticks, true);
  REQUIRE(p);
  CHECK(p->ticks == 7);
  CHECK(p->substep == Approx(0.5));
  CHECK(p->value(40 + 5 * 55.5) == Approx(2.5));
}

TEST_CASE("a last label off the grid is left out") {
  auto axis = drawnAxis({"0", "", "1", "", "2", "", "3", "3.6"}, 40, 50);  // the line is at 3.5
  const auto p = fitProgression(axis.labels, axis.ticks, true);
  REQUIRE(p);
  CHECK(p->value(40 + 7 * 50) == Approx(3.5));
  CHECK(p->reading.back() == -1);
}

TEST_CASE("values fall downwards on a y axis") {
  const auto axis = drawnAxis({"120", "100", "80", "60", "40", "20", "0"}, 30, 66);
  const auto p = fitProgression(axis.labels, axis.ticks, false);
  REQUIRE(p);
  CHECK(p->perPx < 0);
  CHECK(p->value(30) == Approx(120));
  // Upwards only repaired readings could be strung together: few of them.
  const auto upwards = fitProgression(axis.labels, axis.ticks, true);
  if (upwards) CHECK(upwards->labels <= 3);
}

TEST_CASE("a zero in the corner that stands beside its tick does not bend the axis") {
  auto axis = drawnAxis({"", "1", "2", "3", "4"}, 100, 120);
  axis.labels.insert(axis.labels.begin(), {80, 6, numberReadings("0")});
  const auto p = fitProgression(axis.labels, axis.ticks, true);
  REQUIRE(p);
  CHECK(p->value(100) == Approx(0).margin(1e-6));
}

TEST_CASE("without ticks label centres do, and it is said") {
  auto axis = drawnAxis({"0", "1", "2", "3"}, 100, 100);
  const auto p = fitProgression(axis.labels, {}, true);
  REQUIRE(p);
  CHECK_FALSE(p->fromTicks);
  CHECK(p->value(400) == Approx(3).margin(0.05));
}

TEST_CASE("a label that alone would need a far finer step is misread") {
  const auto axis = drawnAxis({"0.4", "50", "100", "150"}, 60, 90);  // a zero and its tick
  const auto p = fitProgression(axis.labels, axis.ticks, true);
  REQUIRE(p);
  CHECK(p->labels == 3);
  CHECK(p->step == Approx(50));
  CHECK(p->value(60) == Approx(0).margin(1e-9));
  const auto fine = drawnAxis({"0", "0.25", "0.5", "0.75", "1"}, 60, 90);
  CHECK(fitProgression(fine.labels, fine.ticks, true)->labels == 5);
}

TEST_CASE("numbers that count by one same number but for their rounding are even") {
  const auto axis = drawnAxis({"0", "0.2137", "0.4273", "0.6410", "0.8546"}, 60, 90);
  const auto p = fitProgression(axis.labels, axis.ticks, true);
  REQUIRE(p);
  CHECK(p->labels == 5);
  CHECK(p->step == Approx(0.21365));
  CHECK(p->value(60 + 4 * 90) == Approx(0.8546).epsilon(1e-4));
  // Even from line to line, and not by their numbers: each may be another scale's.
  const auto uneven = drawnAxis({"0", "0.2137", "0.4273", "0.6428", "0.8546"}, 60, 90);
  const auto q = fitProgression(uneven.labels, uneven.ticks, true);
  REQUIRE(q);
  CHECK(q->step < 0.001);
  // Numbers so coarse that many scales fit evenly.
  const auto coarse = drawnAxis({"0", "3", "5", "8", "10"}, 60, 90);
  const auto c = fitProgression(coarse.labels, coarse.ticks, true);
  CHECK((!c || c->step == Approx(1) || c->labels < 5));
}

TEST_CASE("a stray mark near a line does not move it") {
  auto axis = drawnAxis({"0", "1", "2", "3", "4"}, 100, 120);
  axis.ticks.insert(axis.ticks.begin() + 1, {102.6, 2, false});
  axis.labels[0].center_px = 102;
  const auto p = fitProgression(axis.labels, axis.ticks, true);
  REQUIRE(p);
  CHECK(p->value(100) == Approx(0).margin(1e-6));
}

TEST_CASE("a line that is none, beside one of few, does not bend an even row of labels") {
  // 120 at 133 px to 20 at 268: one gridline at 80, the axis at 0, and a curve that turns a little above 20.
  DrawnAxis axis;
  for (int k = 0; k < 6; ++k)
    axis.labels.push_back({133.0 + 27 * k, 6, numberReadings(std::to_string(120 - 20 * k))});
  const double gridline = 133 + 2 * 27, turn = 133 + 5 * 27 - 4, axisLine = 133 + 6 * 27;
  axis.ticks = {{gridline, 1, true}, {turn, 1, false}, {axisLine, 1, true}};
  const auto p = fitProgression(axis.labels, axis.ticks, false);
  REQUIRE(p);
  CHECK(p->labels == 6);
  CHECK(p->fromTicks);
  CHECK(p->value(axisLine) == Approx(0).margin(0.01));
  CHECK(p->value(gridline) == Approx(80).margin(0.01));

  SECTION("where no line is on the row's scale the labels stand for it") {
    axis.ticks = {{gridline - 2.5, 1, true}, {turn + 6.5, 1, false}};
    const auto alone = fitProgression(axis.labels, axis.ticks, false);
    REQUIRE(alone);
    CHECK_FALSE(alone->fromTicks);
    CHECK(alone->value(axisLine) == Approx(0).margin(0.01));
  }
}

TEST_CASE("numbers without order give nothing, or little") {
  std::mt19937 random(3);
  for (int round = 0; round < 50; ++round) {
    std::vector<std::string> texts;
    for (int k = 0; k < 6; ++k) texts.push_back(std::to_string(100 + random() % 899));
    const auto axis = drawnAxis(texts, 50, 70);
    const auto p = fitProgression(axis.labels, axis.ticks, true);
    if (p) CHECK(p->labels <= 3);
  }
}

TEST_CASE("nothing to fit") {
  CHECK_FALSE(fitProgression({}, {}, true));
  CHECK_FALSE(fitProgression({{10, 5, numberReadings("5")}}, {{10, 1, true}}, true));
  const auto same = drawnAxis({"7", "7", "7"}, 10, 50);
  CHECK_FALSE(fitProgression(same.labels, same.ticks, true));
}

TEST_CASE("lines rounded to whole pixels: closer than least squares") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> start(50, 60), pitch(40, 90);
  double worst = 0, mean = 0, squares = 0;
  constexpr int rounds = 400, lines = 9;
  for (int round = 0; round < rounds; ++round) {
    const double a = start(random), b = pitch(random);
    std::vector<std::pair<double, double>> rounded;
    double n = 0, sx = 0, sv = 0, svv = 0, sxv = 0;
    for (int k = 0; k < lines; ++k) {
      const double x = std::round(a + b * k);
      rounded.emplace_back(x, k);
      n += 1, sx += x, sv += k, svv += k * k, sxv += x * k;
    }
    const auto line = throughRoundedLines(rounded);
    REQUIRE(line);
    const double off = std::abs(-line->offset / line->perPx - a);
    const double slope = (n * sxv - sx * sv) / (n * svv - sv * sv);
    worst = std::max(worst, off);
    mean += off / rounds;
    squares += std::abs((sx - slope * sv) / n - a) / rounds;
  }
  CHECK(worst < 0.5);
  CHECK(mean < 0.14);
  CHECK(mean < squares);
}

TEST_CASE("lines that are not rounded are left to least squares") {
  CHECK_FALSE(throughRoundedLines({{10.2, 0}, {20.5, 1}, {30.8, 2}}));
  CHECK_FALSE(throughRoundedLines({{10, 0}, {20, 1}}));
  CHECK_FALSE(throughRoundedLines({{10, 0}, {20, 1}, {40, 2}}));  // no even spacing rounds to these values
}
