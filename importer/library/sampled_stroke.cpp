// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/sampled_stroke.h"

#include <algorithm>
#include <array>
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

/// Running means over equally many neighbours on either side, at most `reach`.
std::vector<double> runningMeans(const std::vector<double>& values, std::size_t reach) {
  std::vector<double> sums{0}, means;
  for (const double each : values) sums.push_back(sums.back() + each);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t near = std::min({reach, i, values.size() - 1 - i});
    means.push_back((sums[i + near + 1] - sums[i - near]) / static_cast<double>(2 * near + 1));
  }
  return means;
}

/// For a block of consecutive samples: orthonormal polynomials of increasing degree, and the autocovariances
/// of noise after a cubic is fitted. In that noise each sample passes a share on to the next; share 0 is
/// white noise.
struct Blocks {
  static constexpr std::size_t mostLags = 40;
  static constexpr Eigen::Index cubic = 4;  // number of terms
  static constexpr std::array shares{0.0, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.925, 0.95, 0.97};

  explicit Blocks(std::size_t length) : lags(std::min(mostLags, length / 2)) {
    constexpr Eigen::Index terms = 10;
    const auto count = static_cast<Eigen::Index>(length);
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(count, -1, 1);
    Eigen::MatrixXd powers(count, terms);
    powers.col(0).setOnes();
    for (Eigen::Index k = 1; k < terms; ++k) powers.col(k) = powers.col(k - 1).cwiseProduct(t);
    basis = Eigen::HouseholderQR<Eigen::MatrixXd>(powers).householderQ() *
            Eigen::MatrixXd::Identity(count, terms);
    const Eigen::MatrixXd taken = basis.leftCols(cubic);
    for (const double share : shares) {
      Eigen::MatrixXd noise(count, count);
      for (Eigen::Index apart = 0; apart < count; ++apart) {
        noise.diagonal(apart).setConstant(std::pow(share, static_cast<double>(apart)));
        noise.diagonal(-apart).setConstant(std::pow(share, static_cast<double>(apart)));
      }
      noise -= taken * (taken.transpose() * noise).eval();
      noise -= (noise * taken).eval() * taken.transpose();
      Eigen::VectorXd behind(static_cast<Eigen::Index>(lags));
      for (Eigen::Index lag = 0; lag < behind.size(); ++lag)
        behind[lag] = noise.diagonal(lag).sum() / static_cast<double>(count - cubic);
      behindCubic.push_back(std::move(behind));
    }
  }

  std::size_t lags;
  Eigen::MatrixXd basis;
  std::vector<Eigen::VectorXd> behindCubic;  ///< for each share, for noise of variance 1
};

struct Noise {
  double variance_N2 = 0;  ///< of the independent part of a reading
  double carried_N2 = 0;   ///< of the part that a reading passes on to the next, multiplied by `share`
  double share = 0;

  /// Number of readings that share one error.
  double together() const { return 1 + carried_N2 / variance_N2 * ((1 + share) / (1 - share) - 1); }
};

/// The most likely noise: the share whose autocovariances agree best with these.
Noise noiseBy(const Eigen::VectorXd& covariances, const Blocks& blocks) {
  const auto count = static_cast<double>(covariances.size());
  const auto score = [&](const Eigen::VectorXd& said, int parameters) {  // Schwarz 1978
    return count * std::log(std::max((said - covariances).squaredNorm(), 1e-300)) +
           parameters * std::log(count);
  };
  const Eigen::VectorXd& white = blocks.behindCubic.front();
  const double alone_N2 = covariances.dot(white) / white.squaredNorm();
  Noise best{alone_N2};
  double least = score(alone_N2 * white, 1);
  for (std::size_t i = 1; i < Blocks::shares.size(); ++i) {
    Eigen::MatrixX2d stacked(covariances.size(), 2);
    stacked << white, blocks.behindCubic[i];
    Eigen::Vector2d parts_N2 = stacked.colPivHouseholderQr().solve(covariances);
    if (!(parts_N2[1] > 0)) continue;
    if (parts_N2[0] < 0) parts_N2 = {0, covariances.dot(stacked.col(1)) / stacked.col(1).squaredNorm()};
    const double here = score(stacked * parts_N2, 3);
    if (here >= least) continue;
    least = here;
    best = {parts_N2.sum(), parts_N2[1], Blocks::shares[i]};
  }
  return best;
}

