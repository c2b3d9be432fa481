// SPDX-License-Identifier: GPL-3.0-or-later
// The limits of requests to a fit.

#include <chrono>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/importer/fit/drawn_strokes.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::drawn;

namespace {

FitOptions withNoise(double sigma_mm, double sigma_N) {
  FitOptions options;
  options.noise = {sigma_mm, sigma_N};
  return options;
}

}  // namespace

TEST_CASE("two, three and four points are joined") {
  const std::vector<CurvePoint> all{{0, 0}, {1, 1}, {2, 0.5}, {3, 2}};
  for (std::size_t n = 2; n <= 4; ++n) {
    const std::vector<CurvePoint> points(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
    const auto fitted = fitStroke(points, Stroke::press, withNoise(0.01, 0.01));
    REQUIRE(fitted);
    CHECK(fitted->summary.outcome == FitOutcome::tooFewPoints);
    CHECK(fitted->summary.pieces == static_cast<int>(n) - 1);
    for (const CurvePoint& p : points) CHECK(fitted->curve.force_N(p.displacement_mm) == Approx(p.force_N));
    CHECK(fitted->curve.force_N(0.5) == Approx(0.5));
  }
}

TEST_CASE("straight points need one piece") {
  for (const double slope : {0.0, 0.1, -0.3, 40.0}) {
    std::vector<CurvePoint> points;
    for (int i = 0; i <= 500; ++i) points.push_back({0.008 * i, 0.5 + slope * 0.008 * i});
    const auto fitted = fitStroke(points, Stroke::press, withNoise(0.002, 0.001));
    REQUIRE(fitted);
    CAPTURE(slope);
    CHECK(fitted->summary.pieces == 1);
    CHECK(fitted->curve.start_mm() == Approx(0).margin(1e-9));
    CHECK(fitted->curve.end_mm() == Approx(4));
    for (double x = 0; x <= 4; x += 0.5)
      CHECK(fitted->curve.force_N(x) == Approx(0.5 + slope * x).margin(1e-4 * (1 + std::abs(slope))));
  }
}

TEST_CASE("a staircase has its treads and risers") {
  std::vector<CurvePoint> points;
  for (int step = 0; step < 5; ++step) {
    for (int i = 0; i <= 100; ++i) points.push_back({step + 0.01 * i, 0.2 * step});
    for (int i = 1; i < 40; ++i) points.push_back({step + 1.0, 0.2 * step + 0.005 * i});
  }
  const auto fitted = fitStroke(points, Stroke::press, withNoise(0.005, 0.001));
  REQUIRE(fitted);
  CHECK(fitted->summary.pieces <= 14);
  CHECK(piecesAreMonotone(fitted->curve));
  for (int step = 0; step < 5; ++step)
    CHECK(fitted->curve.force_N(step + 0.5) == Approx(0.2 * step).margin(0.004));
}

TEST_CASE("a million points take bounded work") {
  std::vector<CurvePoint> points;
  const StrokeCurve truth = tactileKey();
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0, 0.004);
  for (int i = 0; i < 1000000; ++i) {
    const double x = 3.79 * i / 1e6;
    points.push_back({x, truth.force_N(x) + noise(random)});
  }
  const auto fitted = fitStroke(points, Stroke::press, withNoise(0.001, 0.004));
  REQUIRE(fitted);
  CHECK(fitted->summary.points <= 2000);
  CHECK(fitted->summary.pieces <= 8);
  CHECK(worstForceError(fitted->curve, truth, 3.7) < 0.002);
}

