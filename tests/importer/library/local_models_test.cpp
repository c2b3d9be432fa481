// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/local_models.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "importer/library/sampled_stroke.h"

using namespace detent;
using namespace detent::importer;

namespace {

LocalWindow windowOf(const std::function<double(double)>& force_N, double from_mm, double to_mm, int count,
                     double noise_N, std::mt19937& random, double carried = 0) {
  std::normal_distribution<double> noise(0, 1);
  LocalWindow window;
  window.carried = carried * carried;
  window.share = 0.9;
  double carry = carried * noise(random);
  for (int i = 0; i < count; ++i) {
    const double x = from_mm + (to_mm - from_mm) * i / (count - 1);
    window.points.push_back({x, force_N(x) + noise_N * (noise(random) + carry)});
    carry = window.share * carry + carried * std::sqrt(1 - window.share * window.share) * noise(random);
    window.own.push_back(1);
  }
  return window;
}

/// Per cent of places and forces within one standard error, of 400 windows; of the places also the mean
/// error.
struct Covered {
  double place = 0, force = 0;
  double sigma_mm = 0;  ///< mean
};
Covered covered(const std::function<double(double)>& force_N, double from_mm, double to_mm, CurvePoint truth,
                const std::function<std::optional<LocalPlace>(const LocalWindow&)>& place,
                double carried = 0) {
  std::mt19937 random(7);
  Covered within;
  for (int i = 0; i < 400; ++i) {
    const auto found = place(windowOf(force_N, from_mm, to_mm, 90, 0.0015, random, carried));
    REQUIRE(found);
    within.place +=
        std::abs(found->displacement_mm - truth.displacement_mm) <= std::sqrt(found->variance_mm2) ? 0.25 : 0;
    within.force += std::abs(found->force_N - truth.force_N) <= std::sqrt(found->variance_N2) ? 0.25 : 0;
    within.sigma_mm += std::sqrt(found->variance_mm2) / 400;
  }
  return within;
}

}  // namespace

TEST_CASE("an extremum's error covers its truth, and a bend that jumps at the top is seen") {
  const auto peak = [](const LocalWindow& window) { return extremumIn(window, 1); };
  const auto smooth = [](double x) { return 0.6 - 0.9 * (x - 1) * (x - 1) + 0.5 * std::pow(x - 1, 3); };
  const auto bent = [](double x) { return 0.6 - (x < 1 ? 0.7 : 3.0) * (x - 1) * (x - 1); };
  const auto low = [](double x) { return 0.3 + 0.9 * (x - 1) * (x - 1); };
  const auto valley = [](const LocalWindow& window) { return extremumIn(window, -1); };
  // Samples do not always show a jump of the curvature at the top; without one the stated error is too large.
  for (const Covered& each :
       {covered(smooth, 0.75, 1.3, {1, 0.6}, peak), covered(bent, 0.7, 1.15, {1, 0.6}, peak),
        covered(low, 0.75, 1.3, {1, 0.3}, valley)}) {
    CHECK(each.place > 60);
    CHECK(each.sigma_mm < 0.012);
    CHECK(each.force == Approx(68).margin(14));
  }
}

TEST_CASE("where the models of a window do not agree, that is in the error") {
  const auto valley = [](const LocalWindow& window) { return extremumIn(window, -1); };
  for (const double to_mm : {1.3, 1.5})
    for (const double steep : {0.9, 2.0}) {
      // Flat behind the valley, as a monotone cubic is: models without the joint lie behind it.
      const Covered each = covered(
          [&](double x) { return 0.3 + (x < 1 ? steep * (x - 1) * (x - 1) : 0.15 * std::pow(x - 1, 3)); },
          0.75, to_mm, {1, 0.3}, valley);
      CHECK(each.place > 60);
      CHECK(each.force == Approx(68).margin(10));
    }
}

