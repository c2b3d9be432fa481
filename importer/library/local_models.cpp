// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/local_models.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

namespace detent::importer {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A polynomial in t, -1 to 1 across the window, or two that meet at a joint.
struct Shape {
  enum class Joint {
    none,
    /// past the joint there is one more term for every power from `bend` to `bends`: 1 is a corner, 2 a
    /// change of curvature
    bent,
    level  ///< horizontal at the joint; each side has its own terms from power 2 to `degree`
  };
  int degree = 1;
  Joint kind = Joint::none;
  int bend = 0, bends = 0;
  double joint = 0;

  Index columns() const {
    switch (kind) {
      case Joint::bent:
        return degree + 2 + bends - bend;
      case Joint::level:
        return 2 * degree - 1;
      default:
        return degree + 1;
    }
  }
  Index parameters() const { return columns() + (kind == Joint::none ? 0 : 1); }

  /// The terms at t, or their first or second derivative.
  VectorXd at(double t, int derivative = 0) const {
    const auto term = [&](double x, int power) {
      if (power < derivative) return 0.0;
      double factor = 1;
      for (int i = 0; i < derivative; ++i) factor *= power - i;
      return factor * std::pow(x, power - derivative);
    };
    VectorXd terms = VectorXd::Zero(columns());
    const double past = t - joint;
    if (kind == Joint::level) {
      terms[0] = derivative == 0 ? 1 : 0;
      for (int k = 2; k <= degree; ++k) terms[(past < 0 ? 0 : degree - 1) + k - 1] = term(past, k);
      return terms;
    }
    for (int k = 0; k <= degree; ++k) terms[k] = term(t, k);
    if (kind == Joint::bent && past > 0)
      for (int k = bend; k <= bends; ++k) terms[degree + 1 + k - bend] = term(past, k);
    return terms;
  }
  /// Change of the value or slope at t by a step of the joint.
  double perJoint(double t, const VectorXd& solved, int derivative = 0) const {
    if (kind == Joint::none) return 0;
    VectorXd moving = at(t, derivative + 1);
    if (kind == Joint::bent) moving.head(degree + 1).setZero();
    return -moving.dot(solved);
  }
};

/// The samples' t, and their forces as innovations: the part of each that the readings before it do not
/// predict, in units of a common standard deviation.
struct Columns {
  explicit Columns(const LocalWindow& window) {
    const auto& points = window.points;
    middle_mm = 0.5 * (points.front().displacement_mm + points.back().displacement_mm);
    half_mm = 0.5 * (points.back().displacement_mm - points.front().displacement_mm);
    const auto count = static_cast<Index>(points.size());
    t.resize(count), perSigma.resize(count), gain.resize(count);
    VectorXd force_N(count);
    share = window.share;
    double known = window.carried;  // variance of the correlated noise that earlier readings determine
    for (Index i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      t[i] = this->at(points[k].displacement_mm);
      force_N[i] = points[k].force_N;
      const double variance = known + window.own[k];
      perSigma[i] = 1 / std::sqrt(variance);
      gain[i] = known / variance;
      known = share * share * known * (1 - gain[i]) + (1 - share * share) * window.carried;
    }
    force = whitened(force_N);
  }
  double at(double displacement_mm) const { return (displacement_mm - middle_mm) / half_mm; }
  /// Difference of each row from its prediction by the rows before it (Kalman 1960), in standard deviations.
  MatrixXd whitened(MatrixXd rows) const {
    Eigen::RowVectorXd expected = Eigen::RowVectorXd::Zero(rows.cols());
    for (Index i = 0; i < rows.rows(); ++i) {
      const Eigen::RowVectorXd news = rows.row(i) - expected;
      rows.row(i) = perSigma[i] * news;
      expected = share * (expected + gain[i] * news);
    }
    return rows;
  }

