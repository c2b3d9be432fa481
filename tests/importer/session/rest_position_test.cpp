// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/rest_position.h"

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::importer;

namespace {

StrokeCurve curve(std::vector<Knot> knots) {
  auto built = StrokeCurve::fromKnots(std::move(knots));
  REQUIRE(built);
  return *built;
}

}  // namespace

TEST_CASE("A curve that starts at rest stays as it is") {
  const StrokeCurve c = curve({{0, 0.1, 0, 1}, {1, 0.5, 1, 0}});
  CHECK(*startingAtRest(c) == c);
}

TEST_CASE("A piece that reaches left of 0 mm is squeezed and keeps its forces and its shape") {
  const StrokeCurve c = curve({{-0.5, 0.0, 0, 1}, {1.5, 0.8, 0.2, 0.2}, {4, 1, 0.1, 0}});
  const auto moved = startingAtRest(c);
  REQUIRE(moved);
  CHECK(moved->start_mm() == 0);
  for (const double share : {0.0, 0.25, 0.5, 0.9, 1.0}) {
    CHECK(moved->force_N(1.5 * share) == Approx(c.force_N(-0.5 + 2 * share)).margin(1e-12));
  }
  CHECK(moved->force_N(3) == Approx(c.force_N(3)));
}

TEST_CASE("A bottom-out that leans to the left becomes upright and keeps its height") {
  const auto moved = startingAtRest(
      curve({{-0.003, 0.0, 0, 10}, {-0.002, 0.1, 10, 10}, {-0.001, 0.3, 10, 10}, {2, 0.5, 0, 0}}));
  REQUIRE(moved);
  REQUIRE(moved->knots().size() == 3);
  CHECK(moved->forceBefore_N(0) == Approx(0.0));
  CHECK(moved->force_N(0) == Approx(0.3));
}

TEST_CASE("A curve that lies left of 0 mm altogether is refused") {
  const auto moved = startingAtRest(curve({{-2, 0, 0, 0}, {-1, 1, 0, 0}}));
  REQUIRE_FALSE(moved);
  CHECK(english(moved.failure().problem) == "the press starts at -2 mm, left of zero");
}
