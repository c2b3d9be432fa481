// SPDX-License-Identifier: GPL-3.0-or-later
// The model from 1 µm to 100 m and 1 nN to 10 MN: finite in, finite out; one button in any unit; the bounds
// its headers state.

#include <cmath>

#include <catch2/catch.hpp>

#include "model/compare.h"
#include "model/metrics.h"
#include "model/sampling.h"
#include "model/sections.h"
#include "model/templates.h"
#include "model/units.h"
#include "model/validation.h"
#include "tests/extremes/extreme_values.h"

using namespace detent;
using namespace detent::tests;

namespace {

constexpr double rounding = 1e-12;

double spanOf(const StrokeCurve& curve) {
  const auto [low, high] = curve.forceRange_N();
  return std::max(std::abs(low), std::abs(high));
}

double anyPlaceOn(const StrokeCurve& curve) { return within(curve.start_mm(), curve.end_mm()); }

/// Force by Hermite's formula in long double, in the form of the text books.
long double hermite(const Knot& a, const Knot& b, double x) {
  const long double length = static_cast<long double>(b.displacement_mm) - a.displacement_mm;
  const long double u = (static_cast<long double>(x) - a.displacement_mm) / length, v = 1 - u;
  return a.force_N * (v * v * (1 + 2 * u)) + b.force_N * (u * u * (1 + 2 * v)) +
         length * (a.slopeAfter_N_per_mm * (u * v * v) - b.slopeBefore_N_per_mm * (u * u * v));
}

bool isFinite(const StrokeMetrics& m) {
  bool finite = std::isfinite(m.startForce_N) && std::isfinite(m.endForce_N) && std::isfinite(m.minForce_N) &&
                std::isfinite(m.maxForce_N) && std::isfinite(m.work_mJ) &&
                std::isfinite(m.bottomOut.force_N) && std::isfinite(m.bottomOut.displacement_mm);
  for (const TactileEvent& e : m.tactile) {
    finite =
        finite && std::isfinite(e.point.prominence_N) && std::isfinite(e.jumpArea_mJ) && e.jumpArea_mJ >= 0;
    if (e.snapRatio) finite = finite && std::isfinite(*e.snapRatio);
  }
  return finite;
}

}  // namespace

TEST_CASE("any knots make a curve or a failure that says which knot") {
  holdsAlways("fromKnots, any doubles", [] {
    std::vector<Knot> knots;
    for (int i = count(0, 6); i > 0; --i)
      knots.push_back({anyDouble(), anyDouble(), anyDouble(), anyDouble()});
    if (oneIn(2))
      std::sort(knots.begin(), knots.end(),
                [](const Knot& a, const Knot& b) { return a.displacement_mm < b.displacement_mm; });
    const auto curve = StrokeCurve::fromKnots(knots);
    if (!curve) return assertNamed(curve.failure());
    for (const Knot& k : curve->knots()) RC_ASSERT(std::isfinite(curve->force_N(k.displacement_mm)));
  });
  holdsAlways("throughPoints, any doubles", [] {
    std::vector<CurvePoint> points;
    for (int i = count(0, 6); i > 0; --i) points.push_back({anyDouble(), anyDouble()});
    if (oneIn(2))
      std::sort(points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) {
        return a.displacement_mm < b.displacement_mm;
      });
    const auto curve = StrokeCurve::throughPoints(points);
    if (!curve) return assertNamed(curve.failure());
    for (const CurvePoint& p : points) RC_ASSERT(std::isfinite(curve->force_N(p.displacement_mm)));
  });
  holdsAlways("ForceGraph, any two curves", [] {
    const Size size{magnitude(1e-9, 1e9), magnitude(1e-12, 1e12)};
    const auto graph = ForceGraph::fromCurves(
        extremeCurve(size), extremeCurve({size.travel_mm * magnitude(1e-3, 1e3), size.force_N}));
    if (!graph) assertNamed(graph.failure());
  });
}

