// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/calibrate.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

namespace detent::playback {

namespace {

constexpr std::size_t fewestWeights = 3;
constexpr int risingChecks = 200;

struct Fit {
  SensorCalibration calibration;
  double aicc = std::numeric_limits<double>::infinity();
};

/// Weighted polynomial least squares by QR (modified Gram-Schmidt on the weighted, scaled Vandermonde
/// matrix).
std::optional<Fit> fitDegree(const std::vector<KnownWeight>& weights, const CalibrationSettings& settings,
                             std::size_t degree) {
  const std::size_t n = weights.size(), m = degree + 1;
  if (n <= m) return {};
  SensorCalibration c;
  c.circuit = settings.circuit;
  c.fullScale_counts = settings.fullScale_counts;
  double scale = 0;
  for (const KnownWeight& w : weights) scale = std::max(scale, std::fabs(c.linearised(w.raw)));
  if (!(scale > 0)) return {};
  std::vector<std::vector<double>> q(m, std::vector<double>(n)), r(m, std::vector<double>(m, 0));
  std::vector<double> y(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double sigma = std::hypot(settings.absoluteError_N, settings.relativeError * weights[i].force_N);
    const double u = c.linearised(weights[i].raw) / scale;
    double power = 1;
    for (std::size_t k = 0; k < m; ++k, power *= u) q[k][i] = power / sigma;
    y[i] = weights[i].force_N / sigma;
  }
  const auto dot = [n](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += a[i] * b[i];
    return sum;
  };
  std::vector<double> projected(m), residual = y;
  for (std::size_t k = 0; k < m; ++k) {
    const double before = std::sqrt(dot(q[k], q[k]));
    for (std::size_t j = 0; j < k; ++j) {
      r[j][k] = dot(q[j], q[k]);
      for (std::size_t i = 0; i < n; ++i) q[k][i] -= r[j][k] * q[j][i];
    }
    r[k][k] = std::sqrt(dot(q[k], q[k]));
    if (!(r[k][k] > 1e-9 * before)) return {};  // the weights do not tell this degree from the lower one
    for (std::size_t i = 0; i < n; ++i) q[k][i] /= r[k][k];
    projected[k] = dot(q[k], residual);
    for (std::size_t i = 0; i < n; ++i) residual[i] -= projected[k] * q[k][i];
  }
  // Back substitution for the coefficients and for the columns of R^-1, which give the covariance.
  std::vector<double> beta(m);
  std::vector<std::vector<double>> inverse(m, std::vector<double>(m, 0));
  for (std::size_t k = m; k-- > 0;) {
    double sum = projected[k];
    for (std::size_t j = k + 1; j < m; ++j) sum -= r[k][j] * beta[j];
    beta[k] = sum / r[k][k];
    for (std::size_t column = 0; column < m; ++column) {
      double value = column == k ? 1 : 0;
      for (std::size_t j = k + 1; j < m; ++j) value -= r[k][j] * inverse[j][column];
      inverse[k][column] = value / r[k][k];
    }
  }
  const double chi2 = dot(residual, residual);
  const double variance = chi2 / static_cast<double>(n - m);
  c.coefficientCount = m;
  c.coefficients = {};
  double power = 1;
  for (std::size_t k = 0; k < m; ++k, power *= scale) {
    c.coefficients[k] = beta[k] / power;
    double sum = 0;
    for (std::size_t j = 0; j < m; ++j) sum += inverse[k][j] * inverse[k][j];
    c.standardErrors[k] = std::sqrt(variance * sum) / power;
  }
  double squares = 0;
  c.lowest_N = std::numeric_limits<double>::infinity();
  c.highest_N = -c.lowest_N;
  for (const KnownWeight& w : weights) {
    squares += std::pow(c.force_N(w.raw) - w.force_N, 2);
    c.lowest_N = std::min(c.lowest_N, w.force_N);
    c.highest_N = std::max(c.highest_N, w.force_N);
  }
  c.residual_N = std::sqrt(squares / static_cast<double>(n - m));
  c.weights = n;
  const auto count = static_cast<double>(n), parameters = static_cast<double>(m + 1);
  if (count - parameters - 1 <= 0) return {};
  Fit fit;
  fit.calibration = c;
  fit.aicc =
      count * std::log(std::max(chi2 / count, 1e-30)) + 2 * parameters * count / (count - parameters - 1);
  return fit;
}

bool rises(const SensorCalibration& c, const std::vector<KnownWeight>& weights) {
  const auto [low, high] =
      std::minmax_element(weights.begin(), weights.end(),
                          [](const KnownWeight& a, const KnownWeight& b) { return a.raw < b.raw; });
  double before = -std::numeric_limits<double>::infinity();
  for (int i = 0; i <= risingChecks; ++i) {
    const double force = c.force_N(low->raw + (high->raw - low->raw) * i / risingChecks);
    if (!(force > before)) return false;
    before = force;
  }
  return true;
}

}  // namespace

Result<SensorCalibration> calibrate(const std::vector<KnownWeight>& weights,
                                    const CalibrationSettings& settings) {
  SensorCalibration circuit;
  circuit.circuit = settings.circuit;
  circuit.fullScale_counts = settings.fullScale_counts;
  std::set<double> different;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!std::isfinite(weights[i].force_N) || !std::isfinite(circuit.linearised(weights[i].raw))) {
      return Failure{FailureCode::unreadableInput, "calibration", "weight " + std::to_string(i + 1),
                     "is not a usable reading (not a number, or the sensor is saturated)",
                     "Leave it out or lower the load"};
    }
    different.insert(weights[i].force_N);
  }
  if (different.size() < fewestWeights) {
    return Failure{FailureCode::unreadableInput, "calibration", "",
                   std::to_string(different.size()) + " different weights, at least 3 are needed",
                   "Add weights over the range you press in"};
  }
  std::optional<Fit> best;
  for (std::size_t degree = 1; degree <= std::clamp(settings.highestDegree, 1U, 3U); ++degree) {
    if (degree + 1 > different.size() - (different.size() > 2 ? 1 : 0)) break;
    const std::optional<Fit> fit = fitDegree(weights, settings, degree);
    if (fit && rises(fit->calibration, weights) && (!best || fit->aicc < best->aicc)) best = fit;
  }
  if (!best) {
    return Failure{FailureCode::unreadableInput, "calibration", "", "the readings do not rise with the force",
                   "Check the wiring and the order of the weights; at least 5 readings are needed"};
  }
  return best->calibration;
}

Result<std::vector<KnownWeight>> parseWeights(const std::string& text, const std::string& name) {
  std::vector<KnownWeight> weights;
  std::istringstream lines(text);
  std::size_t number = 0;
  double unit_N = 0;
  const auto bad = [&](const char* problem) {
    return Failure{FailureCode::unreadableInput, name, "line " + std::to_string(number), problem,
                   "Give the header force_N,raw or mass_g,raw and two numbers per line"};
  };
  for (std::string line; std::getline(lines, line);) {
    ++number;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    if (unit_N == 0) {
      if (line == "force_N,raw")
        unit_N = 1;
      else if (line == "mass_g,raw")
        unit_N = 1e-3 * standardGravity_m_per_s2;
      else
        return bad("the header is missing");
      continue;
    }
    KnownWeight weight;
    const char* end = line.data() + line.size();
    const auto first = std::from_chars(line.data(), end, weight.force_N);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != ',')
      return bad("the first number is missing");
    const auto second = std::from_chars(first.ptr + 1, end, weight.raw);
    if (second.ec != std::errc() || second.ptr != end) return bad("the second number is missing");
    weight.force_N *= unit_N;
    weights.push_back(weight);
  }
  return weights;
}

}  // namespace detent::playback
