// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/stroke_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "tests/model/property.h"
#include "tests/model/random_curves.h"

using namespace detent;
using detent::tests::anyCurve;
using detent::tests::between;
using detent::tests::holdsAlways;

namespace {

StrokeCurve curveOf(std::vector<Knot> knots) {
  auto curve = StrokeCurve::fromKnots(std::move(knots));
  REQUIRE(curve.ok());
  return *curve;
}

// x^3 - 2x^2 + 3 on [0, 2]: minimum at 4/3.
StrokeCurve knownCubic() { return curveOf({{0, 3, 0, 0}, {2, 3, 4, 4}}); }

void requireCurveRefusal(std::vector<Knot> knots, const std::string& part) {
  const auto curve = StrokeCurve::fromKnots(std::move(knots));
  REQUIRE_FALSE(curve.ok());
  CHECK_THAT(curve.failure().sentence(), Catch::Contains(part));
  CHECK_FALSE(curve.failure().remedies.empty());
}

constexpr double curveNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("a cubic piece is evaluated exactly") {
  const StrokeCurve curve = knownCubic();
  for (double x : {0.0, 0.3, 1.0, 4.0 / 3, 1.9, 2.0}) {
    CHECK(curve.force_N(x) == Approx(x * x * x - 2 * x * x + 3).epsilon(1e-14));
    CHECK(curve.slope_N_per_mm(x) == Approx(3 * x * x - 4 * x).margin(1e-13));
  }
  CHECK(curve.area_mJ(0, 2) == Approx(4 - 16.0 / 3 + 6).epsilon(1e-14));
  CHECK(curve.area_mJ(1.5, 0.5) == -curve.area_mJ(0.5, 1.5));
  REQUIRE(curve.localMinima().size() == 1);
  CHECK(curve.localMinima()[0].displacement_mm == Approx(4.0 / 3).epsilon(1e-14));
  CHECK(curve.localMaxima().empty());
  CHECK(curve.forceRange_N().first == Approx(3 - 32.0 / 27).epsilon(1e-14));
}

TEST_CASE("outside the curve the nearest end speaks, with slope 0") {
  const StrokeCurve curve = knownCubic();
  CHECK(curve.force_N(-1) == 3);
  CHECK(curve.force_N(1e300) == 3);
  CHECK(curve.slope_N_per_mm(2.1) == 0);
  CHECK(curve.slope_N_per_mm(2) == 4);
  CHECK(curve.area_mJ(-5, 0) == 0);
  CHECK(curve.area_mJ(-5, 7) == curve.area_mJ(0, 2));
}

TEST_CASE("vertical pieces: both sides are known, and inversion stands still on them") {
  const StrokeCurve curve = curveOf({{0, 0, 1, 1}, {1, 1, 1, 9}, {1, 5, 9, 0}, {2, 5, 0, 0}});
  CHECK(curve.forceBefore_N(1) == 1);
  CHECK(curve.force_N(1) == 5);
  CHECK(curve.slopeBefore_N_per_mm(1) == 1);
  CHECK(curve.slope_N_per_mm(1) == 0);
  CHECK(curve.area_mJ(0, 2) == Approx(5.5));
  const auto stretches = curve.monotoneStretches();
  REQUIRE(stretches.size() == 3);
  CHECK(stretches[1].from_mm == 1);
  CHECK(stretches[1].to_mm == 1);
  CHECK(stretches[1].direction == 1);
  CHECK(stretches[2].direction == 0);
  CHECK(curve.displacementIn(stretches[1], 3) == 1);
  CHECK(curve.displacementsAt(3) == std::vector<double>{1});
  CHECK(curve.displacementsAt(5) == std::vector<double>{1, 2});
  CHECK(curve.displacementsAt(6).empty());
}

TEST_CASE("a flat top has its maximum in its middle; its two ends carry the force") {
  const StrokeCurve curve = curveOf({{0, 0, 1, 1}, {1, 1, 1, 0}, {2, 1, 0, -1}, {3, 0, -1, 0}});
  REQUIRE(curve.localMaxima().size() == 1);
  CHECK(curve.localMaxima()[0] == CurvePoint{1.5, 1});
  CHECK(curve.displacementsAt(1) == std::vector<double>{1, 2});
}

TEST_CASE("a vertical piece down makes a maximum at its upper end") {
  const StrokeCurve curve = curveOf({{0, 0, 1, 1}, {1, 1, 1, 0}, {1, 0.2, 0, 1}, {2, 1.2, 1, 0}});
  REQUIRE(curve.localMaxima().size() == 1);
  CHECK(curve.localMaxima()[0] == CurvePoint{1, 1});
  REQUIRE(curve.localMinima().size() == 1);
  CHECK(curve.localMinima()[0] == CurvePoint{1, 0.2});
}

TEST_CASE("an inflection is no extremum") {
  // x^3 around 0: derivative touches 0.
  const StrokeCurve cubic = curveOf({{0, -1, 3, 3}, {2, 1, 3, 3}});
  CHECK(cubic.monotoneStretches().size() == 1);
  // A knot with slope 0 between two rising pieces.
  const StrokeCurve knot = curveOf({{0, 0, 1, 1}, {1, 1, 0, 0}, {2, 2, 1, 1}});
  CHECK(knot.monotoneStretches().size() == 1);
}

TEST_CASE("what is no curve is refused with its rule, place and value") {
  requireCurveRefusal({}, "at least 2");
  requireCurveRefusal({{0, 1, 0, 0}}, "has 1 points");
  requireCurveRefusal({{0, 1, 0, 0}, {0, 2, 0, 0}}, "no travel");
  requireCurveRefusal({{0, 1, 0, 0}, {1, curveNotANumber, 0, 0}}, "curve point 2: force is nan");
  requireCurveRefusal({{0, 1, 0, infinity}, {1, 1, 0, 0}}, "curve point 1: slope after is inf");
  requireCurveRefusal({{0, 1, 0, 0}, {2, 1, 0, 0}, {1.5, 1, 0, 0}}, "1.5 mm lies before");
  requireCurveRefusal({{0, 1, 0, 0}, {1, 1, 0, 0}, {1, 2, 0, 0}, {1, 3, 0, 0}}, "third point");
  requireCurveRefusal({{0, 0, 0, 0}, {1e-310, 1e6, 0, 0}, {1, 0, 0, 0}}, "piece 1");
  requireCurveRefusal({{0, 0, 0, 1e308}, {1, 1e6, 1e308, 0}}, "is too steep");
  requireCurveRefusal(std::vector<Knot>(StrokeCurve::maxKnots + 1), "at most 100000 are allowed");
}

TEST_CASE("extremes: tiny travel, tiny and huge forces") {
  for (double travel : {1e-6, 1e-3, 4.0, 1e5})
    for (double force : {1e-6, 1.0, 1e6}) {
      const double slope = force / travel;
      // Up to force at 1/3, down to 0.4 force at 2/3, up to force at the end.
      const StrokeCurve curve = curveOf({{0, 0, 0, 3 * slope},
                                         {travel / 3, force, 0, 0},
                                         {2 * travel / 3, 0.4 * force, 0, 0},
                                         {travel, force, 3 * slope, 0}});
      REQUIRE(curve.localMaxima().size() == 1);
      CHECK(curve.localMaxima()[0] == CurvePoint{travel / 3, force});
      REQUIRE(curve.localMinima().size() == 1);
      const auto at = curve.displacementsAt(0.7 * force);
      REQUIRE(at.size() == 3);
      for (double x : at) CHECK(curve.force_N(x) == Approx(0.7 * force).epsilon(1e-13));
      CHECK(curve.area_mJ(0, travel) > 0.5 * force * travel * 0.8);
    }
}

TEST_CASE("1,000 knots: every turn is found, the area is the sum of its parts") {
  std::vector<Knot> knots;
  for (int i = 0; i < 1000; ++i) knots.push_back({i * 0.004, i % 2 == 0 ? 0.2 : 0.8, 0, 0});
  const StrokeCurve curve = curveOf(knots);
  CHECK(curve.monotoneStretches().size() == 999);
  CHECK(curve.localMaxima().size() == 499);
  CHECK(curve.displacementsAt(0.5).size() == 999);
  CHECK(curve.area_mJ(0, curve.end_mm()) == Approx(0.5 * 0.004 * 999).epsilon(1e-12));
}

TEST_CASE("points are met and nothing overshoots them") {
  holdsAlways("throughPoints is monotone between points", [] {
    std::vector<CurvePoint> points{{0, between(0, 1)}};
    const int count = *rc::gen::inRange(2, 20);
    for (int i = 1; i < count; ++i)
      points.push_back({points.back().displacement_mm + between(0.001, 1), between(0, 1)});
    const auto curve = StrokeCurve::throughPoints(points);
    RC_ASSERT(curve.ok());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      RC_ASSERT(curve->force_N(points[i].displacement_mm) == points[i].force_N);
      const auto [low, high] = std::minmax({points[i].force_N, points[i + 1].force_N});
      for (int k = 0; k <= 16; ++k) {
        const double x = points[i].displacement_mm +
                         k / 16.0 * (points[i + 1].displacement_mm - points[i].displacement_mm);
        RC_ASSERT(curve->force_N(x) >= low - 1e-12);
        RC_ASSERT(curve->force_N(x) <= high + 1e-12);
      }
    }
  });
}