TEST_CASE("force and slope are finite at every displacement", "[finite]") {
  holdsAlways("force_N, forceBefore_N", [] {
    const StrokeCurve curve = extremeCurve();
    const double x = oneIn(2) ? anyPlaceOn(curve) : anyFinite();
    const auto [low, high] = curve.forceRange_N();
    const double slack = rounding * spanOf(curve);
    for (const double force : {curve.force_N(x), curve.forceBefore_N(x)})
      RC_ASSERT(force >= low - slack && force <= high + slack);
  });
  holdsAlways("slope_N_per_mm, slopeBefore_N_per_mm", [] {
    const StrokeCurve curve = extremeCurve();
    const double x = oneIn(2) ? anyPlaceOn(curve) : anyFinite();
    RC_ASSERT(std::isfinite(curve.slope_N_per_mm(x)));
    RC_ASSERT(std::isfinite(curve.slopeBefore_N_per_mm(x)));
  });
  holdsAlways("force_N against long double", [] {
    const StrokeCurve curve = extremeCurve();
    const std::vector<Knot>& knots = curve.knots();
    const auto piece = anyOf<std::size_t>(0, knots.size() - 2);
    const Knot &a = knots[piece], &b = knots[piece + 1];
    RC_PRE(a.displacement_mm < b.displacement_mm);
    const double x = within(a.displacement_mm, b.displacement_mm);
    RC_PRE(x > a.displacement_mm && x < b.displacement_mm);
    const double length = b.displacement_mm - a.displacement_mm;
    const double terms =
        std::max({std::abs(a.force_N), std::abs(b.force_N), std::abs(a.slopeAfter_N_per_mm) * length,
                  std::abs(b.slopeBefore_N_per_mm) * length});
    RC_ASSERT(std::abs(static_cast<double>(curve.force_N(x) - hermite(a, b, x))) <= 64 * 0x1p-53 * terms);
  });
}

TEST_CASE("what is derived from a curve is finite and in order", "[finite]") {
  holdsAlways("displacementsAt: increasing, each has the force", [] {
    const StrokeCurve curve = extremeCurve();
    const double force = curve.force_N(anyPlaceOn(curve));
    double before = -1;
    for (const double x : curve.displacementsAt(force)) {
      RC_ASSERT(x > before);
      before = x;
      RC_ASSERT(x >= curve.start_mm() && x <= curve.end_mm());
    }
  });
  holdsAlways("monotoneStretches touch and cover the travel", [] {
    const StrokeCurve curve = extremeCurve();
    const auto stretches = curve.monotoneStretches();
    RC_ASSERT(!stretches.empty());
    RC_ASSERT(stretches.front().from_mm == curve.start_mm());
    RC_ASSERT(stretches.back().to_mm == curve.end_mm());
    for (std::size_t i = 1; i < stretches.size(); ++i)
      RC_ASSERT(stretches[i].from_mm == stretches[i - 1].to_mm);
  });
  holdsAlways("displacementIn: there and back", [] {
    const StrokeCurve curve = extremeCurve();
    for (const MonotoneStretch& s : curve.monotoneStretches()) {
      const double force = within(s.fromForce_N, s.toForce_N);
      const double x = curve.displacementIn(s, force);
      RC_ASSERT(x >= s.from_mm && x <= s.to_mm);
      if (s.direction == 0 || s.from_mm == s.to_mm) continue;
      // The force within one step of x to either side encloses the requested one.
      const double before = curve.force_N(std::max(s.from_mm, std::nextafter(x, -1.0)));
      const double after = curve.forceBefore_N(std::min(s.to_mm, std::nextafter(x, 2 * x + 1)));
      const double slack = 1e-9 * spanOf(curve);
      RC_ASSERT(std::min(before, after) - slack <= force && force <= std::max(before, after) + slack);
    }
  });
  holdsAlways("maxima and minima take turns", [] {
    const StrokeCurve curve = extremeCurve();
    const auto maxima = curve.localMaxima(), minima = curve.localMinima();
    RC_ASSERT(maxima.size() <= minima.size() + 1 && minima.size() <= maxima.size() + 1);
  });
  holdsAlways("area_mJ adds up, and turns its sign with the way", [] {
    const StrokeCurve curve = extremeCurve();
    const double a = anyPlaceOn(curve), b = anyPlaceOn(curve), c = anyPlaceOn(curve);
    const double size = spanOf(curve) * curve.travel_mm();
    RC_ASSERT(alike(curve.area_mJ(a, c), curve.area_mJ(a, b) + curve.area_mJ(b, c), rounding, size));
    RC_ASSERT(curve.area_mJ(a, b) == -curve.area_mJ(b, a));
  });
  holdsAlways("areaAbove_mJ: a level takes its rectangle", [] {
    const StrokeCurve curve = extremeCurve();
    const double a = anyPlaceOn(curve), b = anyPlaceOn(curve), level = within(-1, 1) * spanOf(curve);
    RC_ASSERT(alike(curve.areaAbove_mJ(level, a, b), curve.area_mJ(a, b) - level * (b - a), rounding,
                    spanOf(curve) * curve.travel_mm()));
  });
}

