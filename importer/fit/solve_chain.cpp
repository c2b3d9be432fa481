// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/solve_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <ceres/ceres.h>
#include <Eigen/Dense>

#include "model/check.h"

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
  double t = 0;
};

/// Residuals of the points nearest to one piece. A point may slip to the piece before or after while knots
/// move, so the parameter blocks are the (up to) four knots of these pieces.
class PieceResiduals final : public ceres::CostFunction {
 public:
  PieceResiduals(const KnotChain& chain, std::size_t piece, std::vector<AssignedPoint> points,
                 double robustScale)
      : points_(std::move(points)), robustScale_(robustScale), firstKnot_(piece == 0 ? 0 : piece - 1) {
    const std::size_t lastKnot = std::min(chain.size() - 1, piece + 2);
    own_ = piece - firstKnot_;
    for (std::size_t k = firstKnot_; k <= lastKnot; ++k) {
      joints_.push_back(chain[k].joint);
      mutable_parameter_block_sizes()->push_back(4);
    }
    set_num_residuals(static_cast<int>(points_.size()));
  }

  std::size_t firstKnot() const { return firstKnot_; }
  std::size_t knotCount() const { return joints_.size(); }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    KnotChain knots(joints_.size());
    for (std::size_t k = 0; k < knots.size(); ++k) {
      std::copy_n(parameters[k], 4, knots[k].at.begin());
      knots[k].joint = joints_[k];
    }
    const std::vector<ChainPiece> pieces = piecesOf(knots);
    if (jacobians)
      for (std::size_t k = 0; k < knots.size(); ++k)
        if (jacobians[k]) std::fill_n(jacobians[k], 4 * points_.size(), 0.0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Footpoint foot = nearest(pieces, points_[i]);
      if (foot.piece == own_) points_[i].t = foot.t;
      const RobustResidual r =
          robust(signedResidual(pieces[foot.piece], points_[i].point, foot.t), robustScale_);
      residuals[i] = r.value;
      if (!std::isfinite(r.value)) return false;
      if (jacobians) addJacobian(pieces[foot.piece], foot, i, r.derivative, jacobians);
    }
    return true;
  }

 private:
  Footpoint nearest(const std::vector<ChainPiece>& pieces, const AssignedPoint& assigned) const {
    Footpoint best = nearestFrom(pieces[own_], assigned.point, assigned.t);
    best.piece = own_;
    if (best.t <= 0 && own_ > 0) {
      const Footpoint other = nearestFrom(pieces[own_ - 1], assigned.point, 1);
      if (other.squaredDistance < best.squaredDistance) best = {own_ - 1, other.t, other.squaredDistance};
    } else if (best.t >= 1 && own_ + 1 < pieces.size()) {
      const Footpoint other = nearestFrom(pieces[own_ + 1], assigned.point, 0);
      if (other.squaredDistance < best.squaredDistance) best = {own_ + 1, other.t, other.squaredDistance};
    }
    return best;
  }

  /// The footpoint moves along the curve only, so to first order the distance changes by the curve's own
  /// movement along the line of sight (envelope theorem).
  void addJacobian(const ChainPiece& piece, const Footpoint& foot, std::size_t row, double derivative,
                   double** jacobians) const {
    const SigmaPoint& p = points_[row].point;
    const double t = foot.t, du = p.u - piece.u(t), dv = p.v - piece.v(t), tangent = piece.dv(t);
    const double distance = std::sqrt(du * du + dv * dv), side = dv * piece.h - du * tangent >= 0 ? 1 : -1;
    double nu = 0, nv = 0;  // unit vector from the curve to the point, turned to the positive side
    if (distance > 1e-9) {
      nu = side * du / distance, nv = side * dv / distance;
    } else {
      const double speed = std::hypot(piece.h, tangent);
      if (!(speed > 0)) return;
      nu = -tangent / speed, nv = piece.h / speed;
    }
    const double scale = -derivative * p.weight;
    const double t2 = t * t, t3 = t2 * t;
    const double overD = 3 * t2 - 2 * t3, overA = t - 2 * t2 + t3, overB = t3 - t2;
    // How v at t follows the secant, the two ends and the slopes, with the limits of the tangents taken into
    // account.
    const double perD = overD + overA * piece.aPerD + overB * piece.bPerD;
    const double slopeA = piece.aFree && piece.h > 0 ? piece.a / piece.h : 0;
    const double slopeB = piece.bFree && piece.h > 0 ? piece.b / piece.h : 0;
    const double perH = overA * slopeA + overB * slopeB;
    const std::size_t from = foot.piece, to = foot.piece + 1;
    if (double* j = jacobians[from]) {
      j += 4 * row;
      j[0] += scale * (nu * (1 - t) - nv * perH);
      j[1] += scale * nv * (1 - perD);
      if (piece.aFree && joints_[from] != JointKind::flat)
        j[joints_[from] == JointKind::corner ? 3 : 2] += scale * nv * overA * piece.h;
    }
    if (double* j = jacobians[to]) {
      j += 4 * row;
      j[0] += scale * (nu * t + nv * perH);
      j[1] += scale * nv * perD;
      if (piece.bFree && joints_[to] != JointKind::flat) j[2] += scale * nv * overB * piece.h;
    }
  }

  /// Where each point's footpoint was last: only the start of the search, so that results do not depend on
  /// it.
  mutable std::vector<AssignedPoint> points_;
  double robustScale_;
  std::size_t firstKnot_;
  std::size_t own_ = 0;
  std::vector<JointKind> joints_;
};