TEST_CASE("stretches cover the curve, touch, and are monotone") {
  holdsAlways("monotoneStretches", [] {
    const StrokeCurve curve = anyCurve();
    const auto stretches = curve.monotoneStretches();
    RC_ASSERT(!stretches.empty());
    RC_ASSERT(stretches.front().from_mm == curve.start_mm());
    RC_ASSERT(stretches.back().to_mm == curve.end_mm());
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const MonotoneStretch& s = stretches[i];
      if (i > 0) {
        RC_ASSERT(s.from_mm == stretches[i - 1].to_mm);
        RC_ASSERT(s.fromForce_N == stretches[i - 1].toForce_N);
      }
      RC_ASSERT((s.toForce_N > s.fromForce_N) == (s.direction > 0));
      RC_ASSERT((s.toForce_N < s.fromForce_N) == (s.direction < 0));
      double last = s.fromForce_N;
      for (int k = 1; k < 40 && s.from_mm < s.to_mm; ++k) {
        const double force = curve.force_N(s.from_mm + (s.to_mm - s.from_mm) * k / 40);
        RC_ASSERT(s.direction * (force - last) >= -1e-12);
        last = force;
      }
    }
  });
}

TEST_CASE("inversion undoes evaluation on every stretch") {
  holdsAlways("displacementIn", [] {
    const StrokeCurve curve = anyCurve();
    for (const MonotoneStretch& s : curve.monotoneStretches()) {
      if (s.direction == 0 || s.from_mm == s.to_mm) continue;
      const double force = s.fromForce_N + (s.toForce_N - s.fromForce_N) * between(0, 1);
      const double x = curve.displacementIn(s, force);
      RC_ASSERT(x >= s.from_mm);
      RC_ASSERT(x <= s.to_mm);
      // Exact to the rounding of x: the force between its two neighbours.
      const double ulp = 4e-16 * std::max(1.0, curve.end_mm());
      const double slope = std::abs(curve.slope_N_per_mm(x)) + 100 * std::sqrt(ulp);
      RC_ASSERT(std::abs(curve.force_N(x) - force) <= 4e-15 + 4 * ulp * slope);
      RC_ASSERT(curve.displacementIn(s, s.fromForce_N) == s.from_mm);
      RC_ASSERT(curve.displacementIn(s, s.toForce_N) == s.to_mm);
      RC_ASSERT(curve.displacementIn(s, s.direction * 1e9) == s.to_mm);
    }
  });
}