TEST_CASE("one button in other units is the same button, bit for bit for powers of two", "[finite]") {
  const auto powerOfTwo = [](int low, int high) { return std::ldexp(1.0, count(low, high)); };
  holdsAlways("curve", [&] {
    const StrokeCurve curve = extremeCurve({magnitude(0.1, 10), magnitude(0.1, 10)});
    const double mm = powerOfTwo(-8, 8), newton = powerOfTwo(-20, 16);
    const StrokeCurve other = scaledCurve(curve, mm, newton);
    const double x = anyPlaceOn(curve);
    RC_ASSERT(other.force_N(x * mm) == curve.force_N(x) * newton);
    RC_ASSERT(other.slope_N_per_mm(x * mm) == curve.slope_N_per_mm(x) * newton / mm);
    RC_ASSERT(other.forceRange_N().second == curve.forceRange_N().second * newton);
    RC_ASSERT(other.area_mJ(0, x * mm) == curve.area_mJ(0, x) * mm * newton);
  });
  holdsAlways("sections", [&] {
    const StrokeCurve curve = extremeCurve({magnitude(0.1, 10), magnitude(0.1, 10)});
    const double mm = powerOfTwo(-8, 8), newton = powerOfTwo(-20, 16);
    const StrokeCurve other = scaledCurve(curve, mm, newton);
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const auto sections = sectionsOf(curve, stroke), others = sectionsOf(other, stroke);
      RC_ASSERT(sections.size() == others.size());
      for (std::size_t i = 0; i < sections.size(); ++i) {
        RC_ASSERT(others[i].kind == sections[i].kind);
        RC_ASSERT(others[i].to_mm == sections[i].to_mm * mm);
        RC_ASSERT(others[i].toForce_N == sections[i].toForce_N * newton);
      }
    }
  });
  holdsAlways("metrics", [&] {
    const StrokeCurve curve = extremeCurve({magnitude(0.1, 10), magnitude(0.1, 10)});
    const double mm = powerOfTwo(-8, 8), newton = powerOfTwo(-20, 16);
    const StrokeMetrics one = metricsOf(curve, Stroke::press),
                        other = metricsOf(scaledCurve(curve, mm, newton), Stroke::press);
    RC_ASSERT(other.work_mJ == one.work_mJ * mm * newton);
    RC_ASSERT(other.tactile.size() == one.tactile.size());
    for (std::size_t i = 0; i < one.tactile.size(); ++i) {
      RC_ASSERT(other.tactile[i].point.displacement_mm == one.tactile[i].point.displacement_mm * mm);
      RC_ASSERT(other.tactile[i].snapRatio == one.tactile[i].snapRatio);
      RC_ASSERT(other.tactile[i].jumpArea_mJ == one.tactile[i].jumpArea_mJ * mm * newton);
    }
  });
  holdsAlways("mm in m, N in kN: the same to rounding", [] {
    const StrokeCurve curve = extremeCurve({4, 1});
    const double x = anyPlaceOn(curve);
    const double steepest = 1e3;  // knots an ulp apart move against each other when they are rounded anew
    RC_PRE(std::abs(curve.slope_N_per_mm(x)) < steepest);
    for (std::size_t i = 1; i < curve.knots().size(); ++i) {
      const double gap = curve.knots()[i].displacement_mm - curve.knots()[i - 1].displacement_mm;
      RC_PRE(gap == 0 || gap > 1e-6);
    }
    const StrokeCurve other = scaledCurve(curve, 1e-3, 1e-3);
    RC_ASSERT(alike(other.force_N(x * 1e-3), curve.force_N(x) * 1e-3, 1e-9, 1e-3));
    RC_ASSERT(alike(other.area_mJ(0, 4e-3), curve.area_mJ(0, 4) * 1e-6, 1e-12, 1e-6));
  });
}

