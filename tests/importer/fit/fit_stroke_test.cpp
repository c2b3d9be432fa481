// SPDX-License-Identifier: GPL-3.0-or-later
// What a fit must give back of a stroke whose truth is known.

#include "importer/fit/fit_stroke.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "tests/importer/fit/drawn_strokes.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::drawn;

TEST_CASE("a tactile key comes back with its own number of pieces") {
  const StrokeCurve truth = tactileKey();
  const auto options = optionsFor(truth, 640, 440, 0.3);
  const auto fitted = fitStroke(traced(truth, 640, 440, 0.3), Stroke::press, options);
  REQUIRE(fitted);
  CHECK(fitted->summary.outcome == FitOutcome::converged);
  CHECK(fitted->summary.pieces <= 6);
  CHECK(fitted->summary.rmsSigma < 1.2);
  CHECK(piecesAreMonotone(fitted->curve));
  CHECK(worstForceError(fitted->curve, truth, 3.75) < 0.6 * 0.9 / 440);
  CHECK(fitted->curve.start_mm() == Approx(0).margin(0.006));
  CHECK(fitted->curve.end_mm() == Approx(3.8).margin(0.006));
  CHECK(fitted->curve.forceRange_N().second == Approx(1.2).margin(0.004));
  CHECK(fitted->summary.brief().find("pieces") != std::string::npos);
}

TEST_CASE("the tactile point is an exact extremum, a knot with slope 0, and its standard error is honest") {
  const StrokeCurve truth = tactileKey();
  const auto options = optionsFor(truth, 640, 440, 0.3);
  int inside = 0;
  constexpr int trials = 20;
  double sum_mm = 0, sum_N = 0;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const auto fitted = fitStroke(traced(truth, 640, 440, 0.3, seed), Stroke::press, options);
    REQUIRE(fitted);
    REQUIRE(fitted->summary.tactilePoints.size() == 1);
    const FittedTactilePoint& tactile = fitted->summary.tactilePoints.front();
    CHECK(tactile.point.displacement_mm == Approx(1.2).margin(0.02));
    CHECK(tactile.point.force_N == Approx(0.55).margin(0.003));
    CHECK(tactile.sigma_mm > 0);
    CHECK(tactile.sigma_N > 0);
    sum_mm += tactile.sigma_mm, sum_N += tactile.sigma_N;
    inside += std::abs(tactile.point.displacement_mm - 1.2) < 3 * tactile.sigma_mm &&
              std::abs(tactile.point.force_N - 0.55) < 3 * tactile.sigma_N;
    const auto& knots = fitted->curve.knots();
    const bool isKnot = std::any_of(knots.begin(), knots.end(), [&](const Knot& k) {
      return std::abs(k.displacement_mm - tactile.point.displacement_mm) < 1e-9 &&
             k.slopeBefore_N_per_mm >= 0 && k.slopeAfter_N_per_mm <= 0;
    });
    CHECK(isKnot);
  }
  CHECK(inside >= trials - 2);
  CHECK(sum_mm / trials < 0.02);
  CHECK(sum_N / trials < 0.002);
}

TEST_CASE("a corner peak stays a corner") {
  const StrokeCurve truth =
      curveOf({{0, 0.2, 0.3, 0.3}, {1.5, 0.65, 0.3, -0.5}, {2.2, 0.3, -0.5, 0.2}, {4, 0.66, 0.2, 0.2}});
  const auto fitted =
      fitStroke(traced(truth, 640, 440, 0.2), Stroke::press, optionsFor(truth, 640, 440, 0.2));
  REQUIRE(fitted);
  CHECK(fitted->summary.pieces == 3);
  CHECK(worstForceError(fitted->curve, truth, 4) < 1.0 * 0.46 / 440);
  REQUIRE(fitted->summary.tactilePoints.size() == 1);
  CHECK(fitted->summary.tactilePoints[0].point.displacement_mm == Approx(1.5).margin(0.01));
}

