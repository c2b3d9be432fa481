// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/solve_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "importer/fit/band_matrix.h"

namespace detent::importer {
namespace {

/// Huber's loss as a residual: r inside the scale, growing with the root of |r| outside.
struct RobustResidual {
  double value = 0, derivative = 1;
};

RobustResidual robust(double r, double scale) {
  const double size = std::abs(r);
  if (size <= scale) return {r, 1};
  const double value = std::sqrt(scale * (2 * size - scale));
  return {std::copysign(value, r), scale / value};
}

struct AssignedPoint {
  SigmaPoint point;
  std::size_t piece = 0;
  /// Position of the last footpoint on its piece, in [0, 1]. The next search starts there.
  double t = 0;
};

/// A point may move to an adjacent piece while knots move.
Footpoint nearestAround(const std::vector<ChainPiece>& pieces, AssignedPoint& assigned) {
  const std::size_t own = assigned.piece;
  Footpoint best = nearestFrom(pieces[own], assigned.point, assigned.t);
  best.piece = own;
  if (best.t <= 0 && own > 0) {
    const Footpoint other = nearestFrom(pieces[own - 1], assigned.point, 1);
    if (other.squaredDistance < best.squaredDistance) best = {own - 1, other.t, other.squaredDistance};
  } else if (best.t >= 1 && own + 1 < pieces.size()) {
    const Footpoint other = nearestFrom(pieces[own + 1], assigned.point, 0);
    if (other.squaredDistance < best.squaredDistance) best = {own + 1, other.t, other.squaredDistance};
  }
  if (best.piece == own) assigned.t = best.t;
  return best;
}

/// Robust distance of a point. To first order it changes by the curve's own movement along the line of sight,
/// because the footpoint moves along the curve (envelope theorem).
ResidualRow distanceRow(const KnotChain& chain, const ChainPiece& piece, const Footpoint& footpoint,
                        const SigmaPoint& p, double robustScale) {
  const double t = footpoint.t, du = p.u - piece.u(t), dv = p.v - piece.v(t), tangent = piece.dv(t);
  const double distance = std::sqrt(du * du + dv * dv), side = dv * piece.h - du * tangent >= 0 ? 1 : -1;
  const RobustResidual r = robust(side * p.weight * distance, robustScale);
  ResidualRow row{footpoint.piece, r.value};
  double nu = 0, nv = 0;  // unit vector from the curve to the point, on the positive side
  if (distance > 1e-9) {
    nu = side * du / distance, nv = side * dv / distance;
  } else {
    const double speed = std::hypot(piece.h, tangent);
    if (!(speed > 0)) return row;
    nu = -tangent / speed, nv = piece.h / speed;
  }
  const double scale = -r.derivative * p.weight;
  const double t2 = t * t, t3 = t2 * t;
  const double overD = 3 * t2 - 2 * t3, overA = t - 2 * t2 + t3, overB = t3 - t2;
  // Derivatives of v at t by the secant, the ends and the slopes, including the limits of the tangents.
  const double perD = overD + overA * piece.aPerD + overB * piece.bPerD;
  const double slopeA = piece.aFree && piece.h > 0 ? piece.a / piece.h : 0;
  const double slopeB = piece.bFree && piece.h > 0 ? piece.b / piece.h : 0;
  const double perH = overA * slopeA + overB * slopeB;
  row.by[0] = scale * (nu * (1 - t) - nv * perH);
  row.by[1] = scale * nv * (1 - perD);
  row.by[perKnot] = scale * (nu * t + nv * perH);
  row.by[perKnot + 1] = scale * nv * perD;
  const JointKind from = chain[footpoint.piece].joint, to = chain[footpoint.piece + 1].joint;
  if (piece.aFree && from != JointKind::flat)
    row.by[from == JointKind::corner ? 3 : 2] = scale * nv * overA * piece.h;
  if (piece.bFree && to != JointKind::flat) row.by[perKnot + 2] = scale * nv * overB * piece.h;
  return row;
}

/// Weak prior on a knot's place and slopes, for parameters that the points do not determine: a smooth joint
/// may slide along a straight line, a short piece may have no points.
class WeakPlace {
 public:
  WeakPlace(const KnotChain& chain, std::size_t knot) : at_(chain[knot].at) {
    double reachU = 10, reachV = 10;
    for (std::size_t i = knot == 0 ? 0 : knot - 1; i < std::min(knot + 1, chain.size() - 1); ++i) {
      reachU = std::min(reachU, chain[i + 1].u() - chain[i].u());
      reachV = std::min(reachV, std::abs(chain[i + 1].v() - chain[i].v()));
    }
    per_ = {0.1 / std::max(1.0, reachU), 0.1 / std::max(1.0, reachV), slopePer(at_[2]), slopePer(at_[3])};
  }
  ResidualRow row(std::size_t knot, const ChainKnot& now, std::size_t parameter) const {
    ResidualRow row{knot, (now.at[parameter] - at_[parameter]) * per_[parameter]};
    row.by[parameter] = per_[parameter];
    return row;
  }