TEST_CASE("sections cover the stroke whatever the curve", "[finite]") {
  holdsAlways("sectionsOf touch and cover", [] {
    const StrokeCurve curve = extremeCurve();
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const auto sections = sectionsOf(curve, stroke);
      RC_ASSERT(!sections.empty());
      const bool press = stroke == Stroke::press;
      RC_ASSERT(sections.front().from_mm == (press ? curve.start_mm() : curve.end_mm()));
      RC_ASSERT(sections.back().to_mm == (press ? curve.end_mm() : curve.start_mm()));
      for (std::size_t i = 1; i < sections.size(); ++i) {
        RC_ASSERT(sections[i].from_mm == sections[i - 1].to_mm);
        RC_ASSERT(sections[i].fromForce_N == sections[i - 1].toForce_N);
      }
    }
  });
  holdsAlways("tactilePoints stand in the order travelled, as prominent as requested", [] {
    const StrokeCurve curve = extremeCurve();
    SectionSettings settings;
    settings.minProminenceOfSpan = within(0, 0.5);
    settings.minProminence_N = oneIn(2) ? 0 : magnitude(1e-9, 1e6);
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      double before = stroke == Stroke::press ? -1 : 2 * curve.end_mm();
      for (const TactilePoint& p : tactilePoints(curve, stroke, settings)) {
        RC_ASSERT((stroke == Stroke::press ? p.displacement_mm > before : p.displacement_mm < before));
        before = p.displacement_mm;
        RC_ASSERT(p.prominence_N > 0 && p.prominence_N >= settings.minProminence_N);
      }
    }
  });
  holdsAlways("bottomOutOf lies on the curve", [] {
    const StrokeCurve curve = extremeCurve();
    const BottomOut rise = bottomOutOf(curve);
    RC_ASSERT(rise.displacement_mm >= curve.start_mm() && rise.displacement_mm <= curve.end_mm());
    RC_ASSERT(std::isfinite(rise.force_N));
    if (!rise.isSteep) RC_ASSERT(rise.displacement_mm == curve.end_mm());
  });
  holdsAlways("jumpArea_mJ is never below 0", [] {
    const StrokeCurve curve = extremeCurve();
    for (const Stroke stroke : {Stroke::press, Stroke::release})
      for (const Section& s : sectionsOf(curve, stroke))
        if (s.kind == SectionKind::jump) {
          const double area = jumpArea_mJ(curve, s);
          RC_ASSERT(std::isfinite(area) && area >= 0);
          RC_ASSERT(area <= 2 * (1 + rounding) * 10 * spanOf(curve) * curve.travel_mm());
        }
  });
}