/// Mean autocovariances over blocks that a cubic fits as well as any higher polynomial; nullopt if there are
/// none.
std::optional<Eigen::VectorXd> covariancesBehindCubics(const std::vector<CurvePoint>& points,
                                                       const Blocks& blocks, double together) {
  const auto length = static_cast<std::size_t>(blocks.basis.rows());
  const double independent = static_cast<double>(length) / together;
  const double freedom = static_cast<double>(length) - static_cast<double>(Blocks::cubic);
  std::vector<Eigen::VectorXd> plain;
  Eigen::VectorXd forces(blocks.basis.rows());
  for (std::size_t from = 0; from + length <= points.size(); from += length / 4) {
    for (std::size_t i = 0; i < length; ++i)
      forces[static_cast<Eigen::Index>(i)] = points[from + i].force_N - points[from].force_N;
    const Eigen::VectorXd terms = blocks.basis.transpose() * forces;
    const Eigen::VectorXd rest = forces - blocks.basis.leftCols(Blocks::cubic) * terms.head(Blocks::cubic);
    const double squares = rest.squaredNorm();
    if (squares == 0) continue;  // before contact readings may be constant
    bool isCubic = true;         // Schwarz 1978
    for (const Eigen::Index terms_more : {2, 4, 6}) {
      const double left = squares - terms.segment(Blocks::cubic, terms_more).squaredNorm();
      isCubic = isCubic && independent * std::log(std::max(left, 1e-300) / std::max(squares, 1e-300)) +
                                   static_cast<double>(terms_more) * std::log(independent) >=
                               0;
    }
    if (!isCubic) continue;
    Eigen::VectorXd& covariances = plain.emplace_back(static_cast<Eigen::Index>(blocks.lags));
    for (Eigen::Index lag = 0; lag < covariances.size(); ++lag)
      covariances[lag] = rest.head(rest.size() - lag).dot(rest.tail(rest.size() - lag)) / freedom;
  }
  if (plain.empty()) return {};
  constexpr double like = 1.7, quiet = 0.3;  // times the variance below which this share of the blocks lies
  std::ranges::sort(plain, {}, [](const Eigen::VectorXd& each) { return each[0]; });
  const double most_N2 = like * plain[static_cast<std::size_t>(quiet * static_cast<double>(plain.size()))][0];
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(blocks.lags));
  double taken = 0;
  for (const Eigen::VectorXd& each : plain)
    if (each[0] <= most_N2) sum += each, ++taken;
  return sum / taken;
}

}  // namespace

SampledStroke::SampledStroke(const StrokeCurve& curve, const std::vector<CurvePoint>& points)
    : curve_(curve), points_(points) {
  if (points_.front().displacement_mm > points_.back().displacement_mm) std::ranges::reverse(points_);
  std::ranges::stable_sort(points_, {}, &CurvePoint::displacement_mm);  // a displacement sensor may be noisy
  std::vector<double> steps;
  for (std::size_t i = 1; i < points_.size(); ++i)
    if (const double step = std::abs(points_[i].displacement_mm - points_[i - 1].displacement_mm); step > 0)
      steps.push_back(step);
  step_mm_ = median(steps);
  // share of a step; share of the readings, because a displacement is often read twice at the turn
  constexpr double oneStep = 0.01, mostly = 0.98;
  const auto ones = std::ranges::count_if(
      steps, [&](double step) { return std::abs(step - step_mm_) < oneStep * step_mm_; });
  even_ = static_cast<double>(ones) > mostly * static_cast<double>(points_.size() - 1);
  weighNoise();
}

/// Estimates the noise from stretches of samples that a cubic fits: its size, and how many samples share one
/// error.
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
    std::vector<double> bends;  // each bend contains white noise with six times the variance of one sample
    for (std::size_t i = 1; i + 1 < points_.size(); ++i)
      bends.push_back(std::abs(points_[i - 1].force_N - 2 * points_[i].force_N + points_[i + 1].force_N));
    noise_N_ = std::max(noise_N_, perMedian * median(bends) / std::sqrt(6.0));
  };
  if (length < fewest) return byBends();
  static const Blocks usual(longest);
  const std::optional<Blocks> own = length == longest ? std::nullopt : std::optional<Blocks>(length);
  const Blocks& blocks = own ? *own : usual;
  // An error that neighbouring samples share resembles a bend of the curve. The second round therefore weighs
  // the samples by the noise that the first round estimated.
  std::optional<Noise> found;
  for (int round = 0; round < 2; ++round) {
    const auto covariances = covariancesBehindCubics(points_, blocks, found ? found->together() : 1);
    if (!covariances) break;
    found = noiseBy(*covariances, blocks);
  }
  if (!found) return byBends();
  noise_N_ = std::max(noise_N_, std::sqrt(found->variance_N2));
  together_ = found->together();
  carried_N2_ = found->carried_N2, share_ = found->share;
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
  // If each displacement is rounded separately, the error moves the force by the curve's slope.
  const double rounded_mm = even_ ? 0 : step_mm_ / std::sqrt(12.0);
  constexpr double least = 1e-3;  // of the noise: every reading has a part of its own
  const double own_N2 =
      noise_N_ > 0 ? std::max(noise_N_ * noise_N_ - carried_N2_, least * noise_N_ * noise_N_) : 1;
  window.carried = carried_N2_;
  window.share = share_;
  for (std::size_t i = from; i < to; ++i) {
    const double at_mm = std::clamp(points_[i].displacement_mm, curve_.start_mm(), curve_.end_mm());
    window.points.push_back(points_[i]);
    // Rounding of a displacement is each sample's own error.
    window.own.push_back(own_N2 + std::pow(rounded_mm * curve_.slope_N_per_mm(at_mm), 2));
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
  // times the other side's reach: one side may be steep and the other flat
  constexpr std::size_t lopsided = 2;
  const std::size_t left = at - std::min(from, at), right = std::max(to, at) - at;
  from = at - std::min(left, std::max<std::size_t>(lopsided * right, reach));
  to = at + std::min(right, std::max<std::size_t>(lopsided * left, reach));
  return window(from, to + 1);
}

LocalWindow SampledStroke::atStart(double to_mm) const {
  constexpr double leaves = 20;       // in noises: the force leaves its first value
  constexpr std::size_t fewest = 12;  // samples
  std::size_t end = 1;
  while (end < points_.size() && points_[end].displacement_mm < to_mm &&
         (end < fewest || std::abs(points_[end].force_N - points_.front().force_N) < leaves * noise_N_))
    ++end;
  return window(0, end);
}

}  // namespace detent::importer