/// Holds a knot near its place and slopes where the points say nothing about them: a smooth joint may slide
/// along a straight line, a short piece may hold no points.
class WeakPlace final : public ceres::SizedCostFunction<4, 4> {
 public:
  WeakPlace(const ChainKnot& knot, double reachU, double reachV) : at_(knot.at) {
    per_ = {0.1 / reachU, 0.1 / reachV, slopePer(at_[2]), slopePer(at_[3])};
  }
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    if (jacobians && jacobians[0]) std::fill_n(jacobians[0], 16, 0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      residuals[i] = (parameters[0][i] - at_[i]) * per_[i];
      if (jacobians && jacobians[0]) jacobians[0][5 * i] = per_[i];
    }
    return true;
  }

 private:
  static double slopePer(double slope) { return 0.01 / std::max(1.0, std::abs(slope)); }
  KnotParameters at_{}, per_{};
};

/// The points say where the curve runs, so a knot may not leave them: orthogonal distance alone would not
/// notice a spike of the curve between two points. Costs nothing within `slack`.
class StayWithPoints final : public ceres::SizedCostFunction<1, 4> {
 public:
  StayWithPoints(const std::vector<SigmaPoint>& points, const ChainKnot& knot) : points_(points) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double du = points[i].u - knot.u(), dv = points[i].v - knot.v(), distance = du * du + dv * dv;
      if (distance < best) best = distance, nearest_ = i;
    }
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const double u = parameters[0][0], v = parameters[0][1];
    double awayU = 0, awayV = 0, best = std::numeric_limits<double>::infinity();
    const std::size_t from = nearest_ < window ? 0 : nearest_ - window;
    for (std::size_t i = from; i + 1 < points_.size() && i < nearest_ + window; ++i) {
      const SigmaPoint &a = points_[i], &b = points_[i + 1];
      const double du = b.u - a.u, dv = b.v - a.v, square = du * du + dv * dv;
      const double t = square > 0 ? std::clamp(((u - a.u) * du + (v - a.v) * dv) / square, 0.0, 1.0) : 0;
      const double toU = u - a.u - t * du, toV = v - a.v - t * dv, distance = toU * toU + toV * toV;
      if (distance < best) best = distance, awayU = toU, awayV = toV;
    }
    const double distance = std::sqrt(best);
    const bool outside = distance > slack;
    residuals[0] = outside ? stiffness * (distance - slack) : 0;
    if (jacobians && jacobians[0]) {
      std::fill_n(jacobians[0], 4, 0.0);
      if (outside)
        jacobians[0][0] = stiffness * awayU / distance, jacobians[0][1] = stiffness * awayV / distance;
    }
    return true;
  }

 private:
  static constexpr double stiffness = 3;  // as much as 9 points
  static constexpr double slack =
      1.5;  // sigmas: a true corner lies outside of a line that is drawn around it
  static constexpr std::size_t window = 30;  // points to each side of the nearest at the start
  const std::vector<SigmaPoint>& points_;
  std::size_t nearest_ = 0;
};

