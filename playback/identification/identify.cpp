// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/identification/identify.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Dense>

#include "playback/identification/record_windows.h"

namespace detent::playback {

namespace {

constexpr std::size_t fewestSamples = 30, mostKnots = 32;
constexpr double leastMovement_quanta = 10;
// Speed counts as constant if 80 % of the moving samples lie within this share of the median.
constexpr double constantSpread = 0.15;
// share of the largest speed; slower samples say nothing about the speed
constexpr double movingShare = 0.1;
constexpr double standsOut = 3;        // standard errors from which a value is significant
constexpr double slidingShare = 0.02;  // share of the largest speed from which friction has its full value
constexpr double mmPerM = 1000;
// least share of the squared residual that counts as noise of the force, not as rounding of positions
constexpr double leastNoiseShare = 0.05;

/// Columns of the fit, in this order: c, k at the knots, b at the knots, f, m.
struct Columns {
  std::size_t knots = 1;
  bool damping = true, mass = true, friction = false;
  std::size_t frictionAt() const { return 1 + knots + (damping ? knots : 0); }
  std::size_t count() const { return frictionAt() + (friction ? 1 : 0) + (mass ? 1 : 0); }
};

/// Adds to `out`, times `factor`, the weights of the knots' values in the slope at a knot: that of the
/// parabola through three knots.
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

/// Adds, times `factor`, the weights of the knots in the value at a position. They are those of cubics that
/// reproduce every parabola: straight lines between knots would add a smooth button's curvature to the
/// errors, whose size would then be too small.
void addShares(const std::vector<double>& knots_mm, double x_mm, double factor, double* out) {
  const std::size_t n = knots_mm.size();
  if (n == 1) {
    out[0] += factor;
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

/// Sums of the weights over one interval between two knots, from its left knot to the share `u` of its width,
/// for values and slopes at both knots: the integrals of Hermite's four cubics.
struct CellIntegral {
  double left, right, leftSlope, rightSlope;
  explicit CellIntegral(double u)
      : left(u - u * u * u + 0.5 * u * u * u * u),
        right(u * u * u - 0.5 * u * u * u * u),
        leftSlope(u * u * (0.5 - u * (2.0 / 3 - 0.25 * u))),
        rightSlope(u * u * u * (0.25 * u - 1.0 / 3)) {}
};

/// Adds the integral of the weights from the first knot to a position. Its rate of change is b(x) v.
void addIntegrals(const std::vector<double>& knots_mm, double x_mm, double* out) {
  const std::size_t n = knots_mm.size();
  if (n == 1) {
    out[0] += x_mm;
    return;
  }
  const double width_mm = knots_mm[1] - knots_mm[0];
  const double place = std::clamp((x_mm - knots_mm.front()) / width_mm, 0.0, static_cast<double>(n - 1));
  for (std::size_t i = 0; i + 1 < n && static_cast<double>(i) < place; ++i) {
    const CellIntegral part(std::min(1.0, place - static_cast<double>(i)));
    out[i] += width_mm * part.left;
    out[i + 1] += width_mm * part.right;
    addSlope(n, i, width_mm * part.leftSlope, out);
    addSlope(n, i + 1, width_mm * part.rightSlope, out);
  }
}

/// A record as sample-by-sample columns for the fit.
struct Samples {
  std::vector<double> knots_mm;
  /// by sample and knot: factor of the knot's stiffness (N/mm) in the force (N)
  Eigen::MatrixXd spring_mm;
  /// by sample and knot: factor of the knot's damping in the momentum that the damping has taken so far. The
  /// force of the damping is the rate of change of that momentum.
  Eigen::MatrixXd way_mm;
  Eigen::VectorXd place_mm, force_N;
  /// -1 to 1; zero for slow samples, because static friction may then have any value up to its maximum
  Eigen::VectorXd direction;
};

Eigen::VectorXd directionsOf(const std::vector<double>& velocity_mm_per_s) {
  Eigen::VectorXd direction = Eigen::Map<const Eigen::VectorXd>(
      velocity_mm_per_s.data(), static_cast<Eigen::Index>(velocity_mm_per_s.size()));
  const double whole = slidingShare * direction.cwiseAbs().maxCoeff();
  if (whole > 0) direction = (direction / whole).cwiseMax(-1.0).cwiseMin(1.0);
  return direction;
}

Samples samplesOf(const ForceRecord& record, std::vector<double> knots_mm,
                  const std::vector<double>& velocity_mm_per_s) {
  const auto n = static_cast<Eigen::Index>(record.time_s.size()),
             knots = static_cast<Eigen::Index>(knots_mm.size());
  Samples s{std::move(knots_mm),
            Eigen::MatrixXd::Zero(n, knots),
            Eigen::MatrixXd::Zero(n, knots),
            Eigen::Map<const Eigen::VectorXd>(record.displacement_mm.data(), n),
            Eigen::Map<const Eigen::VectorXd>(record.force_N.data(), n),
            directionsOf(velocity_mm_per_s)};
  std::vector<double> row(s.knots_mm.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    std::fill(row.begin(), row.end(), 0.0);
    addShares(s.knots_mm, s.place_mm[i], s.place_mm[i], row.data());
    s.spring_mm.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), knots);
    std::fill(row.begin(), row.end(), 0.0);
    addIntegrals(s.knots_mm, s.place_mm[i], row.data());
    s.way_mm.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), knots);
  }
  return s;
}

