// SPDX-License-Identifier: GPL-3.0-or-later
// The steps inside a fit.

#include <cmath>

#include <catch2/catch.hpp>

#include "importer/fit/band_matrix.h"
#include "importer/fit/choose_knots.h"
#include "importer/fit/segment_stroke.h"
#include "importer/fit/tactile_misfit.h"
#include "tests/importer/fit/drawn_strokes.h"

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::drawn;

namespace {

std::vector<SigmaPoint> wave(int count, double noise = 0, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<SigmaPoint> points;
  for (int i = 0; i < count; ++i) {
    const double u = 600.0 * i / (count - 1);
    points.push_back({u + noise * normal(random), 100 * std::sin(u / 80) + noise * normal(random), 1});
  }
  return points;
}

}  // namespace

TEST_CASE("a piece never leaves the box of its ends, whatever its slopes") {
  for (const double before : {-5.0, 0.0, 0.3, 40.0})
    for (const double after : {-5.0, 0.0, 0.3, 40.0})
      for (const double rise : {-10.0, 0.0, 10.0}) {
        const ChainPiece piece(ChainKnot{{0, 0, before, before}, JointKind::smooth},
                               ChainKnot{{20, rise, after, after}, JointKind::smooth});
        for (double t = 0; t <= 1; t += 0.01) {
          CHECK(piece.v(t) >= std::min(0.0, rise) - 1e-9);
          CHECK(piece.v(t) <= std::max(0.0, rise) + 1e-9);
          CHECK(piece.dv(t) * rise >= -1e-9);
        }
      }
}

TEST_CASE("the footpoint is where the line of sight is square to the curve") {
  const ChainPiece piece(ChainKnot{{0, 0, 0, 0}, JointKind::flat},
                         ChainKnot{{50, 80, 0.5, 0.5}, JointKind::smooth});
  for (const double t : {0.1, 0.4, 0.5, 0.9})
    for (const double off : {-3.0, 0.5, 4.0}) {
      const double speed = std::hypot(piece.h, piece.dv(t));
      const SigmaPoint p{piece.u(t) - off * piece.dv(t) / speed, piece.v(t) + off * piece.h / speed, 1};
      const Footpoint projection = nearestOn(piece, p);
      CHECK(projection.t == Approx(t).margin(1e-5));
      CHECK(std::sqrt(projection.squaredDistance) == Approx(std::abs(off)).margin(1e-6));
      CHECK(signedResidual(piece, p, projection.t) == Approx(off).margin(1e-6));
    }
}

TEST_CASE("the first cut puts a knot at each extremum and leaves noise alone") {
  const auto points = wave(800, 1);
  const Segmentation cut = segmentStroke(points, 200, 30);
  CHECK(cut.chain.size() >= 6);
  CHECK(cut.chain.size() <= 12);
  CHECK(cut.correlationPoints < 1.5);
  CHECK(cut.chain.front().u() == points.front().u);
  CHECK(cut.chain.back().u() == points.back().u);
  for (std::size_t k = 0; k + 1 < cut.chain.size(); ++k) CHECK(cut.chain[k].u() <= cut.chain[k + 1].u());
}

TEST_CASE("correlation of residuals is found") {
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0, 1);
  std::vector<double> white, red;
  double last = 0;
  for (int i = 0; i < 20000; ++i) {
    white.push_back(normal(random));
    last = 0.6 * last + normal(random);
    red.push_back(last);
  }
  CHECK(correlationOf(white) == Approx(1).margin(0.1));
  CHECK(correlationOf(red) == Approx(1.6 / 0.4).margin(0.5));
}

namespace {

/// A chain's matrix of random residuals; the last knot is decoupled, because no piece follows it.
BandMatrix randomMatrix(std::size_t knots, std::size_t rows) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 1);
  BandMatrix matrix(knots);
  for (std::size_t i = 0; i < rows; ++i) {
    ResidualRow row{i % knots};
    for (double& by : row.by) by = normal(random);
    matrix.add(row, 0.5);
  }
  for (std::size_t i = perKnot * knots; i < matrix.size(); ++i) matrix.separate(i);
  return matrix;
}

}  // namespace

