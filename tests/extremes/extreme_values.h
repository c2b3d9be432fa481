// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Inputs at the limits: numbers of every size, curves from 1 µm to 100 m and from 1 nN to 10 MN, with
// vertical rises, flats and knots one ulp apart.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include "model/button.h"
#include "tests/model/property.h"

namespace detent::tests {

/// least <= result <= most, all alike from the first case on (rapidcheck by itself begins with the small
/// ones).
template <class Integer>
Integer anyOf(Integer least, Integer most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Integer>(least, most + 1));
}
inline int count(int least, int most) { return anyOf(least, most); }
inline bool oneIn(int cases) { return anyOf(1, cases) == cases; }
/// In [0, 1).
inline double share() {
  return static_cast<double>(anyOf<std::int64_t>(0, (std::int64_t{1} << 52) - 1)) * 0x1p-52;
}
inline double within(double low, double high) { return low + (high - low) * share(); }

/// Every power of ten between two positive values alike.
inline double magnitude(double least, double most) {
  return std::clamp(std::exp(within(std::log(least), std::log(most))), least, most);
}

/// Any bits: denormals, infinities and NaN among them, and the values people meet most.
inline double anyDouble() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double known[] = {0.0,
                              -0.0,
                              1.0,
                              -1.0,
                              1e308,
                              -1e308,
                              5e-324,
                              -5e-324,
                              2.3e-308,
                              0x1p53,
                              0x1p63,
                              0x1p64,
                              1e9,
                              -1e9,
                              infinity,
                              -infinity,
                              std::numeric_limits<double>::quiet_NaN(),
                              1e-9,
                              4.0,
                              1e5};
  if (oneIn(2)) return known[anyOf<std::size_t>(0, std::size(known) - 1)];
  return std::bit_cast<double>(*rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
}

inline double anyFinite() {
  const double value = anyDouble();
  return std::isfinite(value) ? value : 0;
}

/// Size of a button; within the limits of a ForceGraph.
struct Size {
  double travel_mm = 4, force_N = 1;
};
inline Size anySize() { return {magnitude(1e-3, 1e5), magnitude(1e-9, 1e6)}; }

/// Output of a failing case beside its random numbers.
inline void logKnots(const StrokeCurve& curve) {
  std::string text = "knots (mm, N, N/mm, N/mm):";
  char line[120];
  for (const Knot& k : curve.knots()) {
    std::snprintf(line, sizeof line, " {%.17g, %.17g, %.9g, %.9g}", k.displacement_mm, k.force_N,
                  k.slopeBefore_N_per_mm, k.slopeAfter_N_per_mm);
    text += line;
  }
  RC_LOG(text);
}

/// 2 to 12 knots over a travel from 0 mm on; forces mostly up to the size's, never above ten times it. One
/// knot in eight makes a vertical rise, one in eight a flat, one in ten is 1 to 4 ulp behind the one before.
inline StrokeCurve extremeCurve(Size size) {
  const int knotCount = count(2, 12);
  std::vector<double> positions_mm{0};
  for (int i = 2; i < knotCount; ++i) positions_mm.push_back(size.travel_mm * share());
  positions_mm.push_back(size.travel_mm);
  std::sort(positions_mm.begin(), positions_mm.end());
  std::vector<Knot> knots;
  for (double x : positions_mm) {
    const bool first = knots.empty(), last = x == size.travel_mm;
    if (!first && !last && knots.back().displacement_mm > 0 && oneIn(10))
      for (int k = count(1, 4), i = 0; i < k; ++i)
        x = std::nextafter(i == 0 ? knots.back().displacement_mm : x, size.travel_mm);
    if (!first && x < knots.back().displacement_mm) continue;
    const double slope = within(-4, 4) * size.force_N / size.travel_mm;
    Knot knot{x, within(-0.2, 1) * size.force_N, slope,
              oneIn(3) ? within(-4, 4) * size.force_N / size.travel_mm : slope};
    const bool repeated = !first && x == knots.back().displacement_mm;
    if (repeated && knots.size() >= 2 && knots[knots.size() - 2].displacement_mm == x) continue;
    if (!first && !repeated && oneIn(8)) {
      knot.force_N = knots.back().force_N;
      knot.slopeBefore_N_per_mm = knots.back().slopeAfter_N_per_mm = 0;
    }
    knots.push_back(knot);
    if (!last && !repeated && oneIn(8)) {
      knot.force_N = within(-0.2, 1) * size.force_N;
      knots.push_back(knot);
    }
  }
  Result<StrokeCurve> curve = StrokeCurve::fromKnots(std::move(knots));
  if (!curve) RC_FAIL(curve.failure().sentence());
  logKnots(*curve);
  return *std::move(curve);
}

inline StrokeCurve extremeCurve() { return extremeCurve(anySize()); }

/// Press, and in three of four a release of its own.
inline ForceGraph extremeGraph(Size size) {
  StrokeCurve press = extremeCurve(size);
  std::optional<StrokeCurve> release;
  if (!oneIn(4)) release = extremeCurve(size);
  Result<ForceGraph> graph = ForceGraph::fromCurves(std::move(press), std::move(release));
  if (!graph) RC_FAIL(graph.failure().sentence());
  return *std::move(graph);
}
inline ForceGraph extremeGraph() { return extremeGraph(anySize()); }

/// One state or two, with contacts and damping in half of them.
inline Button extremeButton(Size size) {
  std::vector<ButtonState> states;
  const bool locking = oneIn(3);
  for (int i = 0; i <= (locking ? 1 : 0); ++i) {
    ButtonState state{locking ? (i == 0 ? "unlocked" : "locked") : "", extremeGraph(size), {}, {}, {}};
    if (oneIn(2)) state.operatingPoint_mm = within(0, size.travel_mm);
    if (oneIn(2)) state.resetPoint_mm = within(0, size.travel_mm);
    if (oneIn(2))
      state.damping = {{0, magnitude(1e-9, 1) * size.force_N / size.travel_mm},
                       {size.travel_mm, magnitude(1e-9, 1) * size.force_N / size.travel_mm}};
    states.push_back(std::move(state));
  }
  Result<Button> button = Button::fromStates("extreme", std::move(states));
  if (!button) RC_FAIL(button.failure().sentence());
  return *std::move(button);
}
inline Button extremeButton() { return extremeButton(anySize()); }

/// Asserts that a failure names its cause and a remedy.
inline void assertNamed(const Failure& failure) {
  RC_ASSERT(!failure.problem.empty());
  RC_ASSERT(!failure.sentence().empty());
  RC_ASSERT(failure.code != FailureCode::internalFault);
}

/// Equal but for rounding: `share` of the larger of both and `size`.
inline bool alike(double a, double b, double share, double size = 0) {
  return std::abs(a - b) <= share * std::max({std::abs(a), std::abs(b), size});
}

/// The curve with all forces and displacements times powers of two: every bit of every result must follow.
inline StrokeCurve scaledCurve(const StrokeCurve& curve, double mm, double newton) {
  std::vector<Knot> knots = curve.knots();
  for (Knot& k : knots)
    k = {k.displacement_mm * mm, k.force_N * newton, k.slopeBefore_N_per_mm * (newton / mm),
         k.slopeAfter_N_per_mm * (newton / mm)};
  Result<StrokeCurve> scaled = StrokeCurve::fromKnots(std::move(knots));
  if (!scaled) RC_FAIL(scaled.failure().sentence());
  return *std::move(scaled);
}

}  // namespace detent::tests
