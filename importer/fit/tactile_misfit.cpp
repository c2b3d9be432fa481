// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/tactile_misfit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

namespace detent::importer {
namespace {

constexpr std::size_t fewestMisfitPoints = 14;
constexpr int chainParameters =
    5;  // parameters of the window: a knot's place, and half of what its two pieces share with others

/// Points around an extremum: t in -1..1 of the half width, v upright.
struct Window {
  double halfWidth_u = 1;
  Eigen::VectorXd t, v, weight;
};

/// Weight of a force residual for the orthogonal distance to first order.
double weightOf(double slope) { return 1 / std::sqrt(1 + slope * slope); }

/// Index of the last point from `peak` in direction `step` before the force exceeds the extremum again.
std::size_t reachOf(const std::vector<double>& heights, std::size_t peak, double height, int step) {
  std::size_t at = peak;
  const auto last = step > 0 ? heights.size() - 1 : 0;
  while (at != last && heights[at + static_cast<std::size_t>(step)] < height)
    at += static_cast<std::size_t>(step);
  return at;
}

std::vector<double> runningMeans(const std::vector<SigmaPoint>& points, double sign) {
  constexpr std::size_t reach = 2;
  std::vector<double> means;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t from = i < reach ? 0 : i - reach, to = std::min(points.size() - 1, i + reach);
    double sum = 0;
    for (std::size_t k = from; k <= to; ++k) sum += points[k].v;
    means.push_back(sign * sum / static_cast<double>(to - from + 1));
  }
  return means;
}

Window windowAround(const std::vector<SigmaPoint>& points, const ChainKnot& at, double sign) {
  constexpr double dropShare = 0.5;  // share of the shallower side's drop within which points are used
  constexpr double noise = 3;        // sigmas by which a point may exceed the extremum
  const std::vector<double> heights = runningMeans(points, sign);
  const double height = sign * at.v();
  const auto beyond =
      std::find_if(points.begin(), points.end(), [&](const SigmaPoint& p) { return p.u >= at.u(); });
  const auto peak = std::min(points.size() - 1, static_cast<std::size_t>(beyond - points.begin()));
  const std::size_t left = reachOf(heights, peak, height + noise, -1),
                    right = reachOf(heights, peak, height + noise, 1);
  const auto begin = heights.begin();
  const double lowLeft = *std::min_element(begin + static_cast<std::ptrdiff_t>(left),
                                           begin + static_cast<std::ptrdiff_t>(peak) + 1);
  const double lowRight = *std::min_element(begin + static_cast<std::ptrdiff_t>(peak),
                                            begin + static_cast<std::ptrdiff_t>(right) + 1);
  const double floor = height - dropShare * (height - std::max(lowLeft, lowRight));
  std::size_t from = peak, to = peak;
  while (from > left && heights[from - 1] > floor) --from;
  while (to < right && heights[to + 1] > floor) ++to;

  Window window;
  window.halfWidth_u = std::max(at.u() - points[from].u, points[to].u - at.u());
  if (!(window.halfWidth_u > 0)) return window;
  const auto count = static_cast<Eigen::Index>(to - from + 1);
  window.t.resize(count), window.v.resize(count);
  window.weight = Eigen::VectorXd::Ones(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const SigmaPoint& p = points[from + static_cast<std::size_t>(i)];
    window.t[i] = (p.u - at.u()) / window.halfWidth_u;
    window.v[i] = sign * p.v - height;
  }
  return window;
}

/// One local model: its extremum and its quality.
struct LocalModel {
  double t = 0, v = 0, squares = 0;
  int parameters = 0;
};

Eigen::MatrixXd powersOf(const Eigen::VectorXd& t, int degree) {
  Eigen::MatrixXd columns(t.size(), degree + 1);
  columns.col(0).setOnes();
  for (int k = 1; k <= degree; ++k) columns.col(k) = columns.col(k - 1).cwiseProduct(t);
  return columns;
}

Eigen::VectorXd solved(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values,
                       const Eigen::VectorXd& weight) {
  return (weight.asDiagonal() * columns).colPivHouseholderQr().solve(weight.cwiseProduct(values));
}

double squaresOf(const Eigen::VectorXd& residuals, const Eigen::VectorXd& weight) {
  return weight.cwiseProduct(residuals).squaredNorm();
}

/// Value, slope and curvature of a polynomial.
std::array<double, 3> valueOf(const Eigen::VectorXd& c, double t) {
  double value = 0, slope = 0, bend = 0;
  for (Eigen::Index k = c.size(); k-- > 0;)
    bend = bend * t + 2 * slope, slope = slope * t + value, value = value * t + c[k];
  return {value, slope, bend};
}

/// A polynomial over the whole window.
std::optional<LocalModel> smoothModel(const Window& window, int degree) {
  const Eigen::MatrixXd columns = powersOf(window.t, degree);
  const Eigen::VectorXd c = solved(columns, window.v, window.weight);
  double t = 0;
  for (int i = 0; i < 30; ++i) {
    const auto [value, slope, bend] = valueOf(c, t);
    if (!(bend < 0)) return {};
    t -= std::clamp(slope / bend, -0.3, 0.3);
    if (std::abs(t) > 1) return {};
  }
  return LocalModel{t, valueOf(c, t)[0], squaresOf(window.v - columns * c, window.weight), degree + 1};
}

/// Two polynomials that meet level at the extremum with separate curvatures, like two pieces of the fit.
std::optional<LocalModel> splitModel(const Window& window, int degree) {
  const Eigen::Index sides = 2 * (degree - 1);
  LocalModel model{0, 0, 0, static_cast<int>(sides) + 2};
  Eigen::MatrixXd columns(window.t.size(),
                          sides + 2);  // height, powers from 2 on of each side, shift of the extremum
  for (int i = 0; i < 30; ++i) {
    columns.setZero();
    columns.col(0).setOnes();
    for (Eigen::Index p = 0; p < window.t.size(); ++p) {
      const double t = window.t[p] - model.t;
      const Eigen::Index side = t < 0 ? 1 : degree;
      for (int k = 2; k <= degree; ++k) columns(p, side + k - 2) = std::pow(t, k);
    }
    const Eigen::VectorXd c = solved(columns.leftCols(sides + 1), window.v, window.weight);
    for (Eigen::Index p = 0; p < window.t.size(); ++p) {
      const double t = window.t[p] - model.t;
      const Eigen::Index side = t < 0 ? 1 : degree;
      for (int k = 2; k <= degree; ++k) columns(p, sides + 1) -= k * c[side + k - 2] * std::pow(t, k - 1);
    }
    const Eigen::VectorXd residuals = window.v - columns.leftCols(sides + 1) * c;
    model.v = c[0], model.squares = squaresOf(residuals, window.weight);
    const double step = std::clamp(solved(columns, residuals, window.weight)[sides + 1], -0.2, 0.2);
    if (!std::isfinite(step)) return {};
    if (std::abs(step) < 1e-7) break;
    model.t += step;
    if (std::abs(model.t) > 0.8) return {};
  }
  return model;
}

/// Heights of the chain at the window's points relative to its extremum; weights by its slopes.
Eigen::VectorXd chainHeights(const KnotChain& chain, const ChainKnot& at, double sign, Window& window) {
  const std::vector<ChainPiece> pieces = piecesOf(chain);
  Eigen::VectorXd heights(window.t.size());
  std::size_t piece = 0;
  for (Eigen::Index i = 0; i < window.t.size(); ++i) {
    const double u = at.u() + window.t[i] * window.halfWidth_u;
    while (piece + 1 < pieces.size() && chain[piece + 1].u() <= u) ++piece;
    const ChainPiece& here = pieces[piece];
    const double t = here.h > 0 ? std::clamp((u - here.u0) / here.h, 0.0, 1.0) : 1;
    heights[i] = sign * (here.v(t) - at.v());
    window.weight[i] = here.h > 0 ? weightOf(here.dv(t) / here.h) : 0;
  }
  return heights;
}

}  // namespace

