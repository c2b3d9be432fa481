// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/identification/identify.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ceres/ceres.h>
#include <Eigen/Dense>

#include "playback/identification/record_velocity.h"

namespace detent::playback {

namespace {

constexpr std::size_t fewestSamples = 30, mostKnots = 32;
constexpr double leastMovement_quanta = 10;
// Speed counts as constant if 80 % of the moving samples lie within this share of the median.
constexpr double constantSpread = 0.15;
constexpr double movingShare = 0.1;  // of the fastest: slower samples tell nothing about speed
constexpr double standsOut = 3;      // standard errors
constexpr double mmPerM = 1000;

/// Which columns the fit has, in this order: c, k at the knots, b at the knots, m.
struct Columns {
  std::size_t knots = 1;
  bool damping = true, mass = true;
  std::size_t count() const { return 1 + knots + (damping ? knots : 0) + (mass ? 1 : 0); }
};

struct Sample {
  double x_mm, v_mm_per_s, a_mm_per_s2, force_N;
};

/// Adds to `out` what the slope at a knot takes of the knots' values, `factor` times: that of the parabola through three of them.
void addSlope(std::size_t knots, std::size_t at, double factor, double* out) {
  if (knots == 2) {
    out[0] -= factor, out[1] += factor;
  } else if (at == 0) {
    out[0] -= 1.5 * factor, out[1] += 2 * factor, out[2] -= 0.5 * factor;
  } else if (at == knots - 1) {
    out[at] += 1.5 * factor, out[at - 1] -= 2 * factor, out[at - 2] += 0.5 * factor;
  } else {
    out[at + 1] += 0.5 * factor, out[at - 1] -= 0.5 * factor;
  }
}

/// Shares of the knots in the value at a place, `factor` times: cubics that reproduce every parabola. Straight lines between knots
/// would put a smooth button's bend into the errors, whose size then no longer covers it.
void addShares(const std::vector<double>& knots_mm, double x_mm, double factor, double* out) {
  const std::size_t n = knots_mm.size();
  if (n == 1) {
    out[0] = factor;
    return;
  }
  const double place =
      std::clamp((x_mm - knots_mm.front()) / (knots_mm[1] - knots_mm[0]), 0.0, static_cast<double>(n - 1));
  const std::size_t i = std::min(static_cast<std::size_t>(place), n - 2);
  const double u = place - static_cast<double>(i), rest = 1 - u;
  out[i] += factor * rest * rest * (1 + 2 * u);
  out[i + 1] += factor * u * u * (3 - 2 * u);
  addSlope(n, i, factor * u * rest * rest, out);
  addSlope(n, i + 1, -factor * u * u * rest, out);
}

Eigen::MatrixXd designOf(const std::vector<Sample>& samples, const std::vector<double>& knots_mm,
                         const Columns& columns) {
  Eigen::MatrixXd design = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(samples.size()),
                                                 static_cast<Eigen::Index>(columns.count()));
  std::vector<double> row;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    row.assign(columns.count(), 0.0);
    row[0] = 1;
    addShares(knots_mm, s.x_mm, s.x_mm, row.data() + 1);
    if (columns.damping) addShares(knots_mm, s.x_mm, s.v_mm_per_s, row.data() + 1 + columns.knots);
    if (columns.mass) row.back() = s.a_mm_per_s2 / mmPerM;
    design.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(row.data(), static_cast<Eigen::Index>(row.size()));
  }
  return design;
}

/// The whole record as one residual block: its Jacobian is the design matrix.
class ForceResiduals : public ceres::CostFunction {
 public:
  ForceResiduals(const Eigen::MatrixXd& design, const Eigen::VectorXd& force_N)
      : design_(design), force_N_(force_N) {
    set_num_residuals(static_cast<int>(design.rows()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(design.cols()));
  }
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::Map<const Eigen::VectorXd> p(parameters[0], design_.cols());
    Eigen::Map<Eigen::VectorXd>(residuals, design_.rows()) = design_ * p - force_N_;
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          jacobians[0], design_.rows(), design_.cols()) = design_;
    }
    return true;
  }

 private:
  const Eigen::MatrixXd& design_;
  const Eigen::VectorXd& force_N_;
};

