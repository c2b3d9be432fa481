// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/calibrate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include <Eigen/QR>

#include "model/number_table.h"
#include "playback/measurement/normal.h"

namespace detent::playback {

namespace {

constexpr std::size_t fewestWeights = 3;
constexpr std::size_t fewestReadings = 5;  // for two coefficients and a meaningful error
constexpr int risingChecks = 200;
constexpr double heaviest_N = 1e7;  // limit of the force of any button

struct Fit {
  SensorCalibration calibration;
  double aicc = std::numeric_limits<double>::infinity();
};

/// Weighted polynomial least squares by a rank-revealing QR of the scaled Vandermonde matrix.
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
  const auto rows = static_cast<Eigen::Index>(n), columns = static_cast<Eigen::Index>(m);
  Eigen::MatrixXd powers(rows, columns);
  Eigen::VectorXd forces(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const KnownWeight& weight = weights[static_cast<std::size_t>(i)];
    const double sigma = std::hypot(settings.absoluteError_N, settings.relativeError * weight.force_N);
    double power = 1 / sigma;
    for (Eigen::Index k = 0; k < columns; ++k, power *= c.linearised(weight.raw) / scale)
      powers(i, k) = power;
    forces(i) = weight.force_N / sigma;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(powers);
  qr.setThreshold(1e-9);
  if (qr.rank() < columns) return {};  // the weights do not distinguish this degree from the lower one
  const Eigen::VectorXd beta = qr.solve(forces);
  const double chi2 = (forces - powers * beta).squaredNorm();
  // The scatter of few weights is known poorly, so Student's 68.3 % quantile replaces one standard deviation.
  const double error = std::sqrt(chi2 / static_cast<double>(n - m)) * studentQuantile(normalCdf(1), n - m);
  const Eigen::MatrixXd inverse =
      qr.solve(Eigen::MatrixXd::Identity(rows, rows));  // the squared norms of its rows give the variances
  c.coefficientCount = m;
  c.coefficients = {};
  double power = 1;
  for (std::size_t k = 0; k < m; ++k, power *= scale) {
    const auto row = static_cast<Eigen::Index>(k);
    c.coefficients[k] = beta(row) / power;
    c.standardErrors[k] = error * inverse.row(row).norm() / power;
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
  if (!std::isfinite(c.residual_N))
    return {};  // the readings are so extreme that their powers exceed the range of a double
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
    if (!(std::fabs(weights[i].force_N) <= heaviest_N) ||
        !std::isfinite(circuit.linearised(weights[i].raw))) {
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
  if (weights.size() < fewestReadings) {
    return Failure{
        FailureCode::unreadableInput, "calibration", "",
        std::to_string(weights.size()) + " readings, at least 5 are needed to tell how well they fit",
        "Add weights over the range you press in, or weigh the same ones again"};
  }
  std::optional<Fit> best;
  for (std::size_t degree = 1; degree <= std::clamp(settings.highestDegree, 1U, 3U); ++degree) {
    if (degree + 1 > different.size() - (different.size() > 2 ? 1 : 0)) break;
    const std::optional<Fit> fit = fitDegree(weights, settings, degree);
    if (fit && rises(fit->calibration, weights) && (!best || fit->aicc < best->aicc)) best = fit;
  }
  if (!best) {
    return Failure{FailureCode::unreadableInput, "calibration", "", "the readings do not rise with the force",
                   "Check the wiring and the order of the weights"};
  }
  return best->calibration;
}

Result<std::vector<KnownWeight>> parseWeights(const std::string& text, const std::string& name) {
  std::vector<KnownWeight> weights;
  NumberTable table(text);
  const auto bad = [&](const char* problem) {
    return Failure{FailureCode::unreadableInput, name, table.place(), problem,
                   "Give the header force_N,raw or mass_g,raw and two numbers per line"};
  };
  double unit_N = 1;
  if (!table.next()) return weights;
  if (table.is({"mass_g", "raw"}))
    unit_N = 1e-3 * standardGravity_m_per_s2;
  else if (!table.is({"force_N", "raw"}))
    return bad("the header is missing");
  while (table.next()) {
    const auto force = table.finite(0), raw = table.finite(1);
    if (!force) return bad("the first number is missing");
    if (!raw || table.fields().size() != 2) return bad("the second number is missing");
    weights.push_back({unit_N * *force, *raw});
  }
  return weights;
}

}  // namespace detent::playback
