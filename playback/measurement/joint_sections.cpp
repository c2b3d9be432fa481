// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/joint_sections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>

#include <ceres/jet.h>
#include <ceres/tiny_solver.h>
#include <Eigen/Dense>

namespace detent::playback {
namespace {

constexpr std::size_t mostSections = 32;
constexpr int perSection = 3;  // logarithms of frequency and Q, height in dB
constexpr int ofLevel = 3;     // level: a parabola over the octaves
constexpr double keptRms_dB = 3, keptPlace = 0.1;

/// Gain of a peaking section (realtime/biquad.h), dB, at the angle of `cosine` and `sine`.
template <class T>
T sectionGain_dB(double cosine, double sine, double sampleRate_Hz, const T& logFrequency, const T& logQ,
                 const T& height_dB) {
  using std::cos, std::exp, std::log, std::sin;
  const T angle = exp(logFrequency) * (2 * std::numbers::pi / sampleRate_Hz);
  const T alpha = sin(angle) / (2.0 * exp(logQ)), amplitude = exp(height_dB * (std::numbers::ln10 / 40));
  const T beside = cos(angle) - cosine, up = alpha * amplitude * sine, down = alpha / amplitude * sine;
  return (10 / std::numbers::ln10) * log((beside * beside + up * up) / (beside * beside + down * down));
}

/// Residuals of a response after subtracting a set of sections, in the form of Ceres' solver for small
/// problems.
class Leftover {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  Leftover(const std::vector<double>& frequency_Hz, const std::vector<double>& gain_dB, std::size_t sections,
           double sampleRate_Hz)
      : sections_(static_cast<int>(sections)), sampleRate_Hz_(sampleRate_Hz) {
    const double middle_Hz = std::sqrt(frequency_Hz.front() * frequency_Hz.back());
    for (std::size_t i = 0; i < frequency_Hz.size(); ++i) {
      const double angle = 2 * std::numbers::pi * frequency_Hz[i] / sampleRate_Hz;
      // A sweep spends time at each frequency in inverse proportion to it, so the variance of the noise is
      // proportional to the frequency.
      const double weight = std::sqrt(middle_Hz / frequency_Hz[i]);
      places_.push_back(
          {std::cos(angle), std::sin(angle), std::log2(frequency_Hz[i] / middle_Hz), gain_dB[i], weight});
    }
  }

  int NumResiduals() const { return static_cast<int>(places_.size()); }
  int NumParameters() const { return perSection * sections_ + ofLevel; }

  bool operator()(const double* at, double* left, double* jacobian) const {
    Eigen::Map<Eigen::MatrixXd> slopes(jacobian, NumResiduals(), jacobian ? NumParameters() : 0);
    const double* const level = at + perSection * sections_;
    for (int row = 0; row < NumResiduals(); ++row) {
      const Place& p = places_[static_cast<std::size_t>(row)];
      double gain_dB = level[0] + p.octaves * (level[1] + p.octaves * level[2]);
      for (int k = 0; k < sections_; ++k) {
        using Three = ceres::Jet<double, perSection>;
        const double* const own = at + perSection * k;
        const Three part = sectionGain_dB(p.cosine, p.sine, sampleRate_Hz_, Three(own[0], 0),
                                          Three(own[1], 1), Three(own[2], 2));
        gain_dB += part.a;
        if (jacobian) slopes.block<1, perSection>(row, perSection * k) = p.weight * part.v.transpose();
      }
      if (jacobian)
        slopes.block<1, ofLevel>(row, perSection * sections_) << p.weight, p.weight * p.octaves,
            p.weight * p.octaves * p.octaves;
      left[row] = p.weight * (gain_dB - p.gain_dB);
      if (!std::isfinite(left[row])) return false;
    }
    return true;
  }

  /// Reduces the weight of frequencies with large residuals (hum, a lost block): 1 within three times the
  /// usual residual, decreasing beyond (Huber).
  void holdDown(const Eigen::VectorXd& left) {
    std::vector<double> sizes(left.data(), left.data() + left.size());
    for (double& size : sizes) size = std::fabs(size);
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    const double most = 3 * std::max(*middle / 0.6745, 1e-9);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const double size = std::fabs(left[static_cast<Eigen::Index>(i)]);
      if (size > most) places_[i].weight *= std::sqrt(most / size);
    }
  }

 private:
  struct Place {
    double cosine, sine, octaves, gain_dB, weight;
  };
  std::vector<Place> places_;
  int sections_;
  double sampleRate_Hz_;
};

Eigen::VectorXd startOf(const std::vector<Resonance>& start, const std::vector<double>& gain_dB) {
  std::vector<double> sorted = gain_dB;
  const auto quarter = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 4);
  std::nth_element(sorted.begin(), quarter, sorted.end());
  Eigen::VectorXd at = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(perSection * start.size()) + ofLevel);
  for (std::size_t k = 0; k < start.size(); ++k)
    at.segment<perSection>(static_cast<Eigen::Index>(perSection * k)) << std::log(start[k].frequency_Hz),
        std::log(start[k].q), start[k].gain_dB;
  at[at.size() - ofLevel] = *quarter;
  return at;
}