/// The equations of the fit, one per window.
struct Equations {
  Eigen::MatrixXd design;
  Eigen::VectorXd force_N;
  std::vector<std::size_t> centre;  ///< middle sample of each window
};

Equations equationsOf(const Samples& s, const RecordWindows& windows, const Columns& columns) {
  Equations e;
  for (std::size_t i = 0; i < static_cast<std::size_t>(s.force_N.size()); ++i) {
    if (windows.inside(i)) e.centre.push_back(i);
  }
  const auto rows = static_cast<Eigen::Index>(e.centre.size()),
             knots = static_cast<Eigen::Index>(columns.knots);
  e.design = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(columns.count()));
  e.force_N = Eigen::VectorXd::Zero(rows);
  std::vector<SampleShare> shares;
  for (Eigen::Index r = 0; r < rows; ++r) {
    const std::size_t centre = e.centre[static_cast<std::size_t>(r)];
    windows.shares(centre, shares);
    e.design(r, 0) = 1;
    for (std::size_t j = 0; j < shares.size(); ++j) {
      const auto at = static_cast<Eigen::Index>(windows.first(centre) + j);
      e.force_N[r] += shares[j].mean * s.force_N[at];
      e.design.row(r).segment(1, knots) += shares[j].mean * s.spring_mm.row(at);
      if (columns.damping) e.design.row(r).segment(1 + knots, knots) += shares[j].perS * s.way_mm.row(at);
      if (columns.friction)
        e.design(r, static_cast<Eigen::Index>(columns.frictionAt())) += shares[j].mean * s.direction[at];
      if (columns.mass) e.design(r, e.design.cols() - 1) += shares[j].perS2 * s.place_mm[at] / mmPerM;
    }
  }
  return e;
}

/// Values of an error-free fit at every sample: change of force with displacement, and damping.
struct Local {
  Eigen::VectorXd slope_N_per_mm, damping_Ns_per_mm;
  double mass_kg = 0;
};

Local localOf(const Samples& s, const Columns& columns, const Eigen::VectorXd& parameters) {
  const Eigen::Index n = s.place_mm.size(), knots = static_cast<Eigen::Index>(columns.knots);
  Local local{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
              columns.mass ? parameters[parameters.size() - 1] : 0};
  const double nudge_mm = 1e-6 * (s.place_mm.maxCoeff() - s.place_mm.minCoeff());
  std::vector<double> row(columns.knots);
  const auto changeOf = [&](auto add, Eigen::Index i, const Eigen::VectorXd& values) {
    std::fill(row.begin(), row.end(), 0.0);
    add(s.place_mm[i] + nudge_mm, 1.0);
    add(s.place_mm[i] - nudge_mm, -1.0);
    return Eigen::Map<const Eigen::VectorXd>(row.data(), knots).dot(values) / (2 * nudge_mm);
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    local.slope_N_per_mm[i] =
        changeOf([&](double x_mm, double sign) { addShares(s.knots_mm, x_mm, sign * x_mm, row.data()); }, i,
                 parameters.segment(1, knots));
    if (!columns.damping) continue;
    std::fill(row.begin(), row.end(), 0.0);
    addShares(s.knots_mm, s.place_mm[i], 1, row.data());
    local.damping_Ns_per_mm[i] =
        Eigen::Map<const Eigen::VectorXd>(row.data(), knots).dot(parameters.segment(1 + knots, knots));
  }
  return local;
}

