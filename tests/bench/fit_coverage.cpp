// SPDX-License-Identifier: GPL-3.0-or-later
// Do the fit's errors cover? Random strokes of known tactile point, drawn and logged, each with new noise:
//
//   detent_fit_coverage [STROKES]      default 400
//
// Prints the table of docs/measurements/coverage.md (tests/bench/coverage.py fit). Deterministic; no timing.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "importer/fit/fit_stroke.h"
#include "tests/bench/coverage_count.h"

namespace {

using namespace detent;
using namespace detent::importer;
using detent::test::CoverageCount;

struct Truth {
  std::function<double(double)> force_N;
  double travel_mm = 4;
  CurvePoint tactile;
};

/// A smooth bump on a rising line: no curve of cubics, as no real button is one.
Truth bump(std::mt19937& random) {
  std::uniform_real_distribution<double> u(0, 1);
  const double start = 0.2 + 0.3 * u(random), rise = 0.05 + 0.1 * u(random), height = 0.1 + 0.2 * u(random);
  const double place = 1.0 + 0.8 * u(random), width = 0.22 + 0.2 * u(random);
  Truth truth;
  truth.force_N = [=](double x) {
    return start + rise * x + height * std::exp(-std::pow((x - place) / width, 2));
  };
  double low = place - width, high = place + width;  // golden section
  for (int i = 0; i < 200; ++i) {
    const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
    (truth.force_N(a) > truth.force_N(b) ? high : low) = truth.force_N(a) > truth.force_N(b) ? b : a;
  }
  truth.tactile = {0.5 * (low + high), truth.force_N(0.5 * (low + high))};
  return truth;
}

/// Cubics whose tactile point is one of their knots, as the fit assumes.
Truth cubics(std::mt19937& random) {
  std::uniform_real_distribution<double> u(0, 1);
  const double x1 = 1.0 + 0.6 * u(random), f1 = 0.5 + 0.2 * u(random), x2 = x1 + 0.5 + 0.5 * u(random);
  const StrokeCurve curve = *StrokeCurve::fromKnots({{0, 0.25 + 0.1 * u(random), 0.2, 0.2},
                                                     {x1, f1, 0, 0},
                                                     {x2, f1 - 0.1 - 0.15 * u(random), 0, 0},
                                                     {4, f1 + 0.1, 0.15, 0.15}});
  return {[curve](double x) { return curve.force_N(x); }, 4, {x1, f1}};
}

/// A force meter: even steps, white noise of the force, a rounded displacement.
std::vector<CurvePoint> logged(const Truth& truth, int samples, double noise_N, std::mt19937& random) {
  std::normal_distribution<double> noise(0, noise_N);
  std::vector<CurvePoint> points;
  for (int i = 0; i < samples; ++i) {
    const double x = truth.travel_mm * i / (samples - 1);
    points.push_back({x, truth.force_N(x) + noise(random)});
  }
  return points;
}

/// A traced line: one point a pixel of arc, noise that neighbours share (0.7 from one to the next).
std::vector<CurvePoint> traced(const Truth& truth, double noise_px, double shared, std::mt19937& random,
                               PointNoise& noise) {
  constexpr double width_px = 640, height_px = 440;
  double low = 1e9, high = -1e9;
  for (int i = 0; i <= 1000; ++i) {
    const double f = truth.force_N(truth.travel_mm * i / 1000);
    low = std::min(low, f), high = std::max(high, f);
  }
  const double mmPerPx = truth.travel_mm / width_px, newtonPerPx = (high - low) / height_px;
  noise = {noise_px * mmPerPx, noise_px * newtonPerPx};
  std::normal_distribution<double> unit(0, 1);
  std::vector<CurvePoint> points;
  double ex = 0, ef = 0, arc = 1, before = truth.force_N(0);
  constexpr int fine = 20000;
  for (int i = 0; i <= fine; ++i) {
    const double x = truth.travel_mm * i / fine, f = truth.force_N(x);
    arc += std::hypot(truth.travel_mm / fine / mmPerPx, (f - before) / newtonPerPx);
    before = f;
    if (arc < 1) continue;
    arc -= 1;
    const double fresh = std::sqrt(1 - shared * shared);
    ex = shared * ex + fresh * unit(random), ef = shared * ef + fresh * unit(random);
    points.push_back({x + ex * noise.sigma_mm, f + ef * noise.sigma_N});
  }
  return points;
}

void count(const char* kind, int strokes, const std::function<Truth(std::mt19937&)>& draw,
           const std::function<std::vector<CurvePoint>(const Truth&, std::mt19937&, PointNoise&)>& measure) {
  std::mt19937 random(20131008);
  CoverageCount place, force;
  for (int i = 0; i < strokes; ++i) {
    const Truth truth = draw(random);
    PointNoise noise;
    const std::vector<CurvePoint> points = measure(truth, random, noise);
    const auto fitted = fitStroke(points, Stroke::press, fitOptionsFor(FitEffort::standard, noise));
    if (!fitted) continue;
    const FittedTactilePoint* nearest = nullptr;
    for (const FittedTactilePoint& p : fitted->summary.tactilePoints)
      if (std::abs(p.point.displacement_mm - truth.tactile.displacement_mm) < 0.3) nearest = &p;
    if (nearest == nullptr) continue;
    place.add(nearest->point.displacement_mm, nearest->sigma_mm, truth.tactile.displacement_mm);
    force.add(nearest->point.force_N, nearest->sigma_N, truth.tactile.force_N);
  }
  std::printf("| %s: place | %zu | %s |\n", kind, place.count(), place.text().c_str());
  std::printf("| %s: force | %zu | %s |\n", kind, force.count(), force.text().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const int strokes = argc > 1 ? std::atoi(argv[1]) : 400;
  if (strokes < 1) {
    std::fprintf(stderr, "detent_fit_coverage [STROKES]: %s is no number above 0\n", argv[1]);
    return 2;
  }
  const auto log = [](int samples, double noise_N) {
    return [=](const Truth& truth, std::mt19937& random, PointNoise& noise) {
      noise = {truth.travel_mm / (samples - 1) / std::sqrt(12.0), noise_N};
      return logged(truth, samples, noise_N, random);
    };
  };
  const auto trace = [](double noise_px, double shared) {
    return [=](const Truth& truth, std::mt19937& random, PointNoise& noise) {
      return traced(truth, noise_px, shared, random, noise);
    };
  };
  std::printf(
      "\n### Tactile points of the fit, level standard\n\n| stroke, estimate | N | within 68.3 %% | within "
      "95.0 %% |\n|---|---|---|---|\n");
  count("log, 400 samples, 2 mN", strokes, bump, log(400, 0.002));
  count("log, 1000 samples, 5 mN", strokes, bump, log(1000, 0.005));
  count("log of cubics, 400 samples, 2 mN", strokes, cubics, log(400, 0.002));
  count("trace, 0.3 px, independent", strokes, bump, trace(0.3, 0));
  count("trace, 0.3 px, shared by neighbours", strokes, bump, trace(0.3, 0.7));
  count("trace of cubics, 0.3 px, shared", strokes, cubics, trace(0.3, 0.7));
}