 private:
  static double slopePer(double slope) { return 0.01 / std::max(1.0, std::abs(slope)); }
  KnotParameters at_{}, per_{};
};

/// Keeps a knot near the points, because orthogonal distance does not notice a spike between two points. No
/// cost within `slack`.
class StayWithPoints {
 public:
  StayWithPoints(const std::vector<SigmaPoint>& points, const ChainKnot& knot) : points_(points) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double du = points[i].u - knot.u(), dv = points[i].v - knot.v(), distance = du * du + dv * dv;
      if (distance < best) best = distance, nearest_ = i;
    }
  }

  ResidualRow row(std::size_t knot, const ChainKnot& now) const {
    const double u = now.u(), v = now.v();
    double awayU = 0, awayV = 0, best = std::numeric_limits<double>::infinity();
    // Search outwards from the last place; most often the first lines are close enough.
    for (std::size_t step = 0; step < 2 * window; ++step) {
      const std::size_t i = step % 2 == 0 ? nearest_ + step / 2 : nearest_ - 1 - step / 2;  // wraps below 0
      if (i >= points_.size() - 1) continue;
      const SigmaPoint &a = points_[i], &b = points_[i + 1];
      const double du = b.u - a.u, dv = b.v - a.v, square = du * du + dv * dv;
      const double t = square > 0 ? std::clamp(((u - a.u) * du + (v - a.v) * dv) / square, 0.0, 1.0) : 0;
      const double toU = u - a.u - t * du, toV = v - a.v - t * dv, distance = toU * toU + toV * toV;
      if (distance <= slack * slack) return {knot};
      if (distance < best) best = distance, awayU = toU, awayV = toV;
    }
    const double distance = std::sqrt(best);
    return {
        knot, stiffness * (distance - slack), {stiffness * awayU / distance, stiffness * awayV / distance}};
  }

 private:
  static constexpr double stiffness = 3;     // weight of 9 points
  static constexpr double slack = 1.5;       // sigmas: a true corner lies outside the line drawn around it
  static constexpr std::size_t window = 30;  // points on each side of the initially nearest one
  const std::vector<SigmaPoint>& points_;
  std::size_t nearest_ = 0;
};

/// Keeps displacements in order: a leaning bottom-out ends vertical.
ResidualRow keepOrderRow(const KnotChain& chain, std::size_t knot) {
  constexpr double perSigma = 30;  // residuals (sigmas) per unit of reversed piece length
  const double h = chain[knot + 1].u() - chain[knot].u();
  return h < 0 ? ResidualRow{knot, perSigma * h, {-perSigma, 0, 0, 0, perSigma}} : ResidualRow{knot};
}

bool isSteep(const ChainKnot& a, const ChainKnot& b) {
  return std::abs(b.v() - a.v()) > std::abs(b.u() - a.u());
}