/// Weights of rests. The mean of a rest's equations is known no better than its rounding, so it counts less.
class StayWeights {
 public:
  StayWeights(const Equations& equations, const Stays& stays)
      : rows_(stays.levels), factor_(stays.levels, 1.0) {
    for (std::size_t r = 0; r < equations.centre.size(); ++r) {
      const std::size_t level = stays.level[equations.centre[r]];
      if (level != Stays::moving) rows_[level].push_back(static_cast<Eigen::Index>(r));
    }
  }
  void set(const Equations& equations, const Local& local, double rounding_mm, double noise_N) {
    for (std::size_t level = 0; level < rows_.size(); ++level) {
      if (rows_[level].empty()) continue;
      const std::size_t centre = equations.centre[static_cast<std::size_t>(rows_[level].front())];
      const double error_N = rounding_mm * local.slope_N_per_mm[static_cast<Eigen::Index>(centre)];
      factor_[level] =
          noise_N / std::sqrt(noise_N * noise_N +
                              static_cast<double>(rows_[level].size()) * error_N * error_N + 1e-300);
    }
  }
  /// Reduces the mean of each rest in every column to its weight. The operation is symmetric, so it also
  /// serves as its own transpose.
  void apply(Eigen::Ref<Eigen::MatrixXd> columns) const {
    for (std::size_t level = 0; level < rows_.size(); ++level) {
      if (factor_[level] == 1) continue;
      Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(columns.cols());
      for (const Eigen::Index r : rows_[level]) mean += columns.row(r);
      mean *= (1 - factor_[level]) / static_cast<double>(rows_[level].size());
      for (const Eigen::Index r : rows_[level]) columns.row(r) -= mean;
    }
  }

 private:
  std::vector<std::vector<Eigen::Index>> rows_;  ///< rows of each rest
  std::vector<double> factor_;                   ///< weight of each rest, 0..1
};

struct Solution {
  Eigen::VectorXd parameters;
  Eigen::MatrixXd inverse;  ///< inverse of the normal matrix
  double condition = 1;
};