TEST_CASE("a release is fitted in its own order and keeps its valley") {
  const StrokeCurve truth = tactileKey();
  const auto points = reversed(traced(truth, 640, 440, 0.3));
  const auto fitted = fitStroke(points, Stroke::release, optionsFor(truth, 640, 440, 0.3));
  REQUIRE(fitted);
  REQUIRE_FALSE(fitted->summary.tactilePoints.empty());
  CHECK(fitted->summary.tactilePoints[0].point.displacement_mm == Approx(2.0).margin(0.02));
  CHECK(fitted->summary.tactilePoints[0].point.force_N == Approx(0.38).margin(0.003));
}

TEST_CASE("points in either order give the same curve, bit for bit, and so does a second run") {
  const StrokeCurve truth = tactileKey();
  const auto points = traced(truth, 640, 440, 0.3);
  const auto options = optionsFor(truth, 640, 440, 0.3);
  const auto once = fitStroke(points, Stroke::press, options),
             again = fitStroke(points, Stroke::press, options);
  const auto turned = fitStroke(reversed(points), Stroke::press, options);
  REQUIRE(once);
  REQUIRE(again);
  REQUIRE(turned);
  CHECK(once->curve == again->curve);
  CHECK(once->curve == turned->curve);
}

TEST_CASE("effort levels trade pieces for speed, all of them stay on the curve") {
  const StrokeCurve truth = tactileKey();
  const auto points = traced(truth, 640, 440, 0.3);
  const PointNoise noise = optionsFor(truth, 640, 440, 0.3).noise;
  for (const FitEffort effort : {FitEffort::draft, FitEffort::standard, FitEffort::precise}) {
    const auto fitted = fitStroke(points, Stroke::press, fitOptionsFor(effort, noise));
    REQUIRE(fitted);
    CHECK(worstForceError(fitted->curve, truth, 3.7) < 2.0 * 0.9 / 440);
  }
}

TEST_CASE("a given number of pieces is kept") {
  const StrokeCurve truth = tactileKey();
  FitOptions options = optionsFor(truth, 640, 440, 0.3);
  options.criterion = PieceCriterion::fixed;
  for (const int pieces : {1, 2, 5, 12}) {
    options.pieces = pieces;
    const auto fitted = fitStroke(traced(truth, 640, 440, 0.3), Stroke::press, options);
    REQUIRE(fitted);
    CHECK(fitted->summary.pieces == pieces);
    CHECK(fitted->curve.knots().size() == static_cast<std::size_t>(pieces) + 1);
  }
}

TEST_CASE("more pieces than allowed are not made") {
  const StrokeCurve truth = tactileKey();
  FitOptions options = optionsFor(truth, 640, 440, 0.3);
  options.maxPieces = 3;
  const auto fitted = fitStroke(traced(truth, 640, 440, 0.3), Stroke::press, options);
  REQUIRE(fitted);
  CHECK(fitted->summary.pieces <= 3);
}

TEST_CASE("outliers do not pull the curve") {
  const StrokeCurve truth = tactileKey();
  auto points = traced(truth, 640, 440, 0.3);
  for (std::size_t i = 40; i < points.size() - 300; i += 97) points[i].force_N += 0.05;  // 24 px
  const auto fitted = fitStroke(points, Stroke::press, optionsFor(truth, 640, 440, 0.3));
  REQUIRE(fitted);
  CHECK(worstForceError(fitted->curve, truth, 3.7) < 2.0 * 0.9 / 440);
  CHECK(fitted->summary.pieces <= 9);
}

TEST_CASE("single readings of a noisy meter make no tactile points") {
  const StrokeCurve truth =
      curveOf({{0, 0.3, 0.25, 0.25}, {1.6, 0.65, 0, 0}, {2.4, 0.5, 0, 0}, {4, 0.72, 0.2, 0.2}});
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.006);
    std::vector<CurvePoint> points;
    for (int i = 0; i <= 1000; ++i) points.push_back({0.004 * i, truth.force_N(0.004 * i) + noise(random)});
    const auto fitted = fitStroke(points, Stroke::press, fitOptionsFor(FitEffort::standard, {0.001, 0.006}));
    REQUIRE(fitted);
    CAPTURE(seed);
    CHECK(fitted->summary.tactilePoints.size() == 1);
  }
}
