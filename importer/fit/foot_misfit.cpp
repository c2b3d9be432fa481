// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/foot_misfit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

namespace detent::importer {
namespace {

constexpr double reachBelow = 0.12;      // of the travel
constexpr std::size_t fewestPoints = 6;  // of either side
constexpr double rounded = 0.15;         // of the wall's height: its lowest part may be rounded
constexpr int parameters = 6;            // a parabola on either side

/// y = c0 + c1 x + c2 x^2 by least squares.
Eigen::Vector3d parabola(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  Eigen::MatrixXd columns(x.size(), 3);
  columns.col(0).setOnes();
  columns.col(1) = x;
  columns.col(2) = x.cwiseProduct(x);
  return columns.colPivHouseholderQr().solve(y);
}

double valueAt(const Eigen::Vector3d& c, double x) { return c[0] + x * (c[1] + x * c[2]); }
double slopeAt(const Eigen::Vector3d& c, double x) { return c[1] + 2 * x * c[2]; }

struct Place {
  double u = 0, v = 0;
};

/// v over u below the foot, u over v in the wall, both about the chain's foot.
struct Corner {
  Eigen::Vector3d below, wall;

  /// Where they meet, from the chain's foot on.
  std::optional<Place> meeting() const {
    double v = 0;
    for (int i = 0; i < 50; ++i) {
      const double u = valueAt(wall, v), next = valueAt(below, u);
      if (std::abs(next - v) < 1e-9) return Place{u, next};
      v = next;
    }
    return {};
  }

  /// Orthogonal to first order.
  double squaredDistance(double u, double v, const Place& corner) const {
    const double under = (v - valueAt(below, u)) / std::hypot(1.0, slopeAt(below, u));
    const double beside = (u - valueAt(wall, v)) / std::hypot(1.0, slopeAt(wall, v));
    return u < corner.u && v < corner.v + 3 ? under * under : beside * beside;
  }
};

std::optional<Corner> cornerThrough(const std::vector<SigmaPoint>& side, const std::vector<SigmaPoint>& wall,
                                    const ChainKnot& foot) {
  if (side.size() < fewestPoints || wall.size() < fewestPoints) return {};
  const auto columns = [&](const std::vector<SigmaPoint>& points, auto of) {
    Eigen::VectorXd column(static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) column[static_cast<Eigen::Index>(i)] = of(points[i]);
    return column;
  };
  const auto u = [&](const SigmaPoint& p) { return p.u - foot.u(); };
  const auto v = [&](const SigmaPoint& p) { return p.v - foot.v(); };
  return Corner{parabola(columns(side, u), columns(side, v)), parabola(columns(wall, v), columns(wall, u))};
}

}  // namespace

std::optional<CornerFoot> cornerFoot(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                                     std::size_t foot, double correlationPoints) {
  const ChainKnot& at = chain[foot];
  const double travel = points.back().u - points.front().u;
  const double height = points.back().v - at.v(), shift = 2;  // sigmas the chain's own foot may be early
  std::vector<SigmaPoint> side, wall, window;
  for (const SigmaPoint& p : points) {
    if (p.u < at.u() - reachBelow * travel) continue;
    window.push_back(p);
    if (p.u < at.u() - shift && p.v < at.v() + rounded * height) side.push_back(p);
    if (p.u > at.u() && p.v > at.v() + rounded * height) wall.push_back(p);
  }
  const auto corner = cornerThrough(side, wall, at);
  const auto meeting = corner ? corner->meeting() : std::nullopt;
  if (!meeting) return {};
  double own = 0, cornered = 0;
  for (const Footpoint& each : footpointsOn(chain, window)) own += each.squaredDistance;
  for (const SigmaPoint& p : window)
    cornered += corner->squaredDistance(p.u - at.u(), p.v - at.v(), *meeting);
  const double count = static_cast<double>(window.size());
  const auto score = [&](double squares) {  // Akaike 1974
    return count / correlationPoints * std::log(std::max(squares, 1e-12) / count) + 2 * parameters;
  };
  const double likely = 1 / (1 + std::exp(std::clamp(0.5 * (score(cornered) - score(own)), -500.0, 500.0)));
  const double per_u = slopeAt(corner->wall, meeting->v);  // travel a force takes in the wall
  if (!(per_u > 0)) return {};
  return CornerFoot{
      at.u() + meeting->u,      at.v() + meeting->v, slopeAt(corner->below, meeting->u), 1 / per_u, likely,
      at.v() + rounded * height};
}

KnotChain withCorner(const KnotChain& chain, const CornerFoot& corner, std::size_t foot) {
  KnotChain cornered(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(foot));
  while (cornered.size() > 1 && cornered.back().u() >= corner.u) cornered.pop_back();
  cornered.push_back({{corner.u, corner.v, corner.slopeBefore, corner.slopeAfter}, JointKind::corner});
  for (std::size_t k = foot + 1; k < chain.size(); ++k)
    if (k + 1 == chain.size() || (chain[k].v() > corner.wallFrom_v && chain[k].u() > corner.u))
      cornered.push_back(chain[k]);
  return cornered;
}

}  // namespace detent::importer