TEST_CASE("steep rises at both ends, vertical or leaning back, keep their height and their displacement") {
  for (const double lean : {0.0, -0.01}) {
    std::vector<CurvePoint> points;
    for (int i = 0; i < 100; ++i) points.push_back({0, 0.003 * i});
    for (int i = 0; i <= 400; ++i) points.push_back({0.01 * i, 0.3 + 0.001 * i});
    for (int i = 1; i <= 100; ++i) points.push_back({4 + lean * 0.01 * i, 0.7 + 0.005 * i});
    const auto fitted = fitStroke(points, Stroke::press, withNoise(0.003, 0.001));
    REQUIRE(fitted);
    CAPTURE(lean);
    CHECK(fitted->curve.end_mm() == Approx(4).margin(0.012));
    CHECK(fitted->curve.start_mm() == Approx(0).margin(0.005));
    CHECK(fitted->curve.knots().front().force_N == Approx(0).margin(0.003));
    CHECK(fitted->curve.knots().back().force_N == Approx(1.2).margin(0.005));
    CHECK(fitted->curve.force_N(2) == Approx(0.5).margin(0.003));
    CHECK(fitted->summary.pieces <= 5);
  }
}

TEST_CASE("repeated points and flat force") {
  std::vector<CurvePoint> points;
  for (int i = 0; i <= 200; ++i)
    for (int repeat = 0; repeat < 3; ++repeat) points.push_back({0.02 * i, 0.5});
  const auto fitted = fitStroke(points, Stroke::press, withNoise(0.005, 0.001));
  REQUIRE(fitted);
  CHECK(fitted->summary.pieces == 1);
  CHECK(fitted->curve.force_N(2) == Approx(0.5));
  CHECK(fitted->summary.tactilePoints.empty());
}

TEST_CASE("one outlier of a force meter costs nothing but itself") {
  std::vector<CurvePoint> points;
  const StrokeCurve truth = tactileKey();
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0, 0.001);
  for (int i = 0; i <= 400; ++i) points.push_back({0.009 * i, truth.force_N(0.009 * i) + noise(random)});
  for (const double outlier : {-55.8, 500.0, 1e30}) {
    CAPTURE(outlier);
    std::vector<CurvePoint> spoilt = points;
    spoilt[137].force_N = outlier;
    const auto fitted = fitStroke(spoilt, Stroke::press, withNoise(0.003, 0.001));
    REQUIRE(fitted);
    CHECK(worstForceError(fitted->curve, truth, 3.5) < 0.01);
    REQUIRE(fitted->summary.tactilePoints.size() == 1);
    CHECK(fitted->summary.tactilePoints[0].point.force_N == Approx(0.55).margin(0.003));
  }
}

