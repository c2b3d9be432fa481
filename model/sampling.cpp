// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sampling.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "model/check.h"

namespace detent {
namespace {

constexpr std::size_t maxSamplesPerPiece = 100000;

// Number of straight parts of a cubic piece within the tolerance; the chord error is at most max|F''| du^2 /
// 8.
std::size_t partsOf(const Knot& a, const Knot& b, double tolerance_N) {
  const double length = b.displacement_mm - a.displacement_mm;
  const double t0 = a.slopeAfter_N_per_mm * length, t1 = b.slopeBefore_N_per_mm * length;
  const double rise = b.force_N - a.force_N;
  const double bend = std::max(std::abs(6 * rise - 4 * t0 - 2 * t1), std::abs(-6 * rise + 2 * t0 + 4 * t1));
  const double parts = std::ceil(std::sqrt(bend / (8 * tolerance_N)));
  return static_cast<std::size_t>(std::clamp(parts, 1.0, static_cast<double>(maxSamplesPerPiece)));
}

void appendIfNew(std::vector<CurvePoint>& points, CurvePoint point) {
  if (points.empty() || !(points.back() == point)) points.push_back(point);
}

// ---- from points to a curve

// One cubic between two points: exact at both, free slopes, least squares over the points between.
struct Span {
  std::size_t first, last;
  double slopeFirst, slopeLast;  // N/mm
};

double hermite(CurvePoint a, CurvePoint b, double slopeA, double slopeB, double x) {
  const double length = b.displacement_mm - a.displacement_mm, u = (x - a.displacement_mm) / length,
               v = 1 - u;
  return a.force_N * (v * v * (1 + 2 * u)) + b.force_N * (u * u * (1 + 2 * v)) +
         length * (slopeA * (u * v * v) - slopeB * (u * u * v));
}

// Parabola for a single point between two; two free slopes would be one too many.
Span parabola(const std::vector<CurvePoint>& points, std::size_t first) {
  const CurvePoint a = points[first], m = points[first + 1], b = points[first + 2];
  const double length = b.displacement_mm - a.displacement_mm, chord = (b.force_N - a.force_N) / length;
  const double before = (m.force_N - a.force_N) / (m.displacement_mm - a.displacement_mm);
  const double after = (b.force_N - m.force_N) / (b.displacement_mm - m.displacement_mm);
  const double bend = after - before;
  const Span span{first, first + 2, chord - bend, chord + bend};
  const bool finite = std::isfinite(span.slopeFirst) && std::isfinite(span.slopeLast);
  return finite ? span : Span{first, first + 2, chord, chord};
}

Span leastSquares(const std::vector<CurvePoint>& points, std::size_t first, std::size_t last) {
  if (last == first + 2) return parabola(points, first);
  const CurvePoint a = points[first], b = points[last];
  const double length = b.displacement_mm - a.displacement_mm, chord = (b.force_N - a.force_N) / length;
  double aa = 0, ab = 0, bb = 0, ra = 0, rb = 0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double u = (points[i].displacement_mm - a.displacement_mm) / length, v = 1 - u;
    const double ca = length * u * v * v, cb = -length * u * u * v;
    const double rest = points[i].force_N - hermite(a, b, 0, 0, points[i].displacement_mm);
    aa += ca * ca;
    ab += ca * cb;
    bb += cb * cb;
    ra += ca * rest;
    rb += cb * rest;
  }
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > 1e-12 * aa * bb)) return {first, last, chord, chord};
  const Span span{first, last, (ra * bb - rb * ab) / determinant, (rb * aa - ra * ab) / determinant};
  const bool finite = std::isfinite(span.slopeFirst) && std::isfinite(span.slopeLast);
  return finite ? span : Span{first, last, chord, chord};
}

bool holds(const std::vector<CurvePoint>& points, const Span& span, double tolerance_N) {
  const CurvePoint a = points[span.first], b = points[span.last];
  for (std::size_t i = span.first; i < span.last; ++i) {
    const CurvePoint p = points[i], q = points[i + 1];
    for (double share : {0.25, 0.5, 0.75, 1.0}) {
      const double x = share == 1.0 ? q.displacement_mm
                                    : p.displacement_mm + share * (q.displacement_mm - p.displacement_mm);
      const double line = p.force_N + share * (q.force_N - p.force_N);
      const double off = std::abs(hermite(a, b, span.slopeFirst, span.slopeLast, x) - line);
      if (!(off <= (share == 1.0 ? tolerance_N : 2 * tolerance_N))) return false;
    }
  }
  return true;
}