TEST_CASE("the band of a chain's normal equations is solved") {
  BandMatrix matrix = randomMatrix(6, 200);
  matrix.separate(9);
  std::vector<double> truth, right(matrix.size(), 0);
  for (std::size_t i = 0; i < matrix.size(); ++i) truth.push_back(std::sin(1.0 + static_cast<double>(i)));
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j) right[i] += matrix.at(i, j) * truth[j];
  CHECK(right[9] == truth[9]);
  CHECK(matrix.at(0, 7) == matrix.at(7, 0));
  CHECK(matrix.at(0, 8) == 0);
  REQUIRE(matrix.solve(right));
  for (std::size_t i = 0; i < matrix.size(); ++i) CHECK(right[i] == Approx(truth[i]).margin(1e-9));
}

TEST_CASE("a matrix that is not positive has no solution") {
  BandMatrix matrix = randomMatrix(3, 60);
  matrix.diagonal(5) = 0;
  std::vector<double> right(matrix.size(), 1);
  CHECK_FALSE(matrix.solve(right));
}

TEST_CASE("points too far for their squares leave the chain as it is, and the solver says so") {
  KnotChain chain{{{0, 0, 1, 1}, JointKind::smooth}, {{100, 90, 1, 1}, JointKind::smooth}};
  const KnotChain before = chain;
  std::vector<SigmaPoint> points = wave(50);
  for (SigmaPoint& p : points) p.v += 1e200;
  CHECK_FALSE(solveChain(chain, points, {0, chain.size()}, {}));
  for (std::size_t k = 0; k < chain.size(); ++k) CHECK(chain[k].at == before[k].at);
}

TEST_CASE("the solver finds moved knots again") {
  const KnotChain truth{{{0, 0, 1, 1}, JointKind::smooth},
                        {{150, 120, 0, 0}, JointKind::flat},
                        {{300, 30, 0, 0}, JointKind::flat},
                        {{420, 90, 0.4, 0.9}, JointKind::corner},
                        {{500, 160, 0.9, 0.9}, JointKind::smooth}};
  std::vector<SigmaPoint> points;
  for (const ChainPiece& piece : piecesOf(truth))
    for (double t = 0; t < 1; t += 0.01) points.push_back({piece.u(t), piece.v(t), 1});
  points.push_back({500, 160, 1});
  KnotChain moved = truth;
  moved[1].at = {158, 116, 0, 0};
  moved[2].at = {290, 34, 0, 0};
  moved[3].at = {430, 96, 0.5, 0.8};
  SolveSettings settings;
  settings.maxIterations = 100;
  settings.associations = 3;
  solveChain(moved, points, {0, moved.size()}, settings);
  CHECK(chiSquareOf(moved, points, settings.robustScale) < 0.1);
  for (std::size_t k = 0; k < truth.size(); ++k) {
    CHECK(moved[k].u() == Approx(truth[k].u()).margin(0.5));
    CHECK(moved[k].v() == Approx(truth[k].v()).margin(0.2));
  }
}

TEST_CASE("knots outside the range stay where they are") {
  KnotChain chain = segmentStroke(wave(400, 1), 100, 30).chain;
  const KnotChain before = chain;
  solveChain(chain, wave(400, 1), {2, 4}, {});
  for (std::size_t k = 0; k < chain.size(); ++k)
    if (k < 2 || k >= 4) CHECK(chain[k].at == before[k].at);
}

TEST_CASE("evidence takes out what is too much and adds what is missing") {
  const auto points = wave(800, 1);
  const KnotEvidence evidence(800, 1);
  KnotChain many = segmentStroke(points, 200, 7).chain, few = segmentStroke(points, 200, 2000).chain;
  CHECK(many.size() > few.size());
  ChoiceSettings settings;
  settings.rounds = 8;
  chooseKnots(many, points, evidence, settings);
  chooseKnots(few, points, evidence, settings);
  // Cut seven times too fine at the start, it ends near the five pieces a sensible cut gives.
  CHECK(many.size() <= 10);
  const double perPointMany = chiSquareOf(many, points, 3) / 800,
               perPointFew = chiSquareOf(few, points, 3) / 800;
  CHECK(perPointMany < 1.15);
  CHECK(perPointFew < 1.3);
}