/// Displacements never run backwards: a wall that would lean back ends vertical.
class KeepOrder final : public ceres::SizedCostFunction<1, 4, 4> {
 public:
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    constexpr double perSigma = 30;  // residuals (sigmas) per unit of a piece's length turned round
    const double h = parameters[1][0] - parameters[0][0];
    residuals[0] = h < 0 ? perSigma * h : 0;
    for (int side = 0; jacobians && side < 2; ++side) {
      if (!jacobians[side]) continue;
      std::fill_n(jacobians[side], 4, 0.0);
      if (h < 0) jacobians[side][0] = side == 0 ? -perSigma : perSigma;
    }
    return true;
  }
};

bool isSteep(const ChainKnot& a, const ChainKnot& b) {
  return std::abs(b.v() - a.v()) > std::abs(b.u() - a.u());
}

/// Which of a knot's four parameters stay as they are.
std::vector<int> heldParameters(const KnotChain& chain, std::size_t knot) {
  std::vector<int> held;
  const bool first = knot == 0, last = knot + 1 == chain.size();
  if (first || last) {
    const bool steep = first ? isSteep(chain[0], chain[1]) : isSteep(chain[knot - 1], chain[knot]);
    held.push_back(steep ? 1 : 0);
  }
  if (chain[knot].joint != JointKind::corner || first || last) held.push_back(3);
  if (chain[knot].joint == JointKind::flat) held.insert(held.end() - 1, 2);
  return held;
}

/// A solver problem over one association of points and pieces.
class ChainProblem {
 public:
  ChainProblem(KnotChain& chain, const std::vector<SigmaPoint>& points, KnotRange range,
               const SolveSettings& settings)
      : chain_(chain), points_(points) {
    const std::vector<Footpoint> feet = footpointsOn(chain, points);
    std::vector<std::vector<AssignedPoint>> perPiece(chain.size() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) perPiece[feet[i].piece].push_back({points[i], feet[i].t});
    // Pieces one further than the range touches: their points may slip over.
    const std::size_t fromPiece = range.from < 2 ? 0 : range.from - 2;
    const std::size_t toPiece = std::min(chain.size() - 1, range.to + 1);
    ceres::Problem::Options options;
    options.disable_all_safety_checks = true;
    problem_ = std::make_unique<ceres::Problem>(options);
    for (std::size_t piece = fromPiece; piece < toPiece; ++piece)
      if (!perPiece[piece].empty()) addPiece(piece, std::move(perPiece[piece]), settings.robustScale);
    for (std::size_t k = range.from == 0 ? 0 : range.from - 1; k < range.to && k + 1 < chain.size(); ++k)
      problem_->AddResidualBlock(new KeepOrder, nullptr, chain[k].at.data(), chain[k + 1].at.data());
    for (std::size_t k = 0; k < chain.size(); ++k) {
      if (!problem_->HasParameterBlock(chain[k].at.data())) continue;
      if (k >= range.from && k < range.to)
        free(k);
      else
        problem_->SetParameterBlockConstant(chain[k].at.data());
    }
  }

  ceres::Problem& problem() { return *problem_; }

 private:
  void addPiece(std::size_t piece, std::vector<AssignedPoint> points, double robustScale) {
    auto residuals = std::make_unique<PieceResiduals>(chain_, piece, std::move(points), robustScale);
    std::vector<double*> blocks;
    for (std::size_t k = 0; k < residuals->knotCount(); ++k)
      blocks.push_back(chain_[residuals->firstKnot() + k].at.data());
    problem_->AddResidualBlock(residuals.release(), nullptr, blocks);
  }

  void free(std::size_t k) {
    double* block = chain_[k].at.data();
    const ChainKnot& here = chain_[k];
    const std::vector<int> held = heldParameters(chain_, k);
    if (!held.empty()) problem_->SetManifold(block, new ceres::SubsetManifold(4, held));
    double reachU = 10, reachV = 10;
    if (k > 0) {
      reachU = std::min(reachU, here.u() - chain_[k - 1].u());
      reachV = std::min(reachV, std::abs(here.v() - chain_[k - 1].v()));
    }
    if (k + 1 < chain_.size()) {
      reachU = std::min(reachU, chain_[k + 1].u() - here.u());
      reachV = std::min(reachV, std::abs(chain_[k + 1].v() - here.v()));
    }
    if (!points_.empty()) problem_->AddResidualBlock(new StayWithPoints(points_, here), nullptr, block);
    problem_->AddResidualBlock(new WeakPlace(here, std::max(1.0, reachU), std::max(1.0, reachV)), nullptr,
                               block);
  }