TEST_CASE("samples keep their tolerance at any size", "[finite]") {
  holdsAlways("samplesOf: straight lines between them stay within the tolerance", [] {
    const StrokeCurve curve = extremeCurve();
    const double tolerance_N = magnitude(1e-4, 1) * spanOf(curve);
    RC_PRE(tolerance_N > 0);
    const auto points = samplesOf(curve, tolerance_N);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const CurvePoint a = points[i - 1], b = points[i];
      RC_ASSERT(b.displacement_mm >= a.displacement_mm);
      if (a.displacement_mm == b.displacement_mm) continue;
      const double part = share(), x = a.displacement_mm + part * (b.displacement_mm - a.displacement_mm);
      if (!(x > a.displacement_mm && x < b.displacement_mm)) continue;
      const double at = (x - a.displacement_mm) / (b.displacement_mm - a.displacement_mm);
      const double line = a.force_N + at * (b.force_N - a.force_N);
      RC_ASSERT(std::abs(curve.force_N(x) - line) <= tolerance_N * (1 + 1e-9) + rounding * spanOf(curve));
    }
  });
  holdsAlways("travelledSamples run in the order travelled", [] {
    const ForceGraph graph = extremeGraph();
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const auto points = travelledSamples(graph, stroke);
      RC_ASSERT(points.size() >= 2u);
      for (std::size_t i = 1; i < points.size(); ++i)
        RC_ASSERT((stroke == Stroke::press ? points[i].displacement_mm >= points[i - 1].displacement_mm
                                           : points[i].displacement_mm <= points[i - 1].displacement_mm));
    }
  });
  holdsAlways("curve to samples to curve, within a thousandth of the force", [] {
    const StrokeCurve curve = extremeCurve();
    const double tolerance_N = samplingTolerance * spanOf(curve);
    RC_PRE(tolerance_N > 0);
    const auto points = samplesOf(curve, tolerance_N);
    const auto again = curveThroughDensePoints(points, tolerance_N);
    if (!again) RC_FAIL(again.failure().sentence());
    for (const CurvePoint& p : points) {
      const double off = std::min(std::abs(again->force_N(p.displacement_mm) - p.force_N),
                                  std::abs(again->forceBefore_N(p.displacement_mm) - p.force_N));
      RC_ASSERT(off <= 10 * tolerance_N);
    }
  });
}

TEST_CASE("any points make a curve through them or name the point that does not") {
  holdsAlways("curveThroughDensePoints, any doubles", [] {
    std::vector<CurvePoint> points;
    for (int i = count(0, 8); i > 0; --i) points.push_back({anyDouble(), anyDouble()});
    if (oneIn(2))
      std::sort(points.begin(), points.end(), [](const CurvePoint& a, const CurvePoint& b) {
        return a.displacement_mm < b.displacement_mm;
      });
    const auto curve = curveThroughDensePoints(points, magnitude(1e-12, 1e12));
    if (!curve) return assertNamed(curve.failure());
    RC_ASSERT(!faultOf(points));
    const auto [low, high] = curve->forceRange_N();
    RC_ASSERT(std::isfinite(low) && std::isfinite(high));
  });
}

TEST_CASE("distances of graphs are finite, none from itself, and keep their shares in any unit", "[finite]") {
  holdsAlways("compare with itself", [] {
    const GraphPolylines lines = polylinesOf(extremeGraph());
    const auto distance = compare(lines, lines);
    RC_ASSERT(distance.ok());
    RC_ASSERT(distance->maxOfSpan <= rounding);
  });
  holdsAlways("compare two", [] {
    const Size size = anySize();
    const GraphPolylines a = polylinesOf(extremeGraph(size)), b = polylinesOf(extremeGraph(size));
    const auto there = compare(a, b);
    RC_ASSERT(there.ok());
    RC_ASSERT(std::isfinite(there->meanOfSpan) && there->meanOfSpan >= 0 &&
              there->meanOfSpan <= there->maxOfSpan * (1 + rounding));
    RC_ASSERT(std::isfinite(there->press->max_mm) && std::isfinite(there->press->max_N));
  });
  holdsAlways("compare in other units", [] {
    const Size size{magnitude(0.1, 10), magnitude(0.1, 10)};
    const StrokeCurve a = extremeCurve(size), b = extremeCurve(size);
    RC_PRE(a.forceRange_N().first <
           a.forceRange_N().second);  // else distances in force have no span to be shares of
    const auto linesOf = [](const StrokeCurve& curve) {
      return polylinesOf(*ForceGraph::fromCurves(curve, {}));
    };
    const auto one = compare(linesOf(a), linesOf(b));
    const auto other =
        compare(linesOf(scaledCurve(a, 0x1p-7, 0x1p9)), linesOf(scaledCurve(b, 0x1p-7, 0x1p9)));
    RC_ASSERT(one.ok() && other.ok());
    RC_ASSERT(other->meanOfSpan == one->meanOfSpan);
    RC_ASSERT(other->press->max_mm == one->press->max_mm * 0x1p-7);
  });
}

