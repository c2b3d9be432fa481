// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/sampled_stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Dense>

namespace detent::importer {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Means over as many neighbours to either side as there are, at most `reach`.
std::vector<double> runningMeans(const std::vector<double>& values, std::size_t reach) {
  std::vector<double> sums{0}, means;
  for (const double each : values) sums.push_back(sums.back() + each);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t near = std::min({reach, i, values.size() - 1 - i});
    means.push_back((sums[i + near + 1] - sums[i - near]) / static_cast<double>(2 * near + 1));
  }
  return means;
}

}  // namespace

SampledStroke::SampledStroke(const StrokeCurve& curve, const std::vector<CurvePoint>& points)
    : curve_(curve), points_(points) {
  if (points_.front().displacement_mm > points_.back().displacement_mm) std::ranges::reverse(points_);
  std::ranges::stable_sort(points_, {}, &CurvePoint::displacement_mm);  // a sensor's place may tremble
  std::vector<double> steps;
  for (std::size_t i = 1; i < points_.size(); ++i)
    if (const double step = std::abs(points_[i].displacement_mm - points_[i - 1].displacement_mm); step > 0)
      steps.push_back(step);
  step_mm_ = median(steps);
  constexpr double oneStep = 0.01, mostly = 0.98;  // of a step; of the readings: a turn is often read twice
  const auto ones = std::ranges::count_if(
      steps, [&](double step) { return std::abs(step - step_mm_) < oneStep * step_mm_; });
  even_ = static_cast<double>(ones) > mostly * static_cast<double>(points_.size() - 1);
  weighNoise();
}

/// Polynomials of rising degree through so many samples side by side, orthonormal; and what the autocovariances of white noise add up
/// to behind a cubic.
struct SampledStroke::Blocks {
  static constexpr std::size_t lags = 20;
  static constexpr Eigen::Index cubic = 4;  // terms

  explicit Blocks(std::size_t length) {
    constexpr Eigen::Index terms = 10;
    const auto count = static_cast<Eigen::Index>(length);
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(count, -1, 1);
    Eigen::MatrixXd powers(count, terms);
    powers.col(0).setOnes();
    for (Eigen::Index k = 1; k < terms; ++k) powers.col(k) = powers.col(k - 1).cwiseProduct(t);
    basis = Eigen::HouseholderQR<Eigen::MatrixXd>(powers).householderQ() *
            Eigen::MatrixXd::Identity(count, terms);
    for (std::size_t lag = 0; lag < lags; ++lag) {
      const auto k = static_cast<Eigen::Index>(lag);
      double taken = 0;
      for (Eigen::Index i = 0; i + k < count; ++i)
        taken += basis.row(i).head(cubic).dot(basis.row(i + k).head(cubic));
      ofWhite += shareOf(lag) * ((lag == 0 ? static_cast<double>(count) : 0) - taken);
    }
    ofWhite /= static_cast<double>(count - cubic);
  }
  /// Of a lag's autocovariance in the variance of a mean (Newey and West 1987).
  static double shareOf(std::size_t lag) {
    return lag == 0 ? 1 : 2 * (1 - static_cast<double>(lag) / static_cast<double>(lags));
  }

  Eigen::MatrixXd basis;
  double ofWhite = 0;
};

/// Noise from the stretches of samples through which a cubic runs as well as any higher polynomial: their scatter about it, and by their
/// autocovariances how many share one error.
void SampledStroke::weighNoise() {
  constexpr std::size_t longest = 200, fewest = 30;  // samples
  const std::size_t length = std::min(longest, points_.size() / 2);
  double resolution_N = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points_.size(); ++i)
    if (const double step_N = std::abs(points_[i].force_N - points_[i - 1].force_N); step_N > 1e-9)
      resolution_N = std::min(resolution_N, step_N);
  if (std::isfinite(resolution_N)) noise_N_ = resolution_N / std::sqrt(12.0);
  const auto byBends = [&] {
    constexpr double perMedian = 1.4826;  // standard deviations of normal noise
    std::vector<double> bends;            // of white noise, six variances each
    for (std::size_t i = 1; i + 1 < points_.size(); ++i)
      bends.push_back(std::abs(points_[i - 1].force_N - 2 * points_[i].force_N + points_[i + 1].force_N));
    noise_N_ = std::max(noise_N_, perMedian * median(bends) / std::sqrt(6.0));
  };
  if (length < fewest) return byBends();
  static const Blocks usual(longest);
  const std::optional<Blocks> own = length == longest ? std::nullopt : std::optional<Blocks>(length);
  const Blocks& blocks = own ? *own : usual;
  struct Stretch {
    double variance_N2 = 0, shared_N2 = 0;
  };
  std::vector<Stretch> plain;
  const auto count = static_cast<double>(length);
  const double freedom = count - static_cast<double>(Blocks::cubic);
  Eigen::VectorXd forces(static_cast<Eigen::Index>(length));
  for (std::size_t from = 0; from + length <= points_.size(); from += length / 4) {
    for (std::size_t i = 0; i < length; ++i)
      forces[static_cast<Eigen::Index>(i)] = points_[from + i].force_N - points_[from].force_N;
    const Eigen::VectorXd terms = blocks.basis.transpose() * forces;
    const Eigen::VectorXd rest = forces - blocks.basis.leftCols(Blocks::cubic) * terms.head(Blocks::cubic);
    const double squares = rest.squaredNorm();
    Stretch stretch{squares / freedom, 0};
    for (std::size_t lag = 0; lag < Blocks::lags; ++lag) {
      const Eigen::Index n = rest.size() - static_cast<Eigen::Index>(lag);
      stretch.shared_N2 += Blocks::shareOf(lag) * rest.head(n).dot(rest.tail(n)) / freedom;
    }
    if (squares == 0) continue;  // before contact a reading may stand still
    bool isCubic = true;         // Schwarz 1978
    for (const Eigen::Index terms_more : {2, 4, 6}) {
      const double left = squares - terms.segment(Blocks::cubic, terms_more).squaredNorm();
      isCubic = isCubic && count * std::log(std::max(left, 1e-300) / std::max(squares, 1e-300)) +
                                   static_cast<double>(terms_more) * std::log(count) >=
                               0;
    }
    if (isCubic) plain.push_back(stretch);
  }
  if (plain.empty()) return byBends();
  constexpr double like = 1.7, quiet = 0.3;  // times the variance below which that share of the stretches is
  std::ranges::sort(plain, {}, &Stretch::variance_N2);
  const double most_N2 =
      like * plain[static_cast<std::size_t>(quiet * static_cast<double>(plain.size()))].variance_N2;
  Stretch sum;
  double taken = 0;
  for (const Stretch& each : plain)
    if (each.variance_N2 <= most_N2)
      sum.variance_N2 += each.variance_N2, sum.shared_N2 += each.shared_N2, ++taken;
  noise_N_ = std::max(noise_N_, std::sqrt(sum.variance_N2 / taken));
  if (sum.variance_N2 > 0) together_ = std::max(1.0, sum.shared_N2 / (sum.variance_N2 * blocks.ofWhite));
}

