// SPDX-License-Identifier: GPL-3.0-or-later
// The fit over any points: finite, monotone between knots, the same in any unit, and what its headers bound.

#include <cmath>

#include <catch2/catch.hpp>

#include "importer/fit/choose_knots.h"
#include "importer/fit/fit_stroke.h"
#include "importer/fit/segment_stroke.h"
#include "importer/fit/solve_chain.h"
#include "importer/fit/stroke_samples.h"
#include "tests/extremes/extreme_values.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::tests;

namespace {

/// Points along a random curve with noise of its own, and the noise.
struct NoisyStroke {
  std::vector<CurvePoint> points;
  FitOptions options;
};

NoisyStroke noisyStroke(Size size, int least = 8, int most = 120) {
  const StrokeCurve curve = extremeCurve(size);
  NoisyStroke stroke;
  const double noise = magnitude(1e-6, 1e-2);
  stroke.options = fitOptionsFor(FitEffort::draft, {noise * size.travel_mm, noise * size.force_N});
  const int points = count(least, most);
  for (int i = 0; i < points; ++i) {
    const double x = size.travel_mm * i / (points - 1);
    stroke.points.push_back({x + (i == 0 || i == points - 1 ? 0 : within(-0.3, 0.3) * noise * size.travel_mm),
                             curve.force_N(x) + within(-1, 1) * noise * size.force_N});
  }
  return stroke;
}

KnotChain anyChain() {
  KnotChain chain;
  double u = 0;
  for (int i = count(2, 8); i > 0; --i) {
    ChainKnot knot;
    knot.at = {u, within(-100, 100), within(-10, 10) * magnitude(1e-3, 1e3),
               within(-10, 10) * magnitude(1e-3, 1e3)};
    knot.joint = oneIn(3) ? JointKind::corner : oneIn(2) ? JointKind::flat : JointKind::smooth;
    chain.push_back(knot);
    if (!oneIn(6)) u += magnitude(1e-9, 1e3);
  }
  chain.front().joint = chain.back().joint = JointKind::smooth;
  return chain;
}

std::vector<SigmaPoint> pointsNear(const KnotChain& chain) {
  std::vector<SigmaPoint> points;
  const auto pieces = piecesOf(chain);
  for (const ChainPiece& piece : pieces)
    for (int i = 0; i < 12; ++i) {
      const double t = (i + 0.5) / 12;
      points.push_back({piece.u(t), piece.v(t) + within(-2, 2), magnitude(0.1, 10)});
    }
  return points;
}

/// Squared distance of a point from a place of a piece, in long double.
long double squaredDistance(const ChainPiece& piece, long double t, const SigmaPoint& point) {
  const long double d = piece.d, a = piece.a, b = piece.b;
  const long double du = piece.u0 + piece.h * t - point.u;
  const long double dv = piece.v0 + t * (a + t * ((3 * d - 2 * a - b) + t * (a + b - 2 * d))) - point.v;
  return du * du + dv * dv;
}

/// The same from the piece's nearest place, by looking everywhere, then closer.
long double leastSquaredDistance(const ChainPiece& piece, const SigmaPoint& point) {
  constexpr int placeCount = 48;
  int nearest = 0;
  const auto at = [&](long double t) { return squaredDistance(piece, t, point); };
  for (int i = 1; i <= placeCount; ++i)
    if (at(i / static_cast<long double>(placeCount)) < at(nearest / static_cast<long double>(placeCount)))
      nearest = i;
  long double low = std::max(nearest - 1, 0) / static_cast<long double>(placeCount),
              high = std::min(nearest + 1, placeCount) / static_cast<long double>(placeCount);
  for (int i = 0; i < 80; ++i) {  // golden section
    const long double part = 0.381966011250105L * (high - low);
    if (at(low + part) > at(high - part))
      low += part;
    else
      high -= part;
  }
  return std::min({at(0), at(0.5L * (low + high)), at(1)});
}

long double leastSquaredDistance(const std::vector<ChainPiece>& pieces, const SigmaPoint& point) {
  long double least = std::numeric_limits<long double>::infinity();
  for (const ChainPiece& piece : pieces) {
    const double beside = std::max({piece.u0 - point.u, point.u - piece.u0 - piece.h, 0.0});
    if (beside * beside < least) least = std::min(least, leastSquaredDistance(piece, point));
  }
  return least;
}

/// chiSquareOf, in long double.
long double chiSquareReference(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                               long double scale) {
  const std::vector<ChainPiece> pieces = piecesOf(chain);
  long double sum = 0;
  for (const SigmaPoint& point : points) {
    const long double r = point.weight * std::sqrt(leastSquaredDistance(pieces, point));
    sum += r <= scale ? r * r : scale * (2 * r - scale);
  }
  return sum;
}

bool piecesAreMonotone(const StrokeCurve& curve) {
  for (const MonotoneStretch& s : curve.monotoneStretches()) {
    bool atKnot = false;
    for (const Knot& k : curve.knots())
      atKnot = atKnot || alike(k.displacement_mm, s.from_mm, 1e-9, curve.travel_mm());
    if (!atKnot) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("points of any size give a finite fit", "[finite]") {
  holdsAlways("fitStroke, 1 µm to 100 m, 1 nN to 1 MN", [] {
    const NoisyStroke stroke = noisyStroke(anySize());
    const auto fitted = fitStroke(stroke.points, Stroke::press, stroke.options);
    if (!fitted) return assertNamed(fitted.failure());
    RC_ASSERT(piecesAreMonotone(fitted->curve));
    const FitSummary& summary = fitted->summary;
    RC_ASSERT(std::isfinite(summary.rmsSigma) && std::isfinite(summary.maxSigma) &&
              std::isfinite(summary.bic));
    RC_ASSERT(summary.condition >= 1 && summary.condition <= 1.0001e8);
    RC_ASSERT(summary.correlationPoints >= 1);
    RC_ASSERT(summary.pieces == static_cast<int>(fitted->curve.knots().size()) - 1);
    RC_ASSERT(summary.pieces <= stroke.options.maxPieces);
    for (const FittedTactilePoint& p : summary.tactilePoints)
      RC_ASSERT(std::isfinite(p.sigma_mm) && std::isfinite(p.sigma_N) && p.sigma_mm >= 0 && p.sigma_N >= 0);
  });
  holdsAlways("the ends of the curve are the ends of the points, to their noise", [] {
    const Size size = anySize();
    const NoisyStroke stroke = noisyStroke(size);
    const auto fitted = fitStroke(stroke.points, Stroke::press, stroke.options);
    RC_PRE(fitted.ok());
    const double reach = (stroke.options.robustScale + 2) *
                         (stroke.options.noise.sigma_mm + stroke.options.resolutionOfSpan * size.travel_mm);
    RC_ASSERT(std::abs(fitted->curve.start_mm() - stroke.points.front().displacement_mm) <= reach);
    RC_ASSERT(std::abs(fitted->curve.end_mm() - stroke.points.back().displacement_mm) <= reach);
  });
}

TEST_CASE("a fit is the same in any unit, whichever way the points run", "[finite]") {
  holdsAlways("powers of two: the same bits", [] {
    const NoisyStroke stroke = noisyStroke({4, 1});
    const double mm = std::ldexp(1.0, count(-8, 8)), newton = std::ldexp(1.0, count(-12, 12));
    NoisyStroke other = stroke;
    for (CurvePoint& p : other.points) p.displacement_mm *= mm, p.force_N *= newton;
    other.options.noise = {stroke.options.noise.sigma_mm * mm, stroke.options.noise.sigma_N * newton};
    const auto one = fitStroke(stroke.points, Stroke::press, stroke.options);
    const auto two = fitStroke(other.points, Stroke::press, other.options);
    RC_ASSERT(one.ok() == two.ok());
    if (!one) return;
    RC_ASSERT(one->curve.knots().size() == two->curve.knots().size());
    for (std::size_t k = 0; k < one->curve.knots().size(); ++k) {
      RC_ASSERT(two->curve.knots()[k].displacement_mm == one->curve.knots()[k].displacement_mm * mm);
      RC_ASSERT(two->curve.knots()[k].force_N == one->curve.knots()[k].force_N * newton);
    }
  });
  holdsAlways("points turned round", [] {
    NoisyStroke stroke = noisyStroke({4, 1});
    const auto one = fitStroke(stroke.points, Stroke::press, stroke.options);
    std::reverse(stroke.points.begin(), stroke.points.end());
    const auto two = fitStroke(stroke.points, Stroke::press, stroke.options);
    RC_ASSERT(one.ok() == two.ok());
    if (one) RC_ASSERT(one->curve == two->curve);
  });
  holdsAlways("the same call twice", [] {
    const NoisyStroke stroke = noisyStroke(anySize());
    const auto one = fitStroke(stroke.points, Stroke::release, stroke.options);
    const auto two = fitStroke(stroke.points, Stroke::release, stroke.options);
    RC_ASSERT(one.ok() == two.ok());
    if (one) RC_ASSERT(one->curve == two->curve);
  });
}

TEST_CASE("any points and any options are fitted or refused by name") {
  holdsAlways("fitStroke, any doubles", [] {
    std::vector<CurvePoint> points;
    for (int i = count(0, 12); i > 0; --i) points.push_back({anyDouble(), anyDouble()});
    FitOptions options;
    options.noise = {magnitude(1e-12, 1e12), magnitude(1e-12, 1e12)};
    const auto fitted = fitStroke(points, Stroke::press, options);
    if (!fitted) return assertNamed(fitted.failure());
    const auto [low, high] = fitted->curve.forceRange_N();
    RC_ASSERT(std::isfinite(low) && std::isfinite(high));
  });
  holdsAlways("fitStroke, any options", [] {
    NoisyStroke stroke = noisyStroke({4, 1}, 8, 40);
    FitOptions& o = stroke.options;
    if (oneIn(2)) o.noise = {anyDouble(), anyDouble()};
    if (oneIn(4)) o.robustScale = anyDouble();
    if (oneIn(4)) o.tolerance = anyDouble();
    if (oneIn(4)) o.resolutionOfSpan = anyDouble();
    if (oneIn(4)) o.noiseAtTactilePoints_share = anyDouble();
    if (oneIn(4)) o.correlationPoints = anyDouble();
    if (oneIn(4)) o.maxPieces = count(-2, 12);
    const auto fitted = fitStroke(stroke.points, Stroke::press, o);
    if (!fitted) return assertNamed(fitted.failure());
    RC_ASSERT(fitted->summary.pieces >= 1);
  });
  holdsAlways("a few outliers move the curve by little", [] {
    const StrokeCurve truth = *StrokeCurve::throughPoints({{0, 0.2}, {4, within(0.4, 1)}});
    std::vector<CurvePoint> points;
    for (int i = 0; i <= 200; ++i)
      points.push_back({0.02 * i, truth.force_N(0.02 * i) + within(-0.002, 0.002)});
    const double outlier = within(-1, 1) * magnitude(0.1, 1e3);
    RC_LOG(std::to_string(outlier));
    for (int i = 0, at = 20; i < 3; ++i)
      points[static_cast<std::size_t>(at += count(10, 50))].force_N += outlier;
    const auto fitted = fitStroke(points, Stroke::press, fitOptionsFor(FitEffort::standard, {0.002, 0.002}));
    if (!fitted) return assertNamed(fitted.failure());
    // Beyond 20 sigmas (and the noise of their neighbours) they stand alone: nowhere, not even where they
    // are, does the curve follow them. Smaller ones pull it a little, and only beside themselves.
    const int placeCount = std::abs(outlier) > 0.05 ? 0 : 12;
    int far = 0;
    for (int i = 0; i <= 200; ++i)
      far += std::abs(fitted->curve.force_N(0.02 * i) - truth.force_N(0.02 * i)) > 0.02;
    RC_ASSERT(far <= placeCount);
  });
}

TEST_CASE("three outliers of a line give no tactile point") {
  // As large as the stroke's own force they resemble a spike: the curve followed one of them in 2 logs of
  // 100.
  std::vector<CurvePoint> points;
  for (int i = 0; i <= 200; ++i)
    points.push_back({0.02 * i, 0.2 + 0.0037 * i + 0.002 * std::sin(17.0 * i * i)});
  for (const int at : {39, 49, 82}) points[static_cast<std::size_t>(at)].force_N -= 0.8811;
  const auto fitted = fitStroke(points, Stroke::press, fitOptionsFor(FitEffort::standard, {0.002, 0.002}));
  REQUIRE(fitted);
  CHECK(fitted->summary.tactilePoints.empty());
  CHECK(fitted->summary.pieces == 1);
  CHECK(fitted->curve.force_N(0.02 * 49) == Approx(0.2 + 0.0037 * 49).margin(0.002));
}

TEST_CASE("a peak that one sample shows is kept") {
  std::vector<CurvePoint> points;
  for (int i = 0; i <= 20; ++i)
    points.push_back({0.2 * i, 0.3 + 0.02 * i + (i == 7 ? 0.4 : i == 6 || i == 8 ? 0.15 : 0)});
  const auto fitted = fitStroke(points, Stroke::press, fitOptionsFor(FitEffort::standard, {0.002, 0.002}));
  REQUIRE(fitted);
  CHECK(fitted->curve.force_N(1.4) == Approx(0.84).margin(0.05));
}

TEST_CASE("an end that strayed comes back to the end of the points, whatever its neighbours do") {
  std::vector<SigmaPoint> points;
  for (int i = 0; i <= 100; ++i) points.push_back({1.0 * i, 3.0 * i, 1});
  const auto chainWith = [](double u0, double v0, double u1) {
    KnotChain chain(3);
    chain[0].at = {u0, v0, 3, 3};
    chain[1].at = {u1, 0, 3, 3};
    chain[2].at = {100, 300, 3, 3};
    return chain;
  };
  KnotChain slid = chainWith(12, 36, -3);  // the order of knots alone would put it at -1.5
  CHECK(returnStrayKnots(slid, points, 5) == 1);
  CHECK(slid.front().u() == 0);
  CHECK(slid.front().v() == 0);
  KnotChain lifted = chainWith(4, 280, 50);  // the nearest place of the line is 90 along it
  returnStrayKnots(lifted, points, 5);
  CHECK(lifted.front().u() == 0);
}

TEST_CASE("pieces and options keep their bounds", "[finite]") {
  holdsAlways("fixed pieces: as many or fewer", [] {
    NoisyStroke stroke = noisyStroke({4, 1});
    stroke.options.criterion = PieceCriterion::fixed;
    stroke.options.pieces = count(1, 20);
    const auto fitted = fitStroke(stroke.points, Stroke::press, stroke.options);
    if (fitted) RC_ASSERT(fitted->summary.pieces <= std::max(stroke.options.pieces, 4));
  });
  holdsAlways("at most maxPieces", [] {
    NoisyStroke stroke = noisyStroke({4, 1}, 60, 200);
    stroke.options.maxPieces = count(1, 6);
    const auto fitted = fitStroke(stroke.points, Stroke::press, stroke.options);
    if (fitted) RC_ASSERT(fitted->summary.pieces <= stroke.options.maxPieces);
  });
  holdsAlways("prepareSamples: from the least to the greatest displacement, thinned, the ends kept", [] {
    NoisyStroke stroke = noisyStroke(anySize(), 8, 300);
    stroke.options.maxPoints = count(4, 100);
    const auto samples = prepareSamples(stroke.points, Stroke::press, stroke.options);
    if (!samples) return assertNamed(samples.failure());
    RC_ASSERT(samples->points.size() >= 2u);
    RC_ASSERT(static_cast<int>(samples->points.size()) <= stroke.options.maxPoints + 2);
    for (const SigmaPoint& p : samples->points)
      RC_ASSERT(std::isfinite(p.u) && std::isfinite(p.v) && std::isfinite(p.weight) && p.weight > 0);
    RC_ASSERT(alike(samples->displacement_mm(samples->points.front().u),
                    stroke.points.front().displacement_mm, 1e-12, stroke.points.back().displacement_mm));
  });
}

TEST_CASE("the fit against long double", "[finite]") {
  holdsAlways("chiSquareOf: never below, and at most a hundredth above where a piece bends back from a point",
              [] {
                const NoisyStroke stroke = noisyStroke({4, 1}, 10, 60);
                const auto samples = prepareSamples(stroke.points, Stroke::press, stroke.options);
                RC_PRE(samples.ok());
                KnotChain chain = segmentStroke(samples->points, 20, 20).chain;
                solveChain(chain, samples->points, {0, chain.size()}, {});
                const double own = chiSquareOf(chain, samples->points, 3);
                const auto reference = static_cast<double>(chiSquareReference(chain, samples->points, 3));
                RC_LOG() << own << ", in long double " << reference << '\n';
                RC_ASSERT(own >= reference * (1 - 1e-6) - 1e-9 && own <= reference * 1.01 + 1e-2);
              });
}

TEST_CASE("parts of the fit", "[finite]") {
  holdsAlways("a piece is monotone for any knots", [] {
    const KnotChain chain = anyChain();
    for (const ChainPiece& piece : piecesOf(chain)) {
      const double low = std::min(piece.v0, piece.v(1)), high = std::max(piece.v0, piece.v(1));
      for (int i = 0; i <= 16; ++i) {
        const double v = piece.v(i / 16.0);
        RC_ASSERT(v >= low - 1e-9 * (1 + std::abs(low)) && v <= high + 1e-9 * (1 + std::abs(high)));
      }
    }
  });
  holdsAlways("nearestOn is no farther than any place looked at", [] {
    const KnotChain chain = anyChain();
    const auto pieces = piecesOf(chain);
    const ChainPiece& piece = pieces[anyOf<std::size_t>(0, pieces.size() - 1)];
    const SigmaPoint point{piece.u(share()) + within(-3, 3), piece.v(share()) + within(-3, 3), 1};
    const Footpoint projection = nearestOn(piece, point);
    RC_ASSERT(projection.t >= 0 && projection.t <= 1);
    for (const double t : {0.0, 1.0}) {
      const double du = piece.u(t) - point.u, dv = piece.v(t) - point.v;
      RC_ASSERT(projection.squaredDistance <= (du * du + dv * dv) * (1 + 1e-9) + 1e-9);
    }
  });
  holdsAlways("levelDisplacements: never backwards", [] {
    KnotChain chain = anyChain();
    for (ChainKnot& knot : chain) knot.at[0] += within(-50, 50);
    levelDisplacements(chain);
    for (std::size_t k = 1; k < chain.size(); ++k) RC_ASSERT(chain[k].u() >= chain[k - 1].u());
  });
  holdsAlways("dropRedundantKnots: at most two at one displacement", [] {
    KnotChain chain = anyChain();
    levelDisplacements(chain);
    const double first = chain.front().u(), last = chain.back().u();
    dropRedundantKnots(chain);
    RC_ASSERT(!chain.empty() && chain.front().u() == first && chain.back().u() == last);
    for (std::size_t k = 2; k < chain.size(); ++k) RC_ASSERT(chain[k].u() > chain[k - 2].u());
  });
  holdsAlways("chiSquareOf and residualsOf are finite", [] {
    const KnotChain chain = anyChain();
    const auto points = pointsNear(chain);
    RC_ASSERT(std::isfinite(chiSquareOf(chain, points, magnitude(0.1, 100))));
    for (const double residual : residualsOf(chain, points)) RC_ASSERT(std::isfinite(residual));
  });
  holdsAlways("solveChain: finite, and knots in their order", [] {
    KnotChain chain = anyChain();
    const auto points = pointsNear(chain);
    solveChain(chain, points, {0, chain.size()}, {});
    RC_ASSERT(std::isfinite(chiSquareOf(chain, points, SolveSettings{}.robustScale)));
    for (std::size_t k = 1; k < chain.size(); ++k) RC_ASSERT(chain[k].u() >= chain[k - 1].u());
  });
  holdsAlways("knotErrors are finite, never below 0, and the condition is 1 to 1e8", [] {
    KnotChain chain = anyChain();
    const auto points = pointsNear(chain);
    SolveSettings settings;
    solveChain(chain, points, {0, chain.size()}, settings);
    const KnotErrors errors = knotErrors(chain, points, settings);
    RC_ASSERT(errors.condition >= 1 && errors.condition <= 1.0001e8);
    RC_ASSERT(errors.sigmas.size() == chain.size());
    for (const KnotSigma& s : errors.sigmas)
      RC_ASSERT(std::isfinite(s.u) && std::isfinite(s.v) && s.u >= 0 && s.v >= 0);
  });
  holdsAlways("correlationOf is at least 1", [] {
    std::vector<double> residuals;
    for (int i = count(0, 200); i > 0; --i) residuals.push_back(within(-1, 1) * magnitude(1e-6, 1e6));
    const double correlation = correlationOf(residuals);
    RC_ASSERT(std::isfinite(correlation) && correlation >= 1);
  });
  holdsAlways("segmentStroke: a chain over all points, never backwards", [] {
    const NoisyStroke stroke = noisyStroke(anySize(), 8, 200);
    const auto samples = prepareSamples(stroke.points, Stroke::press, stroke.options);
    RC_PRE(samples.ok());
    const Segmentation cut = segmentStroke(samples->points, count(8, 100), magnitude(1, 100));
    RC_ASSERT(cut.chain.size() >= 2u && cut.correlationPoints >= 1);
    for (std::size_t k = 1; k < cut.chain.size(); ++k) RC_ASSERT(cut.chain[k].u() >= cut.chain[k - 1].u());
    RC_ASSERT(std::isfinite(cut.chain.back().u()));
  });
  holdsAlways("returnStrayKnots leaves finite knots", [] {
    KnotChain chain = anyChain();
    const auto points = pointsNear(chain);
    for (ChainKnot& knot : chain)
      if (oneIn(3)) knot.at[1] += within(-1, 1) * 1e6;
    RC_ASSERT(returnStrayKnots(chain, points, 5) >= 0);
    for (const ChainKnot& knot : chain) RC_ASSERT(std::isfinite(knot.u()) && std::isfinite(knot.v()));
  });
}