TEST_CASE("what cannot be fitted is refused with a sentence") {
  const FitOptions options = withNoise(0.01, 0.01);
  const auto refused = [&](const std::vector<CurvePoint>& points) {
    const auto fitted = fitStroke(points, Stroke::press, options);
    REQUIRE_FALSE(fitted);
    CHECK(fitted.failure().code == FailureCode::unreadableInput);
    CHECK_FALSE(fitted.failure().remedies.empty());
    return fitted.failure().sentence();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  CHECK(refused({}).find("no point") != std::string::npos);
  CHECK(refused({{1, 1}}).find("one point") != std::string::npos);
  CHECK(refused({{1, 1}, {1, 2}, {1, 3}}).find("no travel") != std::string::npos);
  CHECK(refused({{0, 1}, {1, nan}, {2, 1}}).find("point 2") != std::string::npos);
  CHECK(refused({{0, 1}, {infinite, 1}}).find("point 2") != std::string::npos);
  std::vector<CurvePoint> thereAndBack;
  for (int i = 0; i <= 100; ++i) thereAndBack.push_back({0.04 * i, 0.5});
  for (int i = 99; i >= 1; --i) thereAndBack.push_back({0.04 * i, 0.4});
  CHECK(refused(thereAndBack).find("back and forth") != std::string::npos);
}

TEST_CASE("options outside their ranges are refused by name") {
  const std::vector<CurvePoint> points{{0, 0}, {1, 1}, {2, 2}};
  const auto refused = [&](auto&& spoil) {
    FitOptions options = withNoise(0.01, 0.01);
    spoil(options);
    const auto fitted = fitStroke(points, Stroke::press, options);
    REQUIRE_FALSE(fitted);
    CHECK(fitted.failure().code == FailureCode::wrongUsage);
    return english(fitted.failure().place);
  };
  CHECK(refused([](FitOptions& o) { o.noise.sigma_mm = 0; }) == "noise.sigma_mm");
  CHECK(refused([](FitOptions& o) { o.noise.sigma_N = std::nan(""); }) == "noise.sigma_N");
  CHECK(refused([](FitOptions& o) { o.maxPieces = 0; }) == "maxPieces");
  CHECK(refused([](FitOptions& o) { o.criterion = PieceCriterion::fixed; }) == "pieces");
  CHECK(refused([](FitOptions& o) { o.tolerance = 0; }) == "tolerance");
  CHECK(refused([](FitOptions& o) { o.maxPoints = 3; }) == "maxPoints");
  CHECK(refused([](FitOptions& o) { o.robustScale = -1; }) == "robustScale");
  CHECK(refused([](FitOptions& o) { o.noiseAtTactilePoints_share = 0; }) == "noiseAtTactilePoints_share");
  CHECK(refused([](FitOptions& o) { o.noiseAtTactilePoints_share = 1.5; }) == "noiseAtTactilePoints_share");
}

TEST_CASE("units of any size give the same curve") {
  const StrokeCurve truth = tactileKey();
  const auto points = traced(truth, 640, 440, 0.3);
  const FitOptions options = optionsFor(truth, 640, 440, 0.3);
  const auto plain = fitStroke(points, Stroke::press, options);
  REQUIRE(plain);
  for (const double force : {0x1p-20, 0x1p20})
    for (const double length : {0x1p-22, 1.0}) {
      std::vector<CurvePoint> scaled = points;
      for (CurvePoint& p : scaled) p.displacement_mm *= length, p.force_N *= force;
      const auto fitted = fitStroke(
          scaled, Stroke::press, withNoise(options.noise.sigma_mm * length, options.noise.sigma_N * force));
      REQUIRE(fitted);
      REQUIRE(fitted->summary.pieces == plain->summary.pieces);
      for (std::size_t k = 0; k < fitted->curve.knots().size(); ++k) {
        CHECK(fitted->curve.knots()[k].displacement_mm / length ==
              Approx(plain->curve.knots()[k].displacement_mm).margin(1e-9));
        CHECK(fitted->curve.knots()[k].force_N / force ==
              Approx(plain->curve.knots()[k].force_N).margin(1e-9));
      }
    }
}

TEST_CASE("any points give a finite curve of monotone pieces over their travel, or a sentence") {
  CHECK(rc::check("random strokes", [] {
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(2, 120));
    const auto steps = *rc::gen::container<std::vector<int>>(count, rc::gen::inRange(-3, 30));
    const auto forces = *rc::gen::container<std::vector<int>>(count, rc::gen::inRange(-50, 50));
    const bool press = *rc::gen::arbitrary<bool>();
    std::vector<CurvePoint> points;
    double x = 0, least = 0, most = 0;
    for (std::size_t i = 0; i < count; ++i) {
      points.push_back({x, 0.01 * forces[i]});
      least = std::min(least, x), most = std::max(most, x);
      x += 0.01 * steps[i];
    }
    const auto fitted = fitStroke(points, press ? Stroke::press : Stroke::release, withNoise(0.01, 0.01));
    if (!fitted) {
      RC_ASSERT(!fitted.failure().problem.empty());
      return;
    }
    RC_ASSERT(piecesAreMonotone(fitted->curve));
    const auto [low, high] = fitted->curve.forceRange_N();
    RC_ASSERT(std::isfinite(low) && std::isfinite(high));
    RC_ASSERT(low > -1 && high < 1);
    RC_ASSERT(fitted->curve.start_mm() > least - 0.2 && fitted->curve.end_mm() < most + 0.2);
  }));
}
