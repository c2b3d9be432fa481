// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/knot_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace detent::importer {
namespace {

constexpr double greatestTangent =
    3;  // times the secant: the largest box inside Fritsch & Carlson's monotone region

void limitTangent(double slope, double h, double d, double& tangent, bool& free, double& perD) {
  const double wanted = slope * h;
  if (h <= 0) {
    // A vertical piece: straight.
    tangent = d, free = false, perD = 1;
  } else if (d == 0 || wanted * d <= 0) {
    // The slope points against the piece's direction; at d == 0 the piece is flat.
    tangent = 0, free = false, perD = 0;
  } else if (std::abs(wanted) > greatestTangent * std::abs(d)) {
    tangent = greatestTangent * d, free = false, perD = greatestTangent;
  } else {
    tangent = wanted, free = true, perD = 0;
  }
}

double squaredDistance(const ChainPiece& piece, const SigmaPoint& p, double t) {
  const double du = piece.u(t) - p.u, dv = piece.v(t) - p.v;
  return du * du + dv * dv;
}

double squaredDistanceToBox(const ChainPiece& piece, const SigmaPoint& p) {
  const double u1 = piece.u0 + piece.h, v1 = piece.v0 + piece.d;
  const double du = std::max({std::min(piece.u0, u1) - p.u, p.u - std::max(piece.u0, u1), 0.0});
  const double dv = std::max({std::min(piece.v0, v1) - p.v, p.v - std::max(piece.v0, v1), 0.0});
  return du * du + dv * dv;
}

}  // namespace

int freedomOf(JointKind joint) { return joint == JointKind::corner ? 4 : joint == JointKind::smooth ? 3 : 2; }

void levelDisplacements(KnotChain& chain) {
  struct Level {
    double sum;
    std::size_t count;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Level> levels;
  for (const ChainKnot& knot : chain) {
    levels.push_back({knot.u(), 1});
    while (levels.size() > 1 && levels[levels.size() - 2].mean() > levels.back().mean()) {
      levels[levels.size() - 2].sum += levels.back().sum;
      levels[levels.size() - 2].count += levels.back().count;
      levels.pop_back();
    }
  }
  std::size_t i = 0;
  for (const Level& level : levels)
    for (std::size_t k = 0; k < level.count; ++k) chain[i++].at[0] = level.mean();
}

void dropRedundantKnots(KnotChain& chain) {
  for (std::size_t k = 0; k + 1 < chain.size() && chain.size() > 2;) {
    const bool repeated = chain[k].u() == chain[k + 1].u() && chain[k].v() == chain[k + 1].v();
    const bool insideVertical = k > 0 && chain[k - 1].u() == chain[k].u() && chain[k].u() == chain[k + 1].u();
    if (insideVertical || (repeated && k > 0))
      chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(k)), k = k > 1 ? k - 1 : 0;
    else if (repeated && chain.size() > 2)
      chain.erase(chain.begin() + 1);
    else
      ++k;
  }
}

ChainPiece::ChainPiece(const ChainKnot& from, const ChainKnot& to)
    : u0(from.u()), h(to.u() - from.u()), v0(from.v()), d(to.v() - from.v()) {
  limitTangent(from.slopeAfter(), h, d, a, aFree, aPerD);
  limitTangent(to.slopeBefore(), h, d, b, bFree, bPerD);
  c2 = 3 * d - 2 * a - b;
  c3 = a + b - 2 * d;
}

Footpoint nearestFrom(const ChainPiece& piece, const SigmaPoint& p, double t) {
  t = std::clamp(t, 0.0, 1.0);
  if (t <= 0 || t >= 1) {
    // At an end the derivative over t may vanish (a steep piece between two flat joints), so the search
    // starts inside.
    const double inside = t <= 0 ? 0.05 : 0.95;
    if (squaredDistance(piece, p, inside) < squaredDistance(piece, p, t)) t = inside;
  }
  double du = piece.u(t) - p.u, dv = piece.v(t) - p.v, best = du * du + dv * dv;
  for (int step = 0; step < 8; ++step) {
    const double tangent = piece.dv(t);
    const double gradient = du * piece.h + dv * tangent;
    const double speed = piece.h * piece.h + tangent * tangent;
    double curvature = speed + dv * piece.ddv(t);
    if (curvature < 0.1 * speed) curvature = speed;
    if (!(curvature > 0)) break;
    double next = std::clamp(t - gradient / curvature, 0.0, 1.0);
    double nextU = piece.u(next) - p.u, nextV = piece.v(next) - p.v, distance = nextU * nextU + nextV * nextV;
    for (int halving = 0; halving < 6 && distance > best; ++halving) {
      next = 0.5 * (next + t);
      nextU = piece.u(next) - p.u, nextV = piece.v(next) - p.v;
      distance = nextU * nextU + nextV * nextV;
    }
    if (distance > best) break;
    const double moved = std::abs(next - t);
    t = next, du = nextU, dv = nextV, best = distance;
    // Convergence is quadratic: the remaining error is the square of this step.
    if (moved < 1e-4) break;
  }
  return {0, t, best};
}

Footpoint nearestOn(const ChainPiece& piece, const SigmaPoint& p) {
  constexpr int probes = 4;
  double bestT = 0, best = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= probes; ++k) {
    const double t = static_cast<double>(k) / probes, distance = squaredDistance(piece, p, t);
    if (distance < best) best = distance, bestT = t;
  }
  return nearestFrom(piece, p, bestT);
}

std::vector<ChainPiece> piecesOf(const KnotChain& chain) {
  std::vector<ChainPiece> pieces;
  pieces.reserve(chain.size());
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) pieces.emplace_back(chain[i], chain[i + 1]);
  return pieces;
}

std::vector<Footpoint> footpointsOn(const KnotChain& chain, const std::vector<SigmaPoint>& points) {
  const std::vector<ChainPiece> pieces = piecesOf(chain);
  std::vector<Footpoint> footpoints;
  footpoints.reserve(points.size());
  std::size_t last = 0;
  for (const SigmaPoint& p : points) {
    // The piece of the previous point gives a tight bound that excludes the others by their boxes.
    Footpoint best = nearestOn(pieces[last], p);
    best.piece = last;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i == last || squaredDistanceToBox(pieces[i], p) >= best.squaredDistance) continue;
      Footpoint footpoint = nearestOn(pieces[i], p);
      if (footpoint.squaredDistance < best.squaredDistance) best = footpoint, best.piece = i;
    }
    last = best.piece;
    footpoints.push_back(best);
  }
  return footpoints;
}

double signedResidual(const ChainPiece& piece, const SigmaPoint& p, double t) {
  const double du = p.u - piece.u(t), dv = p.v - piece.v(t);
  const double side = dv * piece.h - du * piece.dv(t);
  return std::copysign(p.weight * std::sqrt(du * du + dv * dv), side);
}

}  // namespace detent::importer