struct Fit {
  std::vector<Estimate> parameters;
  double residual_N = 0, condition = 1;
  bool usable = false;
};

Fit fitted(const std::vector<Sample>& samples, const std::vector<double>& knots_mm, const Columns& columns) {
  Eigen::MatrixXd design = designOf(samples, knots_mm, columns);
  Eigen::VectorXd force_N(static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) force_N[static_cast<Eigen::Index>(i)] = samples[i].force_N;
  // Columns of length 1: N, N/mm and N·s/mm differ by orders of magnitude.
  const Eigen::VectorXd lengths = design.colwise().norm().cwiseMax(1e-300);
  design.array().rowwise() /= lengths.transpose().array();
  Fit fit;
  const Eigen::VectorXd singular = design.bdcSvd().singularValues();
  fit.condition = singular[0] / std::max(singular[singular.size() - 1], 1e-300);
  std::vector<double> parameters(columns.count(), 0.0);
  ceres::Problem problem;
  problem.AddResidualBlock(new ForceResiduals(design, force_N), nullptr, parameters.data());
  ceres::Solver::Options options;
  options.logging_type = ceres::SILENT;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 50;
  options.function_tolerance = 1e-14;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) return fit;
  const double degrees = static_cast<double>(samples.size() - columns.count());
  fit.residual_N = std::sqrt(2 * summary.final_cost / degrees);
  ceres::Covariance::Options covarianceOptions;
  covarianceOptions.algorithm_type = ceres::DENSE_SVD;
  covarianceOptions.null_space_rank = -1;
  ceres::Covariance covariance(covarianceOptions);
  const std::vector<std::pair<const double*, const double*>> whole{{parameters.data(), parameters.data()}};
  if (!covariance.Compute(whole, &problem)) return fit;
  std::vector<double> block(columns.count() * columns.count());
  covariance.GetCovarianceBlock(parameters.data(), parameters.data(), block.data());
  for (std::size_t i = 0; i < columns.count(); ++i) {
    const double length = lengths[static_cast<Eigen::Index>(i)];
    fit.parameters.push_back(
        {parameters[i] / length, fit.residual_N * std::sqrt(block[i * columns.count() + i]) / length});
  }
  fit.usable = true;
  return fit;
}

/// Spread of the speed of what moves, as a share of its median; large where speed varies.
double speedSpread(const std::vector<Sample>& samples) {
  double fastest = 0;
  for (const Sample& s : samples) fastest = std::max(fastest, std::abs(s.v_mm_per_s));
  std::vector<double> speeds;
  for (const Sample& s : samples) {
    if (std::abs(s.v_mm_per_s) > movingShare * fastest) speeds.push_back(std::abs(s.v_mm_per_s));
  }
  if (speeds.size() < 10) return 0;
  std::sort(speeds.begin(), speeds.end());
  const auto at = [&](double share) {
    return speeds[static_cast<std::size_t>(share * static_cast<double>(speeds.size() - 1))];
  };
  return 0.5 * (at(0.9) - at(0.1)) / at(0.5);
}

double valueAt(const std::vector<double>& knots_mm, const std::vector<Estimate>& estimates, double x_mm) {
  std::vector<double> shares(knots_mm.size(), 0.0);
  addShares(knots_mm, x_mm, 1, shares.data());
  double value = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) value += shares[k] * estimates[k].value;
  return value;
}

Failure unusable(std::string problem, std::string remedy) {
  return {FailureCode::unreadableInput, "record", "", std::move(problem), std::move(remedy)};
}

}  // namespace