std::optional<Span> spanIfGood(const std::vector<CurvePoint>& points, std::size_t first, std::size_t last,
                               double tolerance_N) {
  const Span span = leastSquares(points, first, last);
  if (holds(points, span, tolerance_N)) return span;
  return {};
}

// Returns the longest span within the tolerance from a point on, by galloping and bisection. Two points
// always make one.
Span longestSpan(const std::vector<CurvePoint>& points, std::size_t first, std::size_t limit,
                 double tolerance_N) {
  Span best = leastSquares(points, first, first + 1);
  std::size_t step = 2, bad = limit + 1;
  while (best.last < limit) {
    const std::size_t candidate = std::min(first + step, limit);
    const auto span = spanIfGood(points, first, candidate, tolerance_N);
    if (!span) {
      bad = candidate;
      break;
    }
    best = *span;
    step *= 2;
  }
  while (bad <= limit && bad - best.last > 1) {
    const std::size_t middle = best.last + (bad - best.last) / 2;
    if (const auto span = spanIfGood(points, first, middle, tolerance_N))
      best = *span;
    else
      bad = middle;
  }
  return best;
}

// Gives two spans that meet with nearly one slope exactly one slope, if the tolerance allows.
void joinSmoothly(const std::vector<CurvePoint>& points, std::vector<Span>& spans, double tolerance_N) {
  for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
    Span before = spans[i], after = spans[i + 1];
    if (before.last != after.first) continue;
    const double mean = 0.5 * (before.slopeLast + after.slopeFirst);
    before.slopeLast = after.slopeFirst = mean;
    if (!holds(points, before, tolerance_N) || !holds(points, after, tolerance_N)) continue;
    spans[i] = before;
    spans[i + 1] = after;
  }
}

struct CleanPoints {
  std::vector<CurvePoint> points;
  std::optional<PointFault> fault;
};

// Removes repeated points and inner points of vertical pieces.
CleanPoints cleaned(const std::vector<CurvePoint>& points) {
  std::vector<CurvePoint> clean;
  const auto pointFault = [](std::size_t index, Message problem, Remedies remedies) {
    return CleanPoints{{}, PointFault{index, std::move(problem), std::move(remedies)}};
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint p = points[i];
    if (!std::isfinite(p.displacement_mm) || !std::isfinite(p.force_N))
      return pointFault(i, Message("one of the two values is not a usable number"),
                        Message("Remove the point"));
    if (!clean.empty() && p.displacement_mm < clean.back().displacement_mm)
      return pointFault(
          i,
          Message("the displacement %1 lies before that of the previous point, %2",
                  millimetres(p.displacement_mm), millimetres(clean.back().displacement_mm)),
          Message("Put the points of the stroke into the order of the movement, or let detent-import fit a "
                  "curve to them (in the window: File > Import a datasheet)"));
    if (!clean.empty() && clean.back() == p) continue;
    const std::size_t n = clean.size();
    const bool third = n >= 2 && clean[n - 1].displacement_mm == p.displacement_mm &&
                       clean[n - 2].displacement_mm == p.displacement_mm;
    if (third) {
      const bool goesOn = (clean[n - 1].force_N > clean[n - 2].force_N) == (p.force_N > clean[n - 1].force_N);
      if (!goesOn)
        return pointFault(i,
                          Message("the force reverses its direction inside a vertical rise at %1",
                                  millimetres(p.displacement_mm)),
                          Message("Keep one force at each displacement, or let detent-import fit a curve to "
                                  "the points (in the window: File > Import a datasheet)"));
      clean.pop_back();
    }
    clean.push_back(p);
  }
  return {std::move(clean), {}};
}

std::vector<Knot> knotsFrom(const std::vector<CurvePoint>& points, const std::vector<Span>& spans) {
  std::vector<Knot> knots;
  const auto knotAt = [&](std::size_t index, double slope) {
    return Knot{points[index].displacement_mm, points[index].force_N, slope, slope};
  };
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Span& span = spans[i];
    if (i == 0 || spans[i - 1].last != span.first)
      knots.push_back(knotAt(span.first, span.slopeFirst));
    else
      knots.back().slopeAfter_N_per_mm = span.slopeFirst;
    knots.push_back(knotAt(span.last, span.slopeLast));
  }
  return knots;
}

}  // namespace