double SampledStroke::area_mJ(double from_mm, double to_mm) const {
  double area = 0;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double a = std::clamp(points_[i - 1].displacement_mm, from_mm, to_mm);
    const double b = std::clamp(points_[i].displacement_mm, from_mm, to_mm);
    area += 0.5 * (b - a) * (points_[i - 1].force_N + points_[i].force_N);
  }
  return area;
}

double SampledStroke::areaVariance() const {
  double squares = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, points_.size() - 1);
    squares += std::pow(0.5 * (points_[after].displacement_mm - points_[before].displacement_mm), 2);
  }
  return noise_N_ * noise_N_ * together_ * squares;
}

double SampledStroke::areaPerEnd_N() const {
  const double travel = last().displacement_mm - first().displacement_mm;
  return even_ ? area_mJ(first().displacement_mm, last().displacement_mm) / travel : last().force_N;
}

LocalWindow SampledStroke::window(std::size_t from, std::size_t to) const {
  LocalWindow window;
  // A place rounded by itself moves the force by the curve's slope.
  const double rounded_mm = even_ ? 0 : step_mm_ / std::sqrt(12.0);
  for (std::size_t i = from; i < to; ++i) {
    const double at_mm = std::clamp(points_[i].displacement_mm, curve_.start_mm(), curve_.end_mm());
    const double scatter_N = std::hypot(noise_N_, rounded_mm * curve_.slope_N_per_mm(at_mm));
    window.points.push_back(points_[i]);
    const double ofNoise = scatter_N > 0 ? noise_N_ / scatter_N : 1;
    window.weights.push_back(ofNoise);
    // What is rounded off a place is each sample's own.
    window.together.push_back(1 + (together_ - 1) * ofNoise * ofNoise);
  }
  return window;
}

LocalWindow SampledStroke::between(double from_mm, double to_mm) const {
  const auto from = std::ranges::lower_bound(points_, from_mm, {}, &CurvePoint::displacement_mm);
  const auto to = std::ranges::upper_bound(points_, to_mm, {}, &CurvePoint::displacement_mm);
  return from < to ? window(static_cast<std::size_t>(from - points_.begin()),
                            static_cast<std::size_t>(to - points_.begin()))
                   : LocalWindow{};
}

LocalWindow SampledStroke::around(double displacement_mm, double sign, double depth_N, double from_mm,
                                  double to_mm) const {
  constexpr std::size_t reach = 4;
  std::vector<double> heights;
  for (const CurvePoint& p : points_) heights.push_back(sign * p.force_N);
  heights = runningMeans(heights, reach);
  const auto index = [&](double at_mm) {
    const auto place =
        std::ranges::lower_bound(points_, at_mm, {}, &CurvePoint::displacement_mm) - points_.begin();
    return std::min(static_cast<std::size_t>(place), points_.size() - 1);
  };
  const std::size_t first = index(from_mm), last = index(to_mm);
  std::size_t from = std::clamp(index(displacement_mm), first, last), to = from;
  double top = heights[from];
  std::size_t at = from;
  const auto take = [&](std::size_t next) {
    if (heights[next] > top) top = heights[next], at = next;
    return next;
  };
  for (bool grew = true; grew;) {
    grew = false;
    if (from > first && heights[from - 1] > top - depth_N) from = take(from - 1), grew = true;
    if (to < last && heights[to + 1] > top - depth_N) to = take(to + 1), grew = true;
  }
  while (from < to && heights[from] < top - depth_N) ++from;
  while (to > from && heights[to] < top - depth_N) --to;
  constexpr std::size_t lopsided = 2;  // times the other side's reach: a steep side and a flat one
  const std::size_t left = at - std::min(from, at), right = std::max(to, at) - at;
  from = at - std::min(left, std::max<std::size_t>(lopsided * right, reach));
  to = at + std::min(right, std::max<std::size_t>(lopsided * left, reach));
  return window(from, to + 1);
}

LocalWindow SampledStroke::atStart(double to_mm) const {
  constexpr double leaves = 20;       // noises
  constexpr std::size_t fewest = 12;  // samples
  std::size_t end = 1;
  while (end < points_.size() && points_[end].displacement_mm < to_mm &&
         (end < fewest || std::abs(points_[end].force_N - points_.front().force_N) < leaves * noise_N_))
    ++end;
  return window(0, end);
}

}  // namespace detent::importer