/// Returns true if one of a knot's four parameters is fixed.
bool isHeld(const KnotChain& chain, std::size_t knot, std::size_t parameter) {
  const bool first = knot == 0, end = first || knot + 1 == chain.size();
  const JointKind joint = chain[knot].joint;
  if (parameter == 3) return joint != JointKind::corner || end;
  if (parameter == 2) return joint == JointKind::flat;
  const std::size_t before = first ? 0 : knot - 1;
  return end && parameter == (isSteep(chain[before], chain[before + 1]) ? 1 : 0);
}

/// Least squares for one assignment of points to pieces.
class ChainProblem {
 public:
  ChainProblem(const KnotChain& chain, const std::vector<SigmaPoint>& points, KnotRange range,
               const SolveSettings& settings)
      : range_(range), robustScale_(settings.robustScale) {
    // One piece beyond those that the range touches, because points may move to it.
    const std::size_t fromPiece = range.from < 2 ? 0 : range.from - 2;
    const std::size_t toPiece = std::min(chain.size() - 1, range.to + 1);
    const std::vector<Footpoint> footpoints = footpointsOn(chain, points);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (footpoints[i].piece >= fromPiece && footpoints[i].piece < toPiece)
        points_.push_back({points[i], footpoints[i].piece, footpoints[i].t});
    nearest_.resize(points_.size());
    for (std::size_t k = range.from; k < range.to; ++k) {
      weak_.emplace_back(chain, k);
      if (points.size() > 1) stay_.emplace_back(points, chain[k]);
      for (std::size_t parameter = 0; parameter < perKnot; ++parameter)
        if (!isHeld(chain, k, parameter)) free_.push_back(perKnot * k + parameter);
    }
  }

  // Below, `chain` is the start chain with other parameters.

  /// Half the sum of squares.
  double costAt(const KnotChain& chain) {
    findNearest(piecesOf(chain));
    double sum = 0;
    const auto add = [&sum](double residual) { sum += residual * residual; };
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double distance = std::sqrt(nearest_[i].squaredDistance);
      add(robust(points_[i].point.weight * distance, robustScale_).value);
    }
    holdsAt(chain, [&add](const ResidualRow& row) { add(row.value); });
    return 0.5 * sum;
  }

  /// Passes every residual to `take`. `isPriced`: costAt() just evaluated this chain and found the
  /// footpoints.
  template <class Take>
  void rowsAt(const KnotChain& chain, bool isPriced, const Take& take) {
    const std::vector<ChainPiece> pieces = piecesOf(chain);
    if (!isPriced) findNearest(pieces);
    for (std::size_t i = 0; i < points_.size(); ++i)
      take(distanceRow(chain, pieces[nearest_[i].piece], nearest_[i], points_[i].point, robustScale_));
    holdsAt(chain, take);
  }

  /// Indices of the free parameters over the chain, in order.
  const std::vector<std::size_t>& freeParameters() const { return free_; }
  bool isFree(std::size_t i) const { return std::binary_search(free_.begin(), free_.end(), i); }

  /// Norm of the moving knots' parameters.
  double lengthOf(const KnotChain& chain) const {
    double sum = 0;
    for (std::size_t k = range_.from; k < range_.to; ++k)
      for (const double x : chain[k].at) sum += x * x;
    return std::sqrt(sum);
  }

 private:
  void findNearest(const std::vector<ChainPiece>& pieces) {
    for (std::size_t i = 0; i < points_.size(); ++i) nearest_[i] = nearestAround(pieces, points_[i]);
  }

  /// Residuals that belong to knots only.
  template <class Take>
  void holdsAt(const KnotChain& chain, const Take& take) const {
    for (std::size_t k = range_.from == 0 ? 0 : range_.from - 1; k < range_.to && k + 1 < chain.size(); ++k)
      take(keepOrderRow(chain, k));
    for (std::size_t i = 0; i < weak_.size(); ++i) {
      const std::size_t k = range_.from + i;
      if (!stay_.empty()) take(stay_[i].row(k, chain[k]));
      for (std::size_t parameter = 0; parameter < perKnot; ++parameter)
        take(weak_[i].row(k, chain[k], parameter));
    }
  }

  KnotRange range_;
  double robustScale_;
  std::vector<AssignedPoint> points_;
  std::vector<Footpoint> nearest_;    // footpoint of each point, on the chain evaluated last
  std::vector<WeakPlace> weak_;       // for each moving knot
  std::vector<StayWithPoints> stay_;  // for each moving knot
  std::vector<std::size_t> free_;
};