Result<Identification> identify(const ForceRecord& record, const IdentifySettings& settings) {
  if (settings.knots < 1 || settings.knots > mostKnots) {
    return Failure{FailureCode::wrongUsage, "--knots", "", "is " + std::to_string(settings.knots),
                   "Give 1 to 32"};
  }
  if (record.time_s.size() < fewestSamples + 4 * settings.knots) {
    return unusable("has " + std::to_string(record.time_s.size()) + " samples, too few for " +
                        std::to_string(settings.knots) + " knots",
                    "Record a whole press at 500 Hz or more");
  }
  const auto [low_mm, high_mm] =
      std::minmax_element(record.displacement_mm.begin(), record.displacement_mm.end());
  RecordMotion motion = motionOf(record, settings.lowestQuanta);
  if (!(*high_mm - *low_mm > leastMovement_quanta * motion.step_mm)) {
    return unusable("does not move: " + std::to_string(*high_mm - *low_mm) + " mm in all",
                    "Record a press over the whole travel");
  }
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < record.time_s.size(); ++i) {
    if (!motion.inside[i]) continue;
    samples.push_back({record.displacement_mm[i], motion.velocity_mm_per_s[i],
                       motion.acceleration_mm_per_s2[i], record.force_N[i]});
  }
  Identification found;
  for (std::size_t i = 0; i < settings.knots; ++i) {
    found.knots_mm.push_back(settings.knots == 1 ? 0.5 * (*low_mm + *high_mm)
                                                 : *low_mm + (*high_mm - *low_mm) * static_cast<double>(i) /
                                                                 static_cast<double>(settings.knots - 1));
  }
  Columns columns{settings.knots, true, true};
  const double spread = speedSpread(samples);
  if (spread < constantSpread) {
    found.doubt = DampingDoubt::constantSpeed;
    found.doubtFigure = spread;
    columns.damping = columns.mass = false;
  }
  Fit fit = fitted(samples, found.knots_mm, columns);
  if (columns.mass &&
      (!fit.usable || fit.parameters.back().value < standsOut * fit.parameters.back().sigma)) {
    columns.mass = false;
    fit = fitted(samples, found.knots_mm, columns);
  }
  if (!fit.usable)
    return unusable("gives no fit", "Record presses of different speeds over the whole travel");
  found.offset_N = fit.parameters[0];
  const auto knotsFrom = [&](std::size_t first) {
    return std::vector<Estimate>(
        fit.parameters.begin() + static_cast<std::ptrdiff_t>(first),
        fit.parameters.begin() + static_cast<std::ptrdiff_t>(first + settings.knots));
  };
  found.k_N_per_mm = knotsFrom(1);
  if (columns.damping) {
    const std::vector<Estimate> damping = knotsFrom(1 + settings.knots);
    double size = 0, error = 0;
    for (const Estimate& b : damping) size += std::abs(b.value), error += b.sigma;
    if (error > settings.largestSpread * size) {
      found.doubt = DampingDoubt::notCertain;
      found.doubtFigure = error / std::max(size, 1e-300);
    } else {
      found.b_Ns_per_mm = damping;
    }
  }
  if (columns.mass) found.mass_kg = fit.parameters.back();
  found.condition = fit.condition;
  found.residual_N = fit.residual_N;
  found.step_mm = motion.step_mm;
  found.samples = samples.size();
  found.velocity_mm_per_s = std::move(motion.velocity_mm_per_s);
  return found;
}

Result<Button> buttonFrom(const Identification& found, const std::string& name, double travel_mm) {
  constexpr int places = 64;
  std::vector<CurvePoint> points;
  for (int i = 0; i <= places; ++i) {
    const double x_mm = travel_mm * i / places;
    points.push_back({x_mm, found.offset_N.value + valueAt(found.knots_mm, found.k_N_per_mm, x_mm) * x_mm});
  }
  Result<StrokeCurve> press = StrokeCurve::throughPoints(points);
  if (!press) return press.failure();
  Result<ForceGraph> graph = ForceGraph::fromCurves(*press, *press);
  if (!graph) return graph.failure();
  ButtonState state{"", *std::move(graph), {}, {}, {}};
  for (int i = 0; i <= places && !found.b_Ns_per_mm.empty(); ++i) {
    const double x_mm = travel_mm * i / places;
    state.damping.push_back({x_mm, std::max(0.0, valueAt(found.knots_mm, found.b_Ns_per_mm, x_mm))});
    if (found.knots_mm.size() == 1) i = std::max(i, places - 1);  // a constant needs its ends only
  }
  return Button::fromStates(name, {std::move(state)});
}

}  // namespace detent::playback