/// Least squares of the weighted equations. None if they contain a value that is not finite.
std::optional<Solution> solved(Eigen::MatrixXd design, const Eigen::VectorXd& force_N) {
  if (!design.allFinite()) return {};
  // Columns are scaled to length 1, because N, N/mm and N·s/mm differ by orders of magnitude.
  const Eigen::VectorXd lengths = design.colwise().norm().cwiseMax(1e-300).transpose();
  design.array().rowwise() /= lengths.transpose().array();
  Solution solution;
  // The problem is linear, so one decomposition solves it. A combination of parameters that the record does
  // not determine gets no standard error.
  constexpr double saysNothing = 1e-7;  // share of the largest singular value
  auto svd = design.bdcSvd(Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(saysNothing);
  const Eigen::VectorXd& singular = svd.singularValues();
  solution.condition = singular[0] / std::max(singular[singular.size() - 1], 1e-300);
  const Eigen::MatrixXd spans = lengths.cwiseInverse().asDiagonal() * svd.matrixV().leftCols(svd.rank()) *
                                singular.head(svd.rank()).cwiseInverse().asDiagonal();
  solution.inverse = spans * spans.transpose();
  solution.parameters = svd.solve(force_N).cwiseQuotient(lengths);
  return solution;
}

/// Effect of a unit error in each sample's force and displacement on the normal equations (the transposed
/// windows).
struct Influence {
  Eigen::MatrixXd ofForce, ofPlace;  ///< samples x parameters
  double forceSquares = 0;  ///< sum of squares of the effects of each sample's force on each equation
  /// sum of squares of the effects of each moving sample's position on each equation
  double placeSquares = 0;
};

Influence influenceOf(const Samples& s, const RecordWindows& windows, const Equations& equations,
                      const Stays& stays, const Eigen::MatrixXd& weighted, const Local& local) {
  Influence influence{Eigen::MatrixXd::Zero(s.force_N.size(), weighted.cols()),
                      Eigen::MatrixXd::Zero(s.force_N.size(), weighted.cols())};
  std::vector<SampleShare> shares;
  for (std::size_t r = 0; r < equations.centre.size(); ++r) {
    const std::size_t centre = equations.centre[r];
    windows.shares(centre, shares);
    const auto row = weighted.row(static_cast<Eigen::Index>(r));
    for (std::size_t j = 0; j < shares.size(); ++j) {
      const auto at = static_cast<Eigen::Index>(windows.first(centre) + j);
      influence.ofForce.row(at) += shares[j].mean * row;
      const double byPlace = shares[j].mean * local.slope_N_per_mm[at] +
                             shares[j].perS * local.damping_Ns_per_mm[at] +
                             shares[j].perS2 * local.mass_kg / mmPerM;
      influence.ofPlace.row(at) += byPlace * row;
      influence.forceSquares += shares[j].mean * shares[j].mean;
      if (stays.level[windows.first(centre) + j] == Stays::moving)
        influence.placeSquares += byPlace * byPlace;
    }
  }
  return influence;
}

/// Covariance of independent rounding errors: the sum of (effect)(effect)ᵀ. The error of a rest is common to
/// all of its samples.
Eigen::MatrixXd spreadOfRounding(const Eigen::MatrixXd& ofPlace, const Stays& stays) {
  Eigen::MatrixXd ofStays = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(stays.levels), ofPlace.cols());
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(ofPlace.cols(), ofPlace.cols());
  for (Eigen::Index i = 0; i < ofPlace.rows(); ++i) {
    const std::size_t level = stays.level[static_cast<std::size_t>(i)];
    if (level == Stays::moving) {
      spread += ofPlace.row(i).transpose() * ofPlace.row(i);
    } else {
      ofStays.row(static_cast<Eigen::Index>(level)) += ofPlace.row(i);
    }
  }
  return spread + ofStays.transpose() * ofStays;
}

struct Fit {
  std::vector<Estimate> parameters;
  double residual_N = 0, condition = 1;
  bool usable = false;
};

/// Least squares over the windows, with rests weighted by their rounding. The standard errors are those of
/// force and rounding, propagated through windows, weights and solution
/// (docs/develop/decisions/1108-errors-of-identification.md).
Fit fitted(const Samples& samples, const RecordWindows& windows, const Stays& stays, const Columns& columns) {
  constexpr int passes = 3;  // the first pass has no weights yet; the last does not change them noticeably
  const Equations equations = equationsOf(samples, windows, columns);
  const double rounding_mm = windows.step_mm() / std::sqrt(12.0);
  StayWeights weights(equations, stays);
  Fit fit;
  Eigen::MatrixXd covariance;
  std::optional<Solution> solution;
  for (int pass = 0; pass < passes; ++pass) {
    Eigen::MatrixXd design = equations.design;
    Eigen::MatrixXd force_N = equations.force_N;
    weights.apply(design);
    weights.apply(force_N);
    solution = solved(design, force_N);
    if (!solution) return fit;
    const Local local = localOf(samples, columns, solution->parameters);
    weights.apply(design);
    const Influence influence = influenceOf(samples, windows, equations, stays, design, local);
    const Eigen::MatrixXd ofForce = influence.ofForce.transpose() * influence.ofForce;
    const double freedom = influence.forceSquares - (solution->inverse * ofForce).trace();
    const double squares = (equations.design * solution->parameters - equations.force_N).squaredNorm();
    // Rounding also causes residuals, which are not noise of the force. Without noise, little remains after
    // subtracting it.
    const double ofRounding = rounding_mm * rounding_mm * influence.placeSquares;
    fit.residual_N =
        std::sqrt(std::max(squares - ofRounding, leastNoiseShare * squares) / std::max(freedom, 1e-300));
    covariance = solution->inverse *
                 (fit.residual_N * fit.residual_N * ofForce +
                  rounding_mm * rounding_mm * spreadOfRounding(influence.ofPlace, stays)) *
                 solution->inverse;
    weights.set(equations, local, rounding_mm, fit.residual_N);
  }
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    fit.parameters.push_back({solution->parameters[i], std::sqrt(std::max(0.0, covariance(i, i)))});
  }
  fit.condition = solution->condition;
  fit.usable = true;
  return fit;
}