  double middle_mm = 0, half_mm = 0, share = 0;
  VectorXd t, perSigma, gain, force;
};

struct Solved {
  VectorXd terms;
  MatrixXd covariance;
  double squares = 0;
};

/// Least squares; the errors follow from the actual scatter of the samples. Nothing if the samples do not
/// determine the solution.
std::optional<Solved> solved(const Columns& columns, const MatrixXd& terms_N) {
  const MatrixXd matrix = columns.whitened(terms_N);
  if (matrix.cols() + 2 > matrix.rows()) return {};
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(matrix);
  if (qr.rank() < matrix.cols()) return {};
  Solved solution;
  solution.terms = qr.solve(columns.force);
  solution.squares = (columns.force - matrix * solution.terms).squaredNorm();
  const Index terms = matrix.cols();
  const MatrixXd upper = qr.matrixR().topLeftCorner(terms, terms).triangularView<Eigen::Upper>();
  const MatrixXd perNews =
      qr.colsPermutation() *
      MatrixXd(upper.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(terms, terms)));
  solution.covariance =
      perNews * perNews.transpose() * solution.squares / static_cast<double>(columns.t.size() - terms);
  return solution;
}

/// The matrix of terms for all samples; with a solution also a column for moving the joint.
MatrixXd matrixOf(const Columns& columns, const Shape& shape, const VectorXd* solved = nullptr) {
  const Index terms = shape.columns();
  MatrixXd matrix = MatrixXd::Zero(columns.t.size(), terms + (solved ? 1 : 0));
  matrix.col(0).setOnes();
  const VectorXd past = columns.t.array() - shape.joint;
  const auto add = [&](const VectorXd& side, Index first, int from, int to) {
    VectorXd power = VectorXd::Ones(side.size());  // of the term before
    for (int k = 1; k <= to; ++k) {
      if (solved && k >= from)
        matrix.col(terms) -=
            k * (*solved)[first + k - from] * (k == 1 ? VectorXd((side.array() > 0).cast<double>()) : power);
      power = power.cwiseProduct(side);
      if (k >= from) matrix.col(first + k - from) = power;
    }
  };
  if (shape.kind == Shape::Joint::level) {
    add(past.cwiseMin(0), 1, 2, shape.degree);
    add(past.cwiseMax(0), shape.degree, 2, shape.degree);
    return matrix;
  }
  for (Index k = 1; k <= shape.degree; ++k) matrix.col(k) = matrix.col(k - 1).cwiseProduct(columns.t);
  if (shape.kind == Shape::Joint::bent) add(past.cwiseMax(0), shape.degree + 1, shape.bend, shape.bends);
  return matrix;
}

/// Estimate of one model and its agreement with the samples.
struct Said {
  LocalPlace place;
  double squares = 0;
  Index parameters = 0;
};

/// Mean of the models, weighted by their evidence (Akaike's criterion, corrected for few samples). Its errors
/// include the differences between the models.
std::optional<LocalPlace> meanPlace(const std::vector<Said>& all, const Columns& columns) {
  if (all.empty()) return {};
  const auto n = static_cast<double>(columns.t.size());
  const auto score = [&](const Said& each) {
    const auto k = static_cast<double>(each.parameters) + 1;  // plus one for the scatter
    return n * std::log(std::max(each.squares, 1e-300) / n) + 2 * k +
           2 * k * (k + 1) / std::max(n - k - 1, 0.5);
  };
  double best = score(all.front());
  for (const Said& each : all) best = std::min(best, score(each));
  double sum = 0;
  LocalPlace mean;
  std::vector<double> likely;
  for (const Said& each : all) {
    likely.push_back(std::exp(-0.5 * (score(each) - best)));
    sum += likely.back();
    mean.displacement_mm += likely.back() * each.place.displacement_mm;
    mean.force_N += likely.back() * each.place.force_N;
  }
  mean.displacement_mm /= sum, mean.force_N /= sum;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double share = likely[i] / sum;
    const double apart_mm = all[i].place.displacement_mm - mean.displacement_mm;
    const double apart_N = all[i].place.force_N - mean.force_N;
    mean.variance_mm2 += share * (all[i].place.variance_mm2 + apart_mm * apart_mm);
    mean.variance_N2 += share * (all[i].place.variance_N2 + apart_N * apart_N);
    mean.covariance_mmN += share * (all[i].place.covariance_mmN + apart_mm * apart_N);
  }
  return mean;
}

