// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sampling.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "model/templates.h"
#include "tests/model/property.h"
#include "tests/model/random_curves.h"

using namespace detent;
using detent::tests::anyCurve;
using detent::tests::holdsAlways;

namespace {

// Force of the polyline at a displacement, between the two samples around it.
double lineForce(const std::vector<CurvePoint>& samples, double x) {
  std::size_t i = 0;
  while (i + 2 < samples.size() && samples[i + 1].displacement_mm < x) ++i;
  const CurvePoint a = samples[i], b = samples[i + 1];
  if (a.displacement_mm == b.displacement_mm) return b.force_N;
  return a.force_N +
         (b.force_N - a.force_N) * (x - a.displacement_mm) / (b.displacement_mm - a.displacement_mm);
}

bool has(const std::vector<CurvePoint>& samples, CurvePoint point) {
  return std::find(samples.begin(), samples.end(), point) != samples.end();
}

}  // namespace

TEST_CASE("straight lines between samples miss the curve by the tolerance at most") {
  holdsAlways("samplesOf", [] {
    const StrokeCurve curve = anyCurve();
    for (double tolerance : {1e-2, 1e-4}) {
      const auto samples = samplesOf(curve, tolerance);
      for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        RC_ASSERT(samples[i].displacement_mm <= samples[i + 1].displacement_mm);
        RC_ASSERT(!(samples[i] == samples[i + 1]));
        const double middle = 0.5 * (samples[i].displacement_mm + samples[i + 1].displacement_mm);
        if (samples[i].displacement_mm < middle && middle < samples[i + 1].displacement_mm)
          RC_ASSERT(std::abs(curve.force_N(middle) - 0.5 * (samples[i].force_N + samples[i + 1].force_N)) <=
                    tolerance + 1e-12);
      }
      for (const Knot& k : curve.knots()) RC_ASSERT(has(samples, {k.displacement_mm, k.force_N}));
      for (const CurvePoint& p : curve.localMaxima())
        if (curve.forceBefore_N(p.displacement_mm) == curve.force_N(p.displacement_mm) &&
            std::abs(curve.force_N(p.displacement_mm + 1e-6) - p.force_N) > 0)
          RC_ASSERT(has(samples, p));
    }
  });
}

TEST_CASE("a curve through its own samples is the curve again, within the tolerance and with few knots") {
  holdsAlways("curveThroughDensePoints", [] {
    const StrokeCurve curve = anyCurve();
    const double tolerance = 1e-4;
    const auto samples = samplesOf(curve, tolerance);
    const auto again = curveThroughDensePoints(samples, tolerance);
    RC_ASSERT(again.ok());
    for (const CurvePoint& p : samples) {
      const double off = std::min(std::abs(again->force_N(p.displacement_mm) - p.force_N),
                                  std::abs(again->forceBefore_N(p.displacement_mm) - p.force_N));
      RC_ASSERT(off <= tolerance + 1e-9);
    }
    for (int i = 1; i < 500; ++i) {
      const double x = curve.start_mm() + curve.travel_mm() * i / 500;
      RC_ASSERT(std::abs(again->force_N(x) - lineForce(samples, x)) <= 2.5 * tolerance);
    }
    RC_ASSERT(again->knots().size() <= 3 * curve.knots().size() + 4);
  });
}

TEST_CASE("sparse points are joined, never decorated") {
  const std::vector<CurvePoint> points{{0, 0}, {1, 0}, {1.001, 1}, {2, 1}};
  const auto curve = curveThroughDensePoints(points, 1e-4);
  REQUIRE(curve.ok());
  const auto [low, high] = curve->forceRange_N();
  CHECK(low >= -2e-4);
  CHECK(high <= 1 + 2e-4);
}

TEST_CASE("vertical pieces survive, also at both ends and through many points") {
  const auto curve =
      curveThroughDensePoints({{0, 0}, {0, 0.4}, {1, 0.5}, {2, 0.7}, {2, 0.9}, {2, 1.4}, {2, 2}}, 1e-4);
  REQUIRE(curve.ok());
  CHECK(curve->knots().front().displacement_mm == 0);
  CHECK(curve->knots()[1].displacement_mm == 0);
  CHECK(curve->knots()[1].force_N == 0.4);
  const auto& knots = curve->knots();
  CHECK(knots[knots.size() - 2].force_N == 0.7);
  CHECK(knots.back().force_N == 2);
}

TEST_CASE("points that are no stroke are refused with their number") {
  const auto back = curveThroughDensePoints({{0, 0}, {1, 1}, {0.5, 1}}, 1e-4);
  REQUIRE_FALSE(back.ok());
  CHECK_THAT(
      back.failure().sentence(),
      Catch::Contains("point 3: the displacement 0.5 mm lies before that of the previous point, 1 mm"));
  const auto spike = curveThroughDensePoints({{0, 0}, {1, 0}, {1, 2}, {1, 1}, {2, 1}}, 1e-4);
  REQUIRE_FALSE(spike.ok());
  CHECK_THAT(spike.failure().sentence(),
             Catch::Contains("point 4: the force reverses its direction inside a vertical rise"));
  CHECK_FALSE(curveThroughDensePoints({{0, 0}, {1, NAN}}, 1e-4).ok());
  CHECK_FALSE(curveThroughDensePoints({{0, 0}}, 1e-4).ok());
  CHECK_FALSE(curveThroughDensePoints({{0, 0}, {0, 1}}, 1e-4).ok());
}

TEST_CASE("release samples come in the order travelled") {
  const ForceGraph graph = tactileButton()->states()[0].graph;
  const auto samples = travelledSamples(graph, Stroke::release);
  CHECK(samples.front().displacement_mm == 4);
  CHECK(samples.back().displacement_mm == 0);
}

TEST_CASE("a curve whose knots stand an ulp apart beside a vertical piece comes back from its samples") {
  const double x = 2.2204460492503136e-19, next = std::nextafter(x, 1.0);
  const auto curve = StrokeCurve::fromKnots({{0, -2e-10, 0, 0},
                                             {x, -2e-10, -4e-6, -4e-6},
                                             {next, -1.9991e-10, -4e-6, -4e-6},
                                             {next, -2e-10, -4e-6, -4e-6},
                                             {1e-3, -1e-10, 0, 0}});
  REQUIRE(curve);
  const auto again = curveThroughDensePoints(samplesOf(*curve, 1e-14), 1e-14);
  if (!again) FAIL(again.failure().sentence());
  CHECK(again->knots().back().force_N == -1e-10);
}