bool standsOutOf(const Estimate& e) { return e.value > standsOut * e.sigma; }

/// Fit with a mass, if it is significant; `columns` reports that.
Fit fittedWithMass(const Samples& samples, const RecordWindows& windows, const Stays& stays,
                   Columns& columns) {
  Fit fit = fitted(samples, windows, stays, columns);
  if (!columns.mass || (fit.usable && standsOutOf(fit.parameters.back()))) return fit;
  columns.mass = false;
  return fitted(samples, windows, stays, columns);
}

/// Spread of the speed of moving samples relative to its median; large if the speed varies.
double speedSpread(std::vector<double> speeds) {
  const double fastest = *std::max_element(speeds.begin(), speeds.end());
  std::erase_if(speeds, [&](double speed) { return !(speed > movingShare * fastest); });
  if (speeds.size() < 10) return 0;
  std::sort(speeds.begin(), speeds.end());
  const auto at = [&](double share) {
    return speeds[static_cast<std::size_t>(share * static_cast<double>(speeds.size() - 1))];
  };
  return 0.5 * (at(0.9) - at(0.1)) / at(0.5);
}

/// Velocity (mm/s) of every sample; 0 where no window fits inside the record.
std::vector<double> velocityOf(const ForceRecord& record, const RecordWindows& windows) {
  std::vector<double> velocity(record.time_s.size(), 0.0);
  std::vector<SampleShare> shares;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    if (!windows.inside(i)) continue;
    windows.shares(i, shares);
    for (std::size_t j = 0; j < shares.size(); ++j) {
      velocity[i] += shares[j].perS * record.displacement_mm[windows.first(i) + j];
    }
  }
  return velocity;
}

double valueAt(const std::vector<double>& knots_mm, const std::vector<Estimate>& estimates, double x_mm) {
  std::vector<double> shares(knots_mm.size(), 0.0);
  addShares(knots_mm, x_mm, 1, shares.data());
  double value = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) value += shares[k] * estimates[k].value;
  return value;
}

Failure unusable(Message problem, const std::string& remedy) {
  return {FailureCode::unreadableInput, "record", "", std::move(problem), remedy};
}

/// Failure that names the first sample with an impossible displacement or force.
std::optional<Failure> impossibleSampleOf(const ForceRecord& record) {
  for (std::size_t i = 0; i < record.time_s.size(); ++i) {
    const bool place = std::abs(record.displacement_mm[i]) <= ForceGraph::maxTravel_mm;
    if (place && std::abs(record.force_N[i]) <= ForceGraph::maxForce_N) continue;
    return Failure{FailureCode::unreadableInput, "record", Message("sample %1", i + 1),
                   place ? Message("the force is %1", newtons(record.force_N[i]))
                         : Message("the displacement is %1", millimetres(record.displacement_mm[i])),
                   "Record forces in N and displacements in mm"};
  }
  return {};
}

/// Scale of the forces as a power of two, so that forces of a nanonewton or of a tonne are fitted alike, and
/// scaling causes no rounding.
int scaleOf(const std::vector<double>& force_N) {
  double strongest_N = 0;
  for (const double force : force_N) strongest_N = std::max(strongest_N, std::abs(force));
  return strongest_N > 0 ? std::ilogb(strongest_N) : 0;
}

void scaleBack(Identification& found, int scale) {
  const auto scaled = [scale](Estimate& e) {
    e = {std::scalbn(e.value, scale), std::scalbn(e.sigma, scale)};
  };
  scaled(found.offset_N);
  std::ranges::for_each(found.k_N_per_mm, scaled);
  std::ranges::for_each(found.b_Ns_per_mm, scaled);
  if (found.friction_N) scaled(*found.friction_N);
  if (found.mass_kg) scaled(*found.mass_kg);
  found.residual_N = std::scalbn(found.residual_N, scale);
}

