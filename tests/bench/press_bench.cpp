// SPDX-License-Identifier: GPL-3.0-or-later
// The forecast of a press against published effects; prints the table of docs/reference/press-forecast.md,
// "Effects".
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/button.h"
#include "playback/performance/forecast.h"

namespace {

using namespace detent;
using namespace detent::playback;

StrokeCurve straight(const std::vector<CurvePoint>& points) {
  std::vector<Knot> knots;
  for (const CurvePoint& p : points) knots.push_back({p.displacement_mm, p.force_N, 0, 0});
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double slope =
        (knots[i].force_N - knots[i - 1].force_N) / (knots[i].displacement_mm - knots[i - 1].displacement_mm);
    knots[i - 1].slopeAfter_N_per_mm = slope;
    knots[i].slopeBefore_N_per_mm = slope;
  }
  Result<StrokeCurve> curve = StrokeCurve::fromKnots(std::move(knots));
  if (!curve) throw std::runtime_error(curve.failure().sentence());
  return *std::move(curve);
}

/// The keys of docs/reference/press-forecast.md, "Criterion of success"; tactile: with the drop of effect 10.
Button key(double make_N, double travel_mm, bool tactile = false) {
  std::vector<CurvePoint> points = {{0, 0.6 * make_N}};
  if (tactile) {
    points.push_back({0.4 * travel_mm, make_N});
    points.push_back({0.4 * travel_mm + 0.5, 0.75 * make_N});
  } else {
    points.push_back({0.5 * travel_mm, make_N});
  }
  points.push_back({travel_mm, 1.25 * make_N});
  std::vector<CurvePoint> back = points;
  for (CurvePoint& p : back) p.force_N *= 0.9;
  Result<ForceGraph> graph = ForceGraph::fromCurves(straight(points), straight(back));
  if (!graph) throw std::runtime_error(graph.failure().sentence());
  Result<Button> button =
      Button::fromStates("key", {ButtonState{"", *graph, 0.5 * travel_mm, 0.5 * travel_mm - 0.1, {}}});
  if (!button) throw std::runtime_error(button.failure().sentence());
  return *std::move(button);
}

unsigned threads = 0;  // 0: as many as there are cores; the table is the same for any number

PressForecast pressed(const Button& button, std::optional<double> period_s = {}) {
  ForecastSettings settings;
  settings.period_s = period_s;
  settings.threads = threads;
  return *forecastPress(button, settings);
}

Band ratio(const PressForecast& second, const PressForecast& first, PressFigure figure) {
  return differenceOf(first, second, figure).ratio;
}

Band scaled(const Band& band, double factor) {
  return {band.median * factor, band.low * factor, band.high * factor};
}

bool higher(const Band& b) { return b.low >= 1 + claimedFrom; }
bool lower(const Band& b) { return b.high <= 1 - claimedFrom; }
bool alike(const Band& b) { return b.low >= 1 - claimedFrom && b.high <= 1 + claimedFrom; }

void row(int number, const char* question, const Band& band, const char* people, bool hit) {
  std::printf("| %d | %s | %.2f (%.2f to %.2f) | %s | %s |\n", number, question, band.median, band.low,
              band.high, people, hit ? "yes" : "**missed**");
}

int hits = 0;  // number of effects forecast in the direction that people showed
void effect(int number, const char* question, const Band& band, const char* people, bool hit) {
  hits += hit ? 1 : 0;
  row(number, question, band, people, hit);
}

/// A second condition of the effect above: both must hold, counted there.
void also(int number, const char* question, const Band& band, const char* people, bool hit) {
  row(number, question, band, people, hit);
}

Band impactAgainstMake(const PressForecast& forecast) {
  std::vector<double> ratios;
  for (const PressPlan& plan : forecast.plans)
    ratios.push_back(plan.result.impactSpread_s / plan.result.commandToActivationSpread_s);
  return bandOf(std::move(ratios));
}

Band errorsRatio(const PressForecast& second, const PressForecast& first) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < first.plans.size(); ++i) {
    const auto of = [&](const PressForecast& f) {
      return 1 + f[PressFigure::misses][i] + f[PressFigure::accidental][i];
    };
    ratios.push_back(of(second) / of(first));
  }
  return bandOf(std::move(ratios));
}