TEST_CASE("standard errors shrink with the root of the number of points") {
  const KnotChain cut = segmentStroke(wave(3200, 1), 200, 30).chain;
  const auto sigmaOfPeak = [&](int count) {
    const auto points = wave(count, 1);
    KnotChain chain = cut;
    solveChain(chain, points, {0, chain.size()}, {});
    const auto sigmas = knotErrors(chain, points, {}).sigmas;
    for (std::size_t k = 1; k + 1 < chain.size(); ++k)
      if (chain[k].joint == JointKind::flat) return sigmas[k];
    return KnotSigma{};
  };
  const KnotSigma coarse = sigmaOfPeak(400), fine = sigmaOfPeak(3200);
  CHECK(coarse.v > 0);
  CHECK(fine.v == Approx(coarse.v / std::sqrt(8.0)).epsilon(0.35));
  CHECK(fine.u == Approx(coarse.u / std::sqrt(8.0)).epsilon(0.45));
}

TEST_CASE("a fit whose knot could stand anywhere is ill conditioned, and says so") {
  const auto points = wave(800, 1);
  const double kinkedCondition = knotErrors(segmentStroke(points, 200, 30).chain, points, {}).condition;
  std::vector<SigmaPoint> line;
  for (int i = 0; i <= 100; ++i) line.push_back({1.0 * i, 0.5 * i, 1});
  const KnotChain chain{{{0, 0, 0.5, 0.5}, JointKind::smooth},
                        {{50, 25, 0.5, 0.5}, JointKind::smooth},
                        {{100, 50, 0.5, 0.5}, JointKind::smooth}};
  CHECK(kinkedCondition >= 1);
  CHECK(knotErrors(chain, line, {}).condition > 3 * kinkedCondition);
}

namespace {

/// A peak (or, upside down, a valley) of two cubics, 100 sigmas high and 200 wide to each side, steeper to
/// the right.
KnotChain extremum(double sign, double movedBy = 0) {
  return {{{0, 0, 0, 0}, JointKind::flat},
          {{200 + movedBy, sign * 100, 0, 0}, JointKind::flat},
          {{340, sign * 10, 0, 0}, JointKind::flat}};
}

std::vector<SigmaPoint> pointsOf(const KnotChain& chain, double noise, int count) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 1);
  const std::vector<ChainPiece> pieces = piecesOf(chain);
  std::vector<SigmaPoint> points;
  for (int i = 0; i < count; ++i) {
    const double u = chain.back().u() * i / (count - 1);
    const ChainPiece& piece = pieces[u < chain[1].u() ? 0 : 1];
    points.push_back({u, piece.v((u - piece.u0) / piece.h) + noise * normal(random), 1});
  }
  return points;
}

}  // namespace

TEST_CASE("a tactile point of the right curve is not far from what the points around it say") {
  for (const double sign : {1.0, -1.0}) {
    const KnotChain chain = extremum(sign);
    const TactileMisfit misfit = tactileMisfit(chain, pointsOf(chain, 0.3, 400), chain[1], sign, 1);
    CHECK(std::abs(misfit.u) < 1.5);
    CHECK(std::abs(misfit.v) < 0.3);
  }
}

TEST_CASE("a tactile point that the curve's few pieces displace is reported with its distance") {
  for (const double sign : {1.0, -1.0}) {
    const std::vector<SigmaPoint> points = pointsOf(extremum(sign), 0.3, 400);
    const KnotChain off = extremum(sign, 8);
    CHECK(tactileMisfit(off, points, off[1], sign, 1).u == Approx(-8).margin(2));
    KnotChain high = extremum(sign);
    high[1].at[1] += sign * 3;
    CHECK(tactileMisfit(high, points, high[1], sign, 1).v == Approx(-3 * sign).margin(0.5));
  }
}

TEST_CASE("around a tactile point of a handful of points nothing is known but the fit's own error") {
  const KnotChain chain = extremum(1);
  const TactileMisfit misfit = tactileMisfit(chain, pointsOf(chain, 1, 12), chain[1], 1, 1);
  CHECK(misfit.u == 0);
  CHECK(misfit.v == 0);
}