/// Number of neighbouring residuals that share one error: twice the sum of their correlations, up to where it
/// vanishes.
double alikeInARow(const Eigen::VectorXd& left) {
  const double all = left.squaredNorm();
  const Eigen::Index n = left.size();
  double row = 1;
  for (Eigen::Index lag = 1; lag < n / 4 && all > 0; ++lag) {
    const double correlation = left.head(n - lag).dot(left.tail(n - lag)) / all;
    if (correlation < 0.05) break;
    row += 2 * correlation;
  }
  return row;
}

/// The mean square of the residuals around each frequency.
Eigen::VectorXd varianceAround(const Eigen::VectorXd& left) {
  constexpr Eigen::Index reach =
      24;  // bins on either side: far more than share one error, far fewer than a resonance has
  const Eigen::Index n = left.size();
  Eigen::VectorXd variance(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - reach), to = std::min(n, i + reach + 1);
    variance[i] = left.segment(from, to - from).squaredNorm() / static_cast<double>(to - from);
  }
  return variance;
}

/// Covariance of the unknowns; nullopt if the response does not determine one of them. The noise in dB is
/// smaller where the response is higher, so each frequency is weighted with the variance of the residuals
/// around it (White 1980). Neighbours whose residuals agree count as one measurement.
std::optional<Eigen::MatrixXd> covarianceOf(const Leftover& leftover, const Eigen::VectorXd& at,
                                            const std::vector<double>& gain_dB) {
  Eigen::VectorXd left(leftover.NumResiduals());
  Eigen::MatrixXd slopes(leftover.NumResiduals(), leftover.NumParameters());
  if (!leftover(at.data(), left.data(), slopes.data())) return {};
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> known(slopes);
  if (known.rank() < slopes.cols()) return {};
  Eigen::VectorXd height(left.size());
  for (Eigen::Index i = 0; i < height.size(); ++i)
    height[i] = std::pow(10, gain_dB[static_cast<std::size_t>(i)] / 20);
  const Eigen::VectorXd noise = left.cwiseProduct(height), spread = varianceAround(noise).cwiseSqrt();
  const double row = alikeInARow(noise.cwiseQuotient(spread.cwiseMax(1e-12)));
  const Eigen::VectorXd variance = spread.cwiseQuotient(height).cwiseAbs2();
  const double independent = static_cast<double>(left.size()) / row;
  const double freedom = independent / std::max(1.0, independent - static_cast<double>(slopes.cols()));
  const Eigen::MatrixXd inverse = (slopes.transpose() * slopes).inverse();
  return Eigen::MatrixXd(inverse * (slopes.transpose() * variance.asDiagonal() * slopes) * inverse *
                         (row * freedom));
}

bool keptItsPlace(const Resonance& fitted, const Resonance& start) {
  const double moved = std::fabs(std::log(fitted.frequency_Hz / start.frequency_Hz));
  return moved < keptPlace && fitted.q > 0.2 && fitted.q < 200 && fitted.gain_dB > 0 && fitted.gain_dB < 80;
}

}  // namespace

std::optional<JointSections> fitSectionsTogether(const std::vector<double>& frequency_Hz,
                                                 const std::vector<double>& gain_dB,
                                                 const std::vector<Resonance>& start, double sampleRate_Hz) {
  const std::size_t unknowns = perSection * start.size() + ofLevel;
  if (start.empty() || start.size() > mostSections || frequency_Hz.size() < 4 * unknowns) return {};
  Leftover leftover(frequency_Hz, gain_dB, start.size(), sampleRate_Hz);
  Eigen::VectorXd at = startOf(start, gain_dB), left(leftover.NumResiduals());
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    ceres::TinySolver<Leftover> solver;
    solver.options.max_num_iterations = 60;
    solver.Solve(leftover, &at);
    if (!at.allFinite() || !leftover(at.data(), left.data(), nullptr)) return {};
    if (round + 1 < rounds) leftover.holdDown(left);
  }
  const auto covariance = covarianceOf(leftover, at, gain_dB);
  if (!covariance || !covariance->allFinite()) return {};

  JointSections fit;
  fit.rms_dB = std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
  if (!(fit.rms_dB < keptRms_dB)) return {};
  std::vector<std::size_t> order(start.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto height_dB = [&](std::size_t k) { return at[static_cast<Eigen::Index>(perSection * k) + 2]; };
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return height_dB(a) > height_dB(b); });
  for (const std::size_t k : order) {
    const auto own = static_cast<Eigen::Index>(perSection * k);
    const Resonance found{std::exp(at[own]), std::exp(at[own + 1]), at[own + 2]};
    if (!keptItsPlace(found, start[k])) return {};
    const auto sigma = [&](Eigen::Index i) {
      return std::sqrt(std::max(0.0, (*covariance)(own + i, own + i)));
    };
    fit.resonances.push_back(found);
    fit.errors.push_back({found.frequency_Hz * sigma(0), found.q * sigma(1), sigma(2)});
  }
  return fit;
}

}  // namespace detent::playback