  KnotChain& chain_;
  const std::vector<SigmaPoint>& points_;

  std::unique_ptr<ceres::Problem> problem_;
};

/// The condition number of a Jacobian, from J'J.
double conditionOf(const Eigen::MatrixXd& information) {
  constexpr double beyondRounding = 1e-16;  // of the greatest eigenvalue
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
  const std::vector<Footpoint> feet = footpointsOn(chain, points);
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = robust(points[i].weight * std::sqrt(feet[i].squaredDistance), robustScale).value;
    sum += r * r;
  }
  return sum;
}

SolveReport solveChain(KnotChain& chain, const std::vector<SigmaPoint>& points, KnotRange range,
                       const SolveSettings& settings) {
  SolveReport report;
  for (int round = 0; round < settings.associations; ++round) {
    ChainProblem problem(chain, points, range, settings);
    ceres::Solver::Options options;
    options.linear_solver_type =
        range.to - range.from > 8 ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::DENSE_NORMAL_CHOLESKY;
    options.max_num_iterations = settings.maxIterations;
    options.function_tolerance = settings.tolerance;
    options.gradient_tolerance = 1e-4 * settings.tolerance;
    options.parameter_tolerance = settings.tolerance;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem.problem(), &summary);
    levelDisplacements(chain);
    report.chiSquare = 2 * summary.final_cost;
    report.converged = summary.termination_type == ceres::CONVERGENCE;
  }
  return report;
}

KnotErrors knotErrors(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                      const SolveSettings& settings) {
  KnotChain copy = chain;
  ChainProblem problem(copy, points, {0, copy.size()}, settings);
  ceres::Problem::EvaluateOptions evaluation;
  std::vector<std::size_t> firstColumn;
  std::size_t columns = 0;
  for (std::size_t k = 0; k < copy.size(); ++k) {
    evaluation.parameter_blocks.push_back(copy[k].at.data());
    firstColumn.push_back(columns);
    columns += 4 - heldParameters(copy, k).size();
  }
  ceres::CRSMatrix jacobian;
  std::vector<double> residuals;
  KnotErrors errors{std::vector<KnotSigma>(copy.size())};
  if (!problem.problem().Evaluate(evaluation, nullptr, &residuals, nullptr, &jacobian)) return errors;
  DETENT_CHECK(static_cast<std::size_t>(jacobian.num_cols) == columns,
               "free parameters as the solver counts them");

  // J'J and, with the residuals as they are, J'RRJ.
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(jacobian.num_cols, jacobian.num_cols);
  Eigen::MatrixXd scatter = information;
  for (std::size_t row = 0; row < residuals.size(); ++row) {
    const auto from = static_cast<std::size_t>(jacobian.rows[row]);
    const auto to = static_cast<std::size_t>(jacobian.rows[row + 1]);
    for (std::size_t i = from; i < to; ++i)
      for (std::size_t j = from; j < to; ++j) {
        const double product = jacobian.values[i] * jacobian.values[j];
        information(jacobian.cols[i], jacobian.cols[j]) += product;
        scatter(jacobian.cols[i], jacobian.cols[j]) += residuals[row] * residuals[row] * product;
      }
  }
  // A slope that a limit holds has no influence and an empty row: it counts as fixed.
  for (Eigen::Index c = 0; c < information.cols(); ++c)
    if (information(c, c) <= 1e-12 * information.trace()) information(c, c) += 1;
  errors.condition = conditionOf(information);
  const Eigen::MatrixXd inverse =
      information.ldlt().solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
  const double n = static_cast<double>(points.size()),
               freedom = std::max(1.0, n - static_cast<double>(columns));
  const Eigen::MatrixXd covariance = inverse * scatter * inverse * (n / freedom);
  for (std::size_t k = 0; k < copy.size(); ++k) {
    const std::vector<int> held = heldParameters(copy, k);
    const auto isHeld = [&](int parameter) {
      return std::find(held.begin(), held.end(), parameter) != held.end();
    };
    auto column = static_cast<Eigen::Index>(firstColumn[k]);
    const auto sigmaAt = [&](Eigen::Index c) { return std::sqrt(std::max(0.0, covariance(c, c))); };
    if (!isHeld(0)) errors.sigmas[k].u = sigmaAt(column++);
    if (!isHeld(1)) errors.sigmas[k].v = sigmaAt(column);
  }
  return errors;
}

}  // namespace detent::importer