/// Half the sum of squares at one place, with gradient and J'J.
struct NormalEquations {
  double cost = 0;
  std::vector<double> gradient;  ///< 0 for fixed parameters
  BandMatrix information;        ///< J'J; fixed parameters are decoupled

  NormalEquations(ChainProblem& problem, const KnotChain& chain, bool isPriced)
      : gradient(perKnot * (chain.size() + 1)), information(chain.size()) {
    problem.rowsAt(chain, isPriced, [this](const ResidualRow& row) {
      cost += 0.5 * row.value * row.value;
      information.add(row);
      for (std::size_t i = 0; i < bandWidth; ++i) gradient[perKnot * row.knot + i] += row.value * row.by[i];
    });
    for (std::size_t i = 0; i < gradient.size(); ++i)
      if (!problem.isFree(i)) gradient[i] = 0, information.separate(i);
  }

  double steepest() const {
    double most = 0;
    for (const double along : gradient) most = std::max(most, std::abs(along));
    return most;
  }
};

struct Step {
  std::vector<double> by;
  double promised = 0;  ///< decrease of the cost predicted by the linear model; 0: no step

  double length() const {
    double sum = 0;
    for (const double x : by) sum += x * x;
    return std::sqrt(sum);
  }
};

/// The step within a trust region of that radius, scaled per parameter.
Step stepFrom(const NormalEquations& here, const std::vector<double>& leastDamping, double radius) {
  Step step{here.gradient};
  BandMatrix damped = here.information;
  std::vector<double> damping;
  for (std::size_t i = 0; i < damped.size(); ++i) {
    damping.push_back(std::max(damped.diagonal(i), leastDamping[i]) / radius);
    damped.diagonal(i) += damping[i];
    step.by[i] = -step.by[i];
  }
  if (!damped.solve(step.by)) return step;
  for (std::size_t i = 0; i < damping.size(); ++i)
    step.promised += 0.5 * step.by[i] * (damping[i] * step.by[i] - here.gradient[i]);
  return step;
}

KnotChain moved(KnotChain chain, const Step& step) {
  for (std::size_t k = 0; k < chain.size(); ++k)
    for (std::size_t i = 0; i < perKnot; ++i) chain[k].at[i] += step.by[perKnot * k + i];
  return chain;
}

/// Levenberg–Marquardt with the rules and values of Ceres Solver 2.1, with which the other constants of the
/// fit were chosen.
bool minimise(ChainProblem& problem, KnotChain& chain, const SolveSettings& settings) {
  constexpr double firstRadius = 1e4, greatestRadius = 1e16;  // relative to each parameter's scale
  constexpr double leastShareKept = 1e-3;                     // share of the predicted decrease
  // share of the initial value; applies if a parameter loses its influence
  constexpr double leastInformation = 1e-6;
  NormalEquations here(problem, chain, false);
  std::vector<double> leastDamping;
  for (std::size_t i = 0; i < here.information.size(); ++i)
    leastDamping.push_back(leastInformation * std::pow(1 + std::sqrt(here.information.diagonal(i)), 2));
  double radius = firstRadius, shrinking = 2;
  bool stepped = false;
  for (int iteration = 0; iteration < settings.maxIterations && std::isfinite(here.cost); ++iteration) {
    if (here.steepest() <= 1e-4 * settings.tolerance) return true;
    const Step step = stepFrom(here, leastDamping, radius);
    double kept = 0;
    if (step.promised > 0) {
      const double fall = here.cost - problem.costAt(moved(chain, step));
      const double reach = problem.lengthOf(chain) + settings.tolerance;
      if ((stepped && step.length() <= settings.tolerance * reach) ||
          std::abs(fall) <= settings.tolerance * here.cost)
        return true;
      kept = fall / step.promised;
    }
    if (kept > leastShareKept) {
      chain = moved(chain, step);
      here = NormalEquations(problem, chain, true);
      radius = std::min(greatestRadius, radius / std::max(1.0 / 3, 1 - std::pow(2 * kept - 1, 3)));
      shrinking = 2, stepped = true;
    } else {
      radius /= shrinking;
      shrinking *= 2;
    }
  }
  return false;
}