void forces() {
  const PressForecast f28 = pressed(key(0.28, 4)), f34 = pressed(key(0.34, 4)), f47 = pressed(key(0.47, 4));
  const PressForecast f83 = pressed(key(0.83, 4)), f102 = pressed(key(1.02, 4));
  const Band first = ratio(f47, f34, PressFigure::peakForce);
  effect(1, "peak force, 0.47 : 0.34 N", first, "no difference", alike(first));
  const Band second = ratio(f102, f47, PressFigure::peakForce);
  effect(2, "peak force, 1.02 : 0.47 N", second, "1.40", higher(second));
  const Band third = ratio(f83, f28, PressFigure::peakForce);
  effect(3, "peak force, 0.83 : 0.28 N", third, "higher", higher(third));
  const Band fourth = scaled(third, 0.28 / 0.83);
  effect(4, "(force : make force), 0.83 : 0.28 N", fourth, "lower", lower(fourth));
}

void travels() {
  const PressForecast short2 = pressed(key(0.6, 2)), long4 = pressed(key(0.6, 4)),
                      ultra = pressed(key(0.6, 0.5));
  const Band time = ratio(long4, short2, PressFigure::timePerPress);
  const Band force = ratio(long4, short2, PressFigure::peakForce);
  effect(5, "time per correct press, 4.0 : 2.0 mm", time, "no difference", alike(time) && higher(force));
  also(5, "peak force, 4.0 : 2.0 mm", force, "higher", higher(force));
  std::vector<double> differences;
  for (std::size_t i = 0; i < ultra.plans.size(); ++i)
    differences.push_back(short2[PressFigure::peakForce][i] - ultra[PressFigure::peakForce][i]);
  const Band between = bandOf(std::move(differences));
  effect(6, "peak force, 2.0 minus 0.5 mm, N", between, "within 0.5 N",
         between.low > -0.5 && between.high < 0.5);
}

void paces() {
  const PressForecast slow = pressed(key(0.6, 4), 0.4), fast = pressed(key(0.6, 4), 0.2);
  if (slow.plans.empty() || fast.plans.empty()) {
    std::printf(
        "| 7 | peak force, period 200 : 400 ms | not every finger keeps the pace | higher | **missed** |\n");
  } else {
    const Band band = ratio(fast, slow, PressFigure::peakForce);
    effect(7, "peak force, period 200 : 400 ms", band, "higher", higher(band));
  }
  const PressForecast light = pressed(key(0.3, 4)), firm = pressed(key(0.8, 4));
  const Band rate = ratio(firm, light, PressFigure::highestRate);
  const Band accidental = ratio(firm, light, PressFigure::accidental);
  effect(8, "highest rate, 0.8 : 0.3 N", rate, "lower", lower(rate) && lower(accidental));
  also(8, "accidental activations, 0.8 : 0.3 N", accidental, "lower", lower(accidental));
}

void feel() {
  constexpr double newtonPerGramForce = 0.00980665;
  const PressForecast g35 = pressed(key(35 * newtonPerGramForce, 4)),
                      g50 = pressed(key(50 * newtonPerGramForce, 4));
  const Band slower = ratio(g35, g50, PressFigure::timePerPress), errors = errorsRatio(g35, g50);
  effect(9, "time per correct press, 35 : 50 g", slower, "1.041", slower.low > 1 && higher(errors));
  also(9, "accidental and missed, 35 : 50 g", errors, "higher", higher(errors));
  const PressForecast linear = pressed(key(0.6, 4)), tactile = pressed(key(0.6, 4, true));
  const Band faster = ratio(tactile, linear, PressFigure::timePerPress);
  const Band misses = ratio(tactile, linear, PressFigure::misses);
  effect(10, "time per correct press, tactile : linear", faster, "lower", faster.high < 1 && lower(misses));
  also(10, "misses, tactile : linear", misses, "lower", lower(misses));
  const Band impact = impactAgainstMake(linear);
  effect(11, "spread of time, impact : operating point", impact, "0.06 to 0.63", lower(impact));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) threads = static_cast<unsigned>(std::atoi(argv[1]));
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::printf(
      "| # | asked | forecast, median (5 to 95 %%) | people | forecast as people did "
      "|\n|---|---|---|---|---|\n");
  forces();
  travels();
  paces();
  feel();
  std::printf("\n%d of 11 effects are forecast; the bar is 8.\n", hits);
  return 0;
}
