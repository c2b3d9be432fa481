// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/compare.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "model/edits.h"
#include "model/templates.h"

using namespace detent;

namespace {

GraphPolylines pressOnly(StrokePolyline line) { return {std::move(line), {}}; }

GraphDistance between(const GraphPolylines& a, const GraphPolylines& b) {
  const auto distance = compare(a, b);
  REQUIRE(distance.ok());
  return *distance;
}

}  // namespace

TEST_CASE("a graph has no distance from itself, however it is sampled") {
  const ForceGraph graph = tactileButton()->states()[0].graph;
  CHECK(between(polylinesOf(graph), polylinesOf(graph)).maxOfSpan < 1e-15);
  const auto inserted =
      editStroke(graph, Stroke::press, [](const StrokeCurve& c) { return insertKnot(c, 0.777); });
  REQUIRE(inserted.ok());
  CHECK(between(polylinesOf(graph), polylinesOf(*inserted)).maxOfSpan < 2e-4);
}

TEST_CASE("two parallel lines are as far apart as they are") {
  const auto d = between(pressOnly({{0, 0}, {4, 0}, {4, 2}}), pressOnly({{0, 0.2}, {4, 0.2}, {4, 2}}));
  CHECK(d.span_mm == 4);
  CHECK(d.span_N == 2);
  REQUIRE(d.press.has_value());
  CHECK(d.press->maxOfSpan == Approx(0.1));
  CHECK(d.press->max_N == Approx(0.2));
  CHECK(d.press->meanOfSpan == Approx(0.5 * (0.1 + 0.005) / 2 + 0.5 * (0.09 + 0.005) / 1.9).epsilon(0.01));
  // From the first: its horizontal is 0.2 N away, the lowest tenth of its rise 0.1 N on average. From the
  // second: the last tenth of its horizontal is nearer to the rise, which is a matter of displacement.
  CHECK(d.press->mean_N == Approx(0.5 * (0.2 + 0.1 * 0.1) / 2 + 0.5 * (0.2 * 0.9) / 1.9).epsilon(0.01));
}

TEST_CASE("a shifted vertical piece is a difference of displacement, not of force") {
  const auto d = between(pressOnly({{0, 0}, {4, 0}, {4, 2}}), pressOnly({{0, 0}, {4.04, 0}, {4.04, 2}}));
  CHECK(d.press->maxOfSpan == Approx(0.01).epsilon(1e-3));
  CHECK(d.press->max_mm == Approx(0.04).epsilon(1e-3));
  CHECK(d.press->mean_N < 2e-4);  // at the corner only
}

// Two curves that agree up to bottom-outs of 0.8 N and 0.3 N, 0.01 mm apart.
TEST_CASE("the largest difference before the bottom-out is known beside the one in it") {
  const auto ending = [](double at_mm, double top_N) {
    return ForceGraph::fromCurves(
               StrokeCurve::fromKnots({{0, 0.2, 0.1, 0.1}, {at_mm, 0.6, 0.1, 0}, {at_mm, top_N, 0, 0}})
                   .value(),
               {})
        .value();
  };
  const auto d = between(polylinesOf(ending(4, 1.4)), polylinesOf(ending(4.01, 0.9)));
  CHECK(d.press->maxOfSpan == Approx(0.5 / 1.2).epsilon(1e-3));
  CHECK(d.press->maxBeforeBottomOutOfSpan < 0.01 / 4);
  // Without a steep end all samples count.
  const auto whole = between(pressOnly({{0, 0}, {4, 1}}), pressOnly({{0, 0}, {4, 2}}));
  CHECK(whole.press->maxBeforeBottomOutOfSpan == whole.press->maxOfSpan);
}

TEST_CASE("the mean is symmetric and the order of a stroke's points does not matter") {
  const GraphPolylines a = pressOnly({{0, 0}, {2, 1}, {4, 1}, {4, 2}});
  const GraphPolylines b = pressOnly({{0, 0.1}, {2, 0.9}, {4, 1.2}, {4, 2}});
  const GraphPolylines reversed = pressOnly({{4, 2}, {4, 1.2}, {2, 0.9}, {0, 0.1}});
  CHECK(between(a, b).meanOfSpan == Approx(between(a, reversed).meanOfSpan).epsilon(1e-6));
}

TEST_CASE("a stroke a million million times as high as the first graph's span is compared as well") {
  const auto d =
      between(pressOnly({{0, 0}, {4, 1e-6}}), pressOnly({{0, 0}, {4, 1e6}}));  // 5e14 samples of 0.002
  CHECK(d.press->max_N == Approx(1e6).epsilon(1e-3));
  CHECK(d.press->meanOfSpan > 1e11);
}

TEST_CASE("single points and empty strokes") {
  const auto d = between(pressOnly({{0, 0}, {4, 2}}), pressOnly({{0, 0}}));
  CHECK(d.press->maxOfSpan == Approx(std::sqrt(2.0)));
  const auto nothing = compare(pressOnly({{0, 0}, {4, 2}}), {{}, {{0, 0}, {4, 2}}});
  REQUIRE_FALSE(nothing.ok());
  CHECK(nothing.failure().exitCode() == 2);
}

TEST_CASE("long strokes are searched exactly") {
  // A zigzag of 3,000 segments against a line: every distance is known.
  StrokePolyline zigzag;
  for (int i = 0; i <= 3000; ++i) zigzag.push_back({i / 3000.0, i % 2 == 0 ? 0.0 : 0.01});
  zigzag.push_back({1, 1});
  const auto d = between(pressOnly(zigzag), pressOnly({{0, 0}, {1, 0}, {1, 1}}));
  CHECK(d.press->max_N <= 0.01 + 1e-12);
  CHECK(d.press->maxOfSpan == Approx(0.01).epsilon(0.01));
}