TactileMisfit tactileMisfit(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                            const ChainKnot& at, double sign, double correlationPoints) {
  Window window = windowAround(points, at, sign);
  const auto count = static_cast<std::size_t>(window.t.size());
  if (count < fewestMisfitPoints) return {};
  const Eigen::VectorXd own = chainHeights(chain, at, sign, window);
  std::vector<LocalModel> models{{0, 0, squaresOf(window.v - own, window.weight), chainParameters}};
  for (const int degree : {4, 5, 6})
    if (const auto model = smoothModel(window, degree)) models.push_back(*model);
  for (const int degree : {3, 4})
    if (const auto model = splitModel(window, degree)) models.push_back(*model);

  const double independent = static_cast<double>(count) / correlationPoints;
  const auto score = [&](const LocalModel& m) {  // Akaike 1974
    return independent * std::log(std::max(m.squares, 1e-12) / static_cast<double>(count)) + 2 * m.parameters;
  };
  double best = score(models.front());
  for (const LocalModel& m : models) best = std::min(best, score(m));
  double sum = 0, t = 0, v = 0;
  for (const LocalModel& m : models) {
    const double likely = std::exp(-0.5 * (score(m) - best));
    sum += likely, t += likely * m.t, v += likely * m.v;
  }
  return {t / sum * window.halfWidth_u, sign * v / sum};
}

}  // namespace detent::importer