Result<Identification> identified(const ForceRecord& record, const IdentifySettings& settings) {
  if (settings.knots < 1 || settings.knots > mostKnots) {
    return Failure{FailureCode::wrongUsage, "--knots", "", "the value is " + std::to_string(settings.knots),
                   "Give 1 to 32"};
  }
  if (record.time_s.size() < fewestSamples + 4 * settings.knots) {
    return unusable("has " + std::to_string(record.time_s.size()) + " samples, too few for " +
                        std::to_string(settings.knots) + " knots",
                    "Record a whole press at 500 Hz or more");
  }
  const auto [low_mm, high_mm] =
      std::minmax_element(record.displacement_mm.begin(), record.displacement_mm.end());
  const RecordWindows windows(record, settings.lowestQuanta);
  if (!(*high_mm - *low_mm > leastMovement_quanta * windows.step_mm())) {
    return unusable(Message("the recording covers only %1 in steps of %2, which are too few steps",
                            millimetres(*high_mm - *low_mm), millimetres(windows.step_mm())),
                    "Record a press over the whole travel");
  }
  Identification found;
  for (std::size_t i = 0; i < settings.knots; ++i) {
    found.knots_mm.push_back(settings.knots == 1 ? 0.5 * (*low_mm + *high_mm)
                                                 : *low_mm + (*high_mm - *low_mm) * static_cast<double>(i) /
                                                                 static_cast<double>(settings.knots - 1));
  }
  Columns columns{settings.knots, true, true};
  found.velocity_mm_per_s = velocityOf(record, windows);
  std::vector<double> speeds;
  for (const double v : found.velocity_mm_per_s) speeds.push_back(std::abs(v));
  const double spread = speedSpread(std::move(speeds));
  if (spread < constantSpread) {
    found.doubt = DampingDoubt::constantSpeed;
    found.doubtFigure = spread;
    columns.damping = columns.mass = false;
  }
  const Samples samples = samplesOf(record, found.knots_mm, found.velocity_mm_per_s);
  const Stays stays = staysOf(record.displacement_mm);
  Fit fit = fittedWithMass(samples, windows, stays, columns);
  if (columns.damping) {
    Columns rubbing = columns;
    rubbing.friction = rubbing.mass = true;
    const Fit other = fittedWithMass(samples, windows, stays, rubbing);
    if (other.usable && standsOutOf(other.parameters[rubbing.frictionAt()])) {
      columns = rubbing;
      fit = other;
    }
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
  if (columns.friction) found.friction_N = fit.parameters[columns.frictionAt()];
  if (columns.mass) found.mass_kg = fit.parameters.back();
  found.condition = fit.condition;
  found.residual_N = fit.residual_N;
  found.step_mm = windows.step_mm();
  found.samples = record.time_s.size();
  return found;
}

}  // namespace

Result<Identification> identify(const ForceRecord& record, const IdentifySettings& settings) {
  if (auto impossible = impossibleSampleOf(record)) return *impossible;
  const int scale = scaleOf(record.force_N);
  ForceRecord scaled = record;
  for (double& force : scaled.force_N) force = std::scalbn(force, -scale);
  Result<Identification> found = identified(scaled, settings);
  if (found) scaleBack(*found, scale);
  return found;
}

Result<Button> buttonFrom(const Identification& found, const std::string& name, double travel_mm) {
  constexpr int positions = 64;
  std::vector<CurvePoint> points;
  for (int i = 0; i <= positions; ++i) {
    const double x_mm = travel_mm * i / positions;
    points.push_back({x_mm, found.offset_N.value + valueAt(found.knots_mm, found.k_N_per_mm, x_mm) * x_mm});
  }
  Result<StrokeCurve> press = StrokeCurve::throughPoints(points);
  if (!press) return press.failure();
  Result<ForceGraph> graph = ForceGraph::fromCurves(*press, *press);
  if (!graph) return graph.failure();
  ButtonState state{"", *std::move(graph), {}, {}, {}};
  for (int i = 0; i <= positions && !found.b_Ns_per_mm.empty(); ++i) {
    const double x_mm = travel_mm * i / positions;
    state.damping.push_back({x_mm, std::max(0.0, valueAt(found.knots_mm, found.b_Ns_per_mm, x_mm))});
    if (found.knots_mm.size() == 1) i = std::max(i, positions - 1);  // a constant needs only its two ends
  }
  return Button::fromStates(name, {std::move(state)});
}

}  // namespace detent::playback