TEST_CASE("noise that samples carry on is in the errors") {
  const auto smooth = [](double x) { return 0.6 - 0.9 * (x - 1) * (x - 1) + 0.5 * std::pow(x - 1, 3); };
  const auto peak = [](const LocalWindow& window) { return extremumIn(window, 1); };
  const Covered each = covered(smooth, 0.75, 1.3, {1, 0.6}, peak, 1);
  CHECK(each.place > 60);
  CHECK(each.force == Approx(68).margin(10));
}

TEST_CASE("a corner's error covers its truth") {
  const Covered bottomOut =
      covered([](double x) { return 0.5 + 0.05 * x + (x > 3.6 ? 6 * (x - 3.6) : 0); }, 3.3, 3.75, {3.6, 0.68},
              [](const LocalWindow& window) { return cornerIn(window, 3.59); });
  CHECK(bottomOut.place == Approx(68).margin(14));
  CHECK(bottomOut.force == Approx(68).margin(14));
  CHECK(bottomOut.sigma_mm < 0.0005);
}

TEST_CASE("the force at the beginning is what is read before contact, however near that is") {
  const Covered start = covered([](double x) { return x > 0.12 ? 4 * (x - 0.12) : 0; }, 0, 0.14, {0, 0},
                                [](const LocalWindow& window) { return beginningOf(window); });
  CHECK(start.force == Approx(68).margin(12));
}

TEST_CASE("samples that share their errors tell less, and few tell nothing") {
  std::mt19937 random(3);
  const auto bump = [](double x) { return 0.6 - (x - 1) * (x - 1); };
  LocalWindow window = windowOf(bump, 0.7, 1.3, 120, 0.002, random);
  const auto apart = extremumIn(window, 1);
  window.carried = 1;
  const auto shared = extremumIn(window, 1);
  REQUIRE((apart && shared));
  CHECK(shared->variance_mm2 > 1.4 * apart->variance_mm2);
  CHECK_FALSE(extremumIn(windowOf(bump, 0.9, 1.1, 7, 0.002, random), 1));
  CHECK_FALSE(extremumIn(windowOf([](double x) { return x; }, 0, 1, 100, 0.001, random), 1));
  CHECK_FALSE(cornerIn({}, 1));
  CHECK_FALSE(beginningOf({}));
}

TEST_CASE("a stroke's samples tell the meter's noise, its step and what samples share") {
  const auto curve = StrokeCurve::fromKnots({{0, 0.2, 0, 0.1}, {4, 0.6, 0.1, 0}});
  REQUIRE(curve);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.002);
  std::vector<CurvePoint> white, carried;
  double carry = 0;
  for (int i = 0; i <= 800; ++i) {
    const double x = 0.005 * i;
    carry = 0.9 * carry + std::sqrt(1 - 0.81) * noise(random);
    white.push_back({x, curve->force_N(x) + noise(random)});
    carried.push_back({x, white.back().force_N + 0.5 * carry});
  }
  const SampledStroke even(*curve, white), slow(*curve, carried);
  CHECK(even.isEven());
  CHECK(even.step_mm() == Approx(0.005));
  CHECK(even.noise_N() == Approx(0.002).epsilon(0.08));
  // The mean of 800 readings, times the travel: white noise, and with a fifth of it carried on, of which 19
  // share one error.
  CHECK(std::sqrt(even.areaVariance()) == Approx(4 * 0.002 / std::sqrt(800.0)).epsilon(0.25));
  CHECK(std::sqrt(slow.areaVariance() / even.areaVariance()) > 1.2);
  for (std::size_t i = 0; i < 800; i += 20)
    white.insert(white.begin() + static_cast<std::ptrdiff_t>(i), white[i]);
  CHECK_FALSE(SampledStroke(*curve, white).isEven());
  // Displacements that tremble go back now and then: a window still holds all samples inside it.
  std::vector<CurvePoint> trembling = carried;
  for (std::size_t i = 10; i + 12 < trembling.size(); i += 12) std::swap(trembling[i], trembling[i + 11]);
  const LocalWindow inside = SampledStroke(*curve, trembling).between(1, 2);
  CHECK(inside.points.size() == slow.between(1, 2).points.size());
  CHECK(std::ranges::is_sorted(inside.points, {}, &CurvePoint::displacement_mm));
}