TEST_CASE("figures and warnings of any button are finite", "[finite]") {
  holdsAlways("metricsOf", [] {
    const Button button = extremeButton();
    for (const ButtonState& state : button.states()) {
      const StateMetrics metrics = metricsOf(state);
      RC_ASSERT(metrics.travel_mm > 0);
      RC_ASSERT(isFinite(metrics.press));
      if (metrics.release) RC_ASSERT(isFinite(*metrics.release));
      if (metrics.hysteresisArea_mJ) RC_ASSERT(std::isfinite(*metrics.hysteresisArea_mJ));
    }
  });
  holdsAlways("validate", [] {
    for (const Warning& warning : validate(extremeButton())) {
      RC_ASSERT(std::isfinite(warning.value) && std::isfinite(warning.against));
      RC_ASSERT(!warning.sentence().empty());
    }
  });
}

TEST_CASE("any values of a button are taken or refused by name") {
  holdsAlways("Button::fromStates, any contacts and damping", [] {
    ButtonState state{"", extremeGraph(), {}, {}, {}};
    if (oneIn(2)) state.operatingPoint_mm = anyDouble();
    if (oneIn(2)) state.resetPoint_mm = anyDouble();
    for (int i = count(0, 3); i > 0; --i) state.damping.push_back({anyDouble(), anyDouble()});
    const auto button = Button::fromStates("any", {state});
    if (!button) assertNamed(button.failure());
  });
  holdsAlways("linearButton, any values", [] {
    LinearTemplate t;
    t.travel_mm = oneIn(3) ? anyDouble() : magnitude(1e-3, 1e5);
    t.startForce_N = anyDouble(), t.endForce_N = anyDouble(), t.hysteresis_N = anyDouble();
    if (oneIn(2)) t.bottomOutForce_N = anyDouble();
    const auto button = linearButton(t);
    if (!button) assertNamed(button.failure());
  });
  holdsAlways("tactileButton, any values", [] {
    TactileTemplate t;
    t.travel_mm = oneIn(3) ? anyDouble() : magnitude(1e-3, 1e5);
    t.press = {{{anyDouble(), anyDouble()}, {anyDouble(), anyDouble()}}};
    const auto button = tactileButton(t);
    if (!button) assertNamed(button.failure());
  });
  holdsAlways("clickyButton, any values", [] {
    ClickyTemplate t;
    t.travel_mm = oneIn(3) ? anyDouble() : magnitude(1e-3, 1e5);
    t.tactile = {anyDouble(), anyDouble()};
    t.collapse_mm = anyDouble();
    const auto button = clickyButton(t);
    if (!button) assertNamed(button.failure());
  });
  holdsAlways("selfLockingButton, any values", [] {
    SelfLockingTemplate t;
    t.travel_mm = oneIn(3) ? anyDouble() : magnitude(1e-3, 1e5);
    t.lock_mm = anyDouble(), t.lockForce_N = anyDouble();
    const auto button = selfLockingButton(t);
    if (!button) assertNamed(button.failure());
  });
}

TEST_CASE("units turn there and back to rounding", "[finite]") {
  holdsAlways("newtonsPer, millimetresPer", [] {
    const double value = magnitude(1e-300, 1e290);
    for (const ForceUnit unit :
         {ForceUnit::micronewton, ForceUnit::millinewton, ForceUnit::centinewton, ForceUnit::decinewton,
          ForceUnit::newton, ForceUnit::kilonewton, ForceUnit::meganewton, ForceUnit::gramForce,
          ForceUnit::kilogramForce, ForceUnit::ounceForce, ForceUnit::poundForce, ForceUnit::dyne})
      RC_ASSERT(alike(value * newtonsPer(unit) / newtonsPer(unit), value, 4e-16));
    for (const LengthUnit unit :
         {LengthUnit::nanometre, LengthUnit::micrometre, LengthUnit::mil, LengthUnit::millimetre,
          LengthUnit::centimetre, LengthUnit::inch, LengthUnit::metre})
      RC_ASSERT(alike(value * millimetresPer(unit) / millimetresPer(unit), value, 4e-16));
  });
}