/// Condition number of a Jacobian from J'J.
double conditionOf(const Eigen::MatrixXd& information) {
  constexpr double beyondRounding = 1e-16;  // share of the greatest eigenvalue
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scale.asDiagonal() * information * scale.asDiagonal(),
                                                     Eigen::EigenvaluesOnly)
          .eigenvalues();
  const double greatest = eigenvalues[eigenvalues.size() - 1];
  return std::sqrt(greatest / std::max(eigenvalues[0], beyondRounding * greatest));
}

}  // namespace

double chiSquareOf(const KnotChain& chain, const std::vector<SigmaPoint>& points, double robustScale) {
  const std::vector<Footpoint> footpoints = footpointsOn(chain, points);
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = robust(points[i].weight * std::sqrt(footpoints[i].squaredDistance), robustScale).value;
    sum += r * r;
  }
  return sum;
}

bool solveChain(KnotChain& chain, const std::vector<SigmaPoint>& points, KnotRange range,
                const SolveSettings& settings) {
  bool converged = true;
  for (int round = 0; round < settings.associations; ++round) {
    ChainProblem problem(chain, points, range, settings);
    converged = minimise(problem, chain, settings);
    levelDisplacements(chain);
  }
  return converged;
}

KnotErrors knotErrors(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                      const SolveSettings& settings) {
  ChainProblem problem(chain, points, {0, chain.size()}, settings);
  // J'J and, with the actual residuals, J'RRJ.
  BandMatrix informationBand(chain.size()), scatterBand(chain.size());
  problem.rowsAt(chain, false, [&](const ResidualRow& row) {
    informationBand.add(row);
    scatterBand.add(row, row.value * row.value);
  });
  const std::vector<std::size_t>& free = problem.freeParameters();
  const auto columns = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd information(columns, columns), scatter(columns, columns);
  for (Eigen::Index i = 0; i < columns; ++i)
    for (Eigen::Index j = 0; j < columns; ++j) {
      const std::size_t row = free[static_cast<std::size_t>(i)], column = free[static_cast<std::size_t>(j)];
      information(i, j) = informationBand.at(row, column);
      scatter(i, j) = scatterBand.at(row, column);
    }
  KnotErrors errors;
  errors.sigmas.resize(chain.size());
  if (!information.allFinite() || !scatter.allFinite()) return errors;
  // A slope at its limit has an empty row and counts as fixed.
  for (Eigen::Index c = 0; c < columns; ++c)
    if (information(c, c) <= 1e-12 * information.trace()) information(c, c) += 1;
  errors.condition = conditionOf(information);
  const Eigen::MatrixXd inverse = information.ldlt().solve(Eigen::MatrixXd::Identity(columns, columns));
  const double n = static_cast<double>(points.size()),
               freedom = std::max(1.0, n - static_cast<double>(columns));
  const Eigen::MatrixXd covariance = inverse * scatter * inverse * (n / freedom);
  for (Eigen::Index c = 0; c < columns; ++c) {
    const std::size_t i = free[static_cast<std::size_t>(c)], knot = i / perKnot, parameter = i % perKnot;
    const double sigma = std::sqrt(std::max(0.0, covariance(c, c)));
    if (parameter == 0) errors.sigmas[knot].u = sigma;
    if (parameter == 1) errors.sigmas[knot].v = sigma;
  }
  return errors;
}

}  // namespace detent::importer