LocalPlace placeOf(const Columns& columns, double t, double force_N, const MatrixXd& covariance,
                   const VectorXd& of_t, const VectorXd& ofForce) {
  LocalPlace place{columns.middle_mm + columns.half_mm * t, force_N};
  place.variance_mm2 = columns.half_mm * columns.half_mm * of_t.dot(covariance * of_t);
  place.variance_N2 = ofForce.dot(covariance * ofForce);
  place.covariance_mmN = columns.half_mm * of_t.dot(covariance * ofForce);
  return place;
}

/// Fits a shape to the samples. A joint is found by Gauss-Newton steps; its step follows the terms in the
/// covariance.
std::optional<Solved> placed(const Columns& columns, Shape& shape) {
  if (shape.kind == Shape::Joint::none) return solved(columns, matrixOf(columns, shape));
  constexpr int rounds = 25;
  constexpr double done = 1e-4, longest = 0.08, inside = 0.95;  // of half the window
  double step = 1;
  for (int i = 0; i < rounds && std::abs(step) > done; ++i) {
    if (shape.parameters() + 2 > columns.t.size()) return {};
    const Eigen::HouseholderQR<MatrixXd> qr(columns.whitened(matrixOf(columns, shape)));
    const VectorXd terms = qr.solve(columns.force);
    // The part of the joint's column and of the forces that no term explains. Their regression gives the
    // joint's step (Golub & Pereyra 1973).
    const auto unexplained = [&](const VectorXd& column) -> VectorXd {
      const VectorXd turned = qr.householderQ().adjoint() * column;
      return turned.tail(turned.size() - shape.columns());
    };
    const VectorXd joint = unexplained(columns.whitened(matrixOf(columns, shape, &terms).rightCols(1)));
    step = std::clamp(joint.dot(unexplained(columns.force)) / joint.squaredNorm(), -longest, longest);
    if (!std::isfinite(step)) return {};
    shape.joint += step;
    if (!(std::abs(shape.joint) < inside)) return {};
  }
  auto solution = solved(columns, matrixOf(columns, shape));
  if (!solution) return {};
  const auto joined = solved(columns, matrixOf(columns, shape, &solution->terms));
  if (!joined) return {};
  solution->covariance = joined->covariance;
  return solution;
}

/// The terms, followed by the effect of moving the joint.
VectorXd withJoint(const Shape& shape, const VectorXd& terms, double perJoint) {
  VectorXd all = VectorXd::Zero(shape.parameters());
  all.head(terms.size()) = terms;
  if (shape.parameters() > terms.size()) all[terms.size()] = perJoint;
  return all;
}

/// Position of the joint and force there.
Said jointOf(const Columns& columns, const Shape& shape, const Solved& solution) {
  VectorXd of_t = VectorXd::Zero(shape.parameters());
  of_t[shape.columns()] = 1;
  const VectorXd heights = shape.at(shape.joint);
  // Error of the force at the joint, not at a fixed displacement, so the part that moves with the joint is
  // excluded.
  const double along = shape.at(shape.joint, 1).dot(solution.terms);
  return {placeOf(columns, shape.joint, heights.dot(solution.terms), solution.covariance, of_t,
                  withJoint(shape, heights, along)),
          solution.squares, shape.parameters()};
}

std::optional<Said> extremumOf(const Columns& columns, Shape shape, double sign) {
  const auto solution = placed(columns, shape);
  if (!solution) return {};
  if (shape.kind == Shape::Joint::level) {
    // the curve must fall to either side, however flat it is near the extremum
    for (const double end : {-1.0, 1.0})
      if (!(sign * (shape.at(end).dot(solution->terms) - solution->terms[0]) < 0)) return {};
    return jointOf(columns, shape, *solution);
  }
  constexpr int positions = 40;
  double t = 0, highest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i <= positions; ++i) {
    const double here = -1 + 2.0 * i / positions, height = sign * shape.at(here).dot(solution->terms);
    if (height > highest) highest = height, t = here;
  }
  constexpr double inside = 0.95;  // of half the window: an extremum at its end does not count
  if (std::abs(t) > inside) return {};
  double bend = 0;
  for (int i = 0; i < 20; ++i) {
    bend = shape.at(t, 2).dot(solution->terms);
    if (!(sign * bend < 0)) return {};
    t -= std::clamp(shape.at(t, 1).dot(solution->terms) / bend, -0.05, 0.05);
  }
  if (std::abs(t) > 1) return {};
  const VectorXd heights = withJoint(shape, shape.at(t), shape.perJoint(t, solution->terms));
  const VectorXd slopes = withJoint(shape, shape.at(t, 1), shape.perJoint(t, solution->terms, 1));
  return Said{
      placeOf(columns, t, shape.at(t).dot(solution->terms), solution->covariance, -slopes / bend, heights),
      solution->squares, shape.parameters()};
}