std::vector<CurvePoint> samplesOf(const StrokeCurve& curve, double tolerance_N) {
  DETENT_CHECK(tolerance_N > 0, "tolerance_N > 0");
  std::vector<CurvePoint> turns = curve.localMaxima();
  for (const CurvePoint& p : curve.localMinima()) turns.push_back(p);
  std::sort(turns.begin(), turns.end(),
            [](const CurvePoint& a, const CurvePoint& b) { return a.displacement_mm < b.displacement_mm; });
  auto turn = turns.begin();
  std::vector<CurvePoint> points;
  const std::vector<Knot>& knots = curve.knots();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Knot &a = knots[i], &b = knots[i + 1];
    appendIfNew(points, {a.displacement_mm, a.force_N});
    if (a.displacement_mm == b.displacement_mm) continue;
    const std::size_t parts = partsOf(a, b, tolerance_N);
    for (std::size_t k = 1; k <= parts; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(parts);
      const double x = k == parts ? b.displacement_mm
                                  : a.displacement_mm + share * (b.displacement_mm - a.displacement_mm);
      for (; turn != turns.end() && turn->displacement_mm < x; ++turn)
        if (turn->displacement_mm > points.back().displacement_mm) points.push_back(*turn);
      // Between knots one ulp apart a place may round to the next knot, which has its own point.
      if (x > points.back().displacement_mm && x < b.displacement_mm) points.push_back({x, curve.force_N(x)});
    }
  }
  appendIfNew(points, {knots.back().displacement_mm, knots.back().force_N});
  return points;
}

std::vector<CurvePoint> travelledSamples(const ForceGraph& graph, Stroke stroke) {
  auto [low, high] = graph.press().forceRange_N();
  if (graph.release()) {
    const auto [releaseLow, releaseHigh] = graph.release()->forceRange_N();
    low = std::min(low, releaseLow);
    high = std::max(high, releaseHigh);
  }
  const double tolerance_N = std::max(samplingTolerance * (high - low), std::numeric_limits<double>::min());
  std::vector<CurvePoint> points = samplesOf(graph.curve(stroke), tolerance_N);
  if (stroke == Stroke::release) std::reverse(points.begin(), points.end());
  return points;
}

Result<StrokeCurve> curveThroughDensePoints(const std::vector<CurvePoint>& points, double tolerance_N) {
  DETENT_CHECK(tolerance_N > 0, "tolerance_N > 0");
  const auto [clean, fault] = cleaned(points);
  if (fault)
    return Failure{FailureCode::unreadableInput, "points", Message("point %1", fault->index + 1),
                   fault->problem, fault->remedies};
  std::vector<Span> spans;
  for (std::size_t first = 0; first + 1 < clean.size();) {
    if (clean[first].displacement_mm == clean[first + 1].displacement_mm) {  // a vertical piece
      if (spans.empty()) spans.push_back({first, first, 0, 0});
      ++first;
      if (first + 1 == clean.size()) spans.push_back({first, first, 0, 0});
      continue;
    }
    std::size_t limit = first + 1;
    while (limit + 1 < clean.size() && clean[limit].displacement_mm != clean[limit + 1].displacement_mm)
      ++limit;
    while (first < limit) {
      spans.push_back(longestSpan(clean, first, limit, tolerance_N));
      first = spans.back().last;
    }
  }
  joinSmoothly(clean, spans, tolerance_N);
  std::vector<Knot> knots = knotsFrom(clean, spans);
  // A vertical piece at an end is a span of one point, so its knot occurs twice here.
  knots.erase(std::unique(knots.begin(), knots.end(),
                          [](const Knot& a, const Knot& b) {
                            return a.displacement_mm == b.displacement_mm && a.force_N == b.force_N;
                          }),
              knots.end());
  return StrokeCurve::fromKnots(std::move(knots));
}

std::optional<PointFault> faultOf(const std::vector<CurvePoint>& points) { return cleaned(points).fault; }

}  // namespace detent