TEST_CASE("the number of crossings is the number of sign changes of a fine scan, or more") {
  holdsAlways("displacementsAt", [] {
    const StrokeCurve curve = anyCurve();
    const double level = between(-0.5, 2.5);
    const auto found = curve.displacementsAt(level);
    RC_ASSERT(std::is_sorted(found.begin(), found.end()));
    for (double x : found) {
      const auto [low, high] = std::minmax({curve.forceBefore_N(x), curve.force_N(x)});
      RC_ASSERT(level >= low - 1e-9);
      RC_ASSERT(level <= high + 1e-9);
    }
    std::size_t changes = 0;
    bool above = curve.knots().front().force_N > level;
    for (int i = 0; i <= 4000; ++i) {
      const bool now = curve.force_N(curve.start_mm() + curve.travel_mm() * i / 4000) > level;
      changes += now != above;
      above = now;
    }
    RC_ASSERT(found.size() >= changes);
  });
}

TEST_CASE("extrema are extrema, and bound the range") {
  holdsAlways("localMaxima, localMinima, forceRange_N", [] {
    const StrokeCurve curve = anyCurve();
    const auto [low, high] = curve.forceRange_N();
    for (int i = 0; i <= 2000; ++i) {
      const double force = curve.force_N(curve.start_mm() + curve.travel_mm() * i / 2000);
      RC_ASSERT(force >= low - 1e-12);
      RC_ASSERT(force <= high + 1e-12);
    }
    for (const CurvePoint& p : curve.localMaxima()) {
      RC_ASSERT(p.force_N <= high);
      // As close as no second turn can be.
      RC_ASSERT(curve.forceBefore_N(p.displacement_mm - 1e-9) <= p.force_N + 1e-12);
      RC_ASSERT(curve.force_N(p.displacement_mm + 1e-9) <= p.force_N + 1e-12);
    }
  });
}

TEST_CASE("area is additive and agrees with fine sums") {
  holdsAlways("area_mJ", [] {
    const StrokeCurve curve = anyCurve();
    const double a = curve.start_mm() + between(0, 1) * curve.travel_mm();
    const double whole = curve.area_mJ(curve.start_mm(), curve.end_mm());
    RC_ASSERT(std::abs(curve.area_mJ(curve.start_mm(), a) + curve.area_mJ(a, curve.end_mm()) - whole) <
              1e-12);
    double sum = 0;
    constexpr int parts = 20000;
    for (int i = 0; i < parts; ++i)
      sum += curve.force_N(curve.start_mm() + curve.travel_mm() * (i + 0.5) / parts);
    RC_ASSERT(std::abs(sum * curve.travel_mm() / parts - whole) < 2e-3 * std::max(1.0, curve.travel_mm()));
  });
}

TEST_CASE("a slope that is 0 but for rounding leaves the extremum on its knot") {
  for (double rest : {2e-8, -2e-8, 1e-12, 1e-17}) {
    const StrokeCurve curve = curveOf({{0, 0, 0, 1}, {1, 0.6, rest, rest}, {2, 0.3, 0, 0}});
    REQUIRE(curve.localMaxima().size() == 1);
    CHECK(curve.localMaxima()[0] == CurvePoint{1, 0.6});
  }
}