std::optional<Said> cornerOf(const Columns& columns, Shape shape) {
  const auto solution = placed(columns, shape);
  return solution ? std::optional(jointOf(columns, shape, *solution)) : std::nullopt;
}

std::optional<Said> forceBy(const Columns& columns, Shape shape, double t) {
  const auto solution = placed(columns, shape);
  if (!solution) return {};
  const VectorXd heights = shape.at(t);
  return Said{placeOf(columns, t, heights.dot(solution->terms), solution->covariance,
                      VectorXd::Zero(shape.parameters()),
                      withJoint(shape, heights, shape.perJoint(t, solution->terms))),
              solution->squares, shape.parameters()};
}

constexpr std::size_t fewest = 8;  // samples
bool isUninformative(const LocalWindow& window) {
  return window.points.size() < fewest ||
         !(window.points.back().displacement_mm > window.points.front().displacement_mm);
}

void add(std::vector<Said>& all, std::optional<Said> said) {
  if (said && std::isfinite(said->squares + said->place.variance_mm2 + said->place.variance_N2))
    all.push_back(*said);
}

}  // namespace

std::optional<LocalPlace> extremumIn(const LocalWindow& window, double sign) {
  if (isUninformative(window)) return {};
  const Columns columns(window);
  std::vector<Said> all;
  for (int degree = 2; degree <= 6; ++degree) add(all, extremumOf(columns, {degree}, sign));
  using Joint = Shape::Joint;
  const auto rough = meanPlace(all, columns);
  const double joint = rough ? std::clamp(columns.at(rough->displacement_mm), -0.7, 0.7) : 0;
  for (int degree = 2; degree <= 4; ++degree)
    add(all, extremumOf(columns, {degree, Joint::level, 0, 0, joint}, sign));
  for (int degree = 2; degree <= 3; ++degree)
    add(all, extremumOf(columns, {degree, Joint::bent, 2, degree, joint}, sign));
  return meanPlace(all, columns);
}

std::optional<LocalPlace> cornerIn(const LocalWindow& window, double near_mm) {
  if (isUninformative(window)) return {};
  const Columns columns(window);
  const double joint = columns.at(near_mm);
  std::vector<Said> all;
  for (int below = 1; below <= 3; ++below)
    for (int bottomOut = 1; bottomOut <= 3; ++bottomOut)
      add(all, cornerOf(columns, {below, Shape::Joint::bent, 1, bottomOut, joint}));
  return meanPlace(all, columns);
}

std::optional<LocalPlace> forceAt(const LocalWindow& window, double displacement_mm) {
  if (isUninformative(window)) return {};
  const Columns columns(window);
  std::vector<Said> all;
  for (int degree = 0; degree <= 4; ++degree)
    add(all, forceBy(columns, {degree}, columns.at(displacement_mm)));
  return meanPlace(all, columns);
}

std::optional<LocalPlace> beginningOf(const LocalWindow& window) {
  if (isUninformative(window)) return {};
  const Columns columns(window);
  std::vector<Said> all;
  for (int degree = 0; degree <= 3; ++degree) add(all, forceBy(columns, {degree}, -1));
  for (int degree = 0; degree <= 1; ++degree)
    for (int rise = 1; rise <= 3; ++rise)
      add(all, forceBy(columns, {degree, Shape::Joint::bent, 1, rise, 0.5}, -1));
  return meanPlace(all, columns);
}

}  // namespace detent::importer
