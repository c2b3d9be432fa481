// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/stroke_table.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "model/check.h"

namespace detent::playback {

namespace {

// Least number of displacements at which table and curve are compared; every knot is added.
constexpr std::size_t strokeSamples = 4096;

// A table with an error below this share of the force range is good enough; more vertices would only use
// cache.
constexpr double enoughOfRange = 1e-5;

/// The curve at all examined displacements; a vertical rise is two samples at one displacement.
std::vector<TablePoint> sampleDensely(const StrokeCurve& curve, double from_mm, double to_mm, double lowest_N,
                                      const std::vector<double>& kept_mm) {
  std::vector<double> positions;
  for (std::size_t i = 0; i <= strokeSamples; ++i) {
    positions.push_back(i == strokeSamples ? to_mm
                                           : from_mm + (to_mm - from_mm) * static_cast<double>(i) /
                                                           static_cast<double>(strokeSamples));
  }
  const auto evenPlaces = static_cast<std::ptrdiff_t>(positions.size());
  const std::vector<Knot>& knots = curve.knots();
  for (const Knot& knot : knots) positions.push_back(knot.displacement_mm);
  // A piece narrower than the even spacing also has a minimum or maximum between its knots.
  for (std::size_t i = 1; i < knots.size() && knots.size() < strokeSamples; ++i)
    for (const double share : {0.25, 0.5, 0.75})
      positions.push_back(knots[i - 1].displacement_mm +
                          share * (knots[i].displacement_mm - knots[i - 1].displacement_mm));
  positions.insert(positions.end(), kept_mm.begin(), kept_mm.end());
  std::sort(positions.begin() + evenPlaces, positions.end());
  std::inplace_merge(positions.begin(), positions.begin() + evenPlaces, positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());

  std::vector<TablePoint> samples;
  const auto put = [&](double x, double force) { samples.push_back({x, std::max(force, lowest_N)}); };
  auto knot = knots.begin();
  for (double x : positions) {
    if (x < from_mm || x > to_mm) continue;
    while (knot != knots.end() && knot->displacement_mm < x) ++knot;
    const double after = curve.force_N(x);
    if (knot != knots.end() && knot->displacement_mm == x)  // the only places that can be vertical
      if (const double before = curve.forceBefore_N(x); before != after) put(x, before);
    put(x, after);
  }
  return samples;
}

/// A run of samples between two chosen vertices, with the sample farthest from the chord between them.
struct Gap {
  std::size_t from = 0, to = 0, worst = 0;
  double error_N = 0;
  bool operator<(const Gap& other) const {
    return error_N != other.error_N ? error_N < other.error_N : from > other.from;
  }
};

Gap measure(const std::vector<TablePoint>& s, std::size_t from, std::size_t to) {
  Gap gap{from, to, from, 0};
  const double span = s[to].displacement_mm - s[from].displacement_mm;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double share = span > 0 ? (s[i].displacement_mm - s[from].displacement_mm) / span : 0;
    const double error =
        std::fabs(s[from].force_N + share * (s[to].force_N - s[from].force_N) - s[i].force_N);
    if (error > gap.error_N) {
      gap.error_N = error;
      gap.worst = i;
    }
  }
  return gap;
}

/// Samples that must be vertices: the ends, the caller's kept displacements, and both sides of the largest
/// vertical rises.
std::vector<std::size_t> fixedVertices(const std::vector<TablePoint>& s, const std::vector<double>& kept_mm) {
  std::vector<std::size_t> fixed{0, s.size() - 1};
  for (double x : kept_mm) {
    const auto at = [&](const TablePoint& p, double v) { return p.displacement_mm < v; };
    auto it = std::lower_bound(s.begin(), s.end(), x, at);
    for (; it != s.end() && it->displacement_mm == x; ++it) {
      fixed.push_back(static_cast<std::size_t>(it - s.begin()));
    }
  }
  std::sort(fixed.begin(), fixed.end());
  fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
  return fixed;
}

}  // namespace

TableFit fitTable(const StrokeCurve& curve, double from_mm, double to_mm, double lowest_N,
                  const std::vector<double>& kept_mm) {
  DETENT_CHECK(from_mm < to_mm, "a table covers some travel");
  DETENT_CHECK(kept_mm.size() <= maxTablePoints / 4, "kept places leave room for the curve");
  const std::vector<TablePoint> samples = sampleDensely(curve, from_mm, to_mm, lowest_N, kept_mm);
  const auto [low, high] =
      std::minmax_element(samples.begin(), samples.end(),
                          [](const TablePoint& a, const TablePoint& b) { return a.force_N < b.force_N; });
  const double enough_N = enoughOfRange * (high->force_N - low->force_N);

  // Repeatedly splits the worst gap at its worst sample (greedy Ramer-Douglas-Peucker with a limited number
  // of vertices).
  std::vector<std::size_t> chosen = fixedVertices(samples, kept_mm);
  std::priority_queue<Gap> gaps;
  for (std::size_t i = 1; i < chosen.size(); ++i) gaps.push(measure(samples, chosen[i - 1], chosen[i]));
  while (chosen.size() < maxTablePoints && !gaps.empty() && gaps.top().error_N > enough_N) {
    const Gap worst = gaps.top();
    gaps.pop();
    chosen.push_back(worst.worst);
    gaps.push(measure(samples, worst.from, worst.worst));
    gaps.push(measure(samples, worst.worst, worst.to));
  }
  std::sort(chosen.begin(), chosen.end());

  TableFit fit;
  fit.error_N = gaps.empty() ? 0 : gaps.top().error_N;
  for (std::size_t i : chosen) fit.points.push_back(samples[i]);
  return fit;
}

}  // namespace detent::playback
