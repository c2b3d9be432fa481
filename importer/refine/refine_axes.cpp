// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/refine/refine_axes.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <ceres/autodiff_cost_function.h>
#include <ceres/crs_matrix.h>
#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <Eigen/Dense>

namespace detent::importer {
namespace {

constexpr int mapUnknowns = 8, bendUnknowns = 5;
// places farther from their line count linearly, because a curve or a letter stands there
constexpr double far_px = 1;
// weight of a residual that keeps the bend's centre near 0, so that it is determined even if nothing is bent
constexpr double weakly = 0.02;
constexpr int placesPerLine =
    4;  // number of independent values in one line's places: position, tilt, bend, and one for the rest

/// Position of a place on the sheet, in scaled mm and N. `n`: the place in scaled view pixels; `map`, `bend`:
/// the sheet's unknowns, in the form that Ceres passes.
template <typename T>
void onSheet(const T* map, const T* bend, Point n, T* units) {
  const T away = bend[0] * (n.x * n.x) + bend[1] * (n.x * n.y) + bend[2] * (n.y * n.y);
  const T x = n.x + away * (bend[3] + n.x), y = n.y + away * (bend[4] + n.y);
  const T w = map[6] * x + map[7] * y + 1.0;
  units[0] = (map[0] * x + map[1] * y + map[2]) / w;
  units[1] = (map[3] * x + map[4] * y + map[5]) / w;
}

/// Residual: distance of a place from its line, view pixels.
struct OffItsLine {
  Point n;
  int axis;
  double unitsPerPx;

  template <typename T>
  bool operator()(const T* map, const T* bend, const T* value, T* residual) const {
    T units[2];
    onSheet(map, bend, n, units);
    residual[0] = (units[axis] - value[0]) / unitsPerPx;
    return true;
  }
};

struct WeaklyHeld {
  template <typename T>
  bool operator()(const T* bend, T* residual) const {
    residual[0] = weakly * bend[3];
    residual[1] = weakly * bend[4];
    return true;
  }
};

SheetUnknowns unknownsOf(const AxisCalibration& calibration, const PlotFrame& frame) {
  SheetUnknowns u;
  const Box box = frame.box();
  u.middle_px = {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
  u.half_px = 0.5 * std::max(box.width(), box.height());
  const Point a = calibration.toUnits({box.x0, box.y1}), b = calibration.toUnits({box.x1, box.y0});
  u.middle_mm_N = 0.5 * (a + b);
  u.half_mm_N = 0.5 * (b - a);
  const Homography fromScaled{{u.half_px, 0, u.middle_px.x, 0, u.half_px, u.middle_px.y, 0, 0, 1}};
  const Homography toScaled{{1 / u.half_mm_N.x, 0, -u.middle_mm_N.x / u.half_mm_N.x, 0, 1 / u.half_mm_N.y,
                             -u.middle_mm_N.y / u.half_mm_N.y, 0, 0, 1}};
  const Homography map = toScaled.after(calibration.viewToUnits.after(fromScaled));
  for (std::size_t k = 0; k < mapUnknowns; ++k) u.at[k] = map.m[k] / map.m[8];
  return u;
}

AxisCalibration calibrationOf(const SheetUnknowns& u, const AxisCalibration& asRead, SheetShape shape) {
  AxisCalibration calibration = asRead;
  if (shape == SheetShape::asRead) return calibration;
  Homography map;
  std::copy_n(u.at.begin(), mapUnknowns, map.m.begin());
  const Homography toScaled{
      {1 / u.half_px, 0, -u.middle_px.x / u.half_px, 0, 1 / u.half_px, -u.middle_px.y / u.half_px, 0, 0, 1}};
  const Homography fromScaled{
      {u.half_mm_N.x, 0, u.middle_mm_N.x, 0, u.half_mm_N.y, u.middle_mm_N.y, 0, 0, 1}};
  calibration.viewToUnits = fromScaled.after(map.after(toScaled));
  if (shape == SheetShape::bent)
    calibration.bend = SheetBend{u.middle_px, u.half_px, {u.at[8], u.at[9], u.at[10]}, {u.at[11], u.at[12]}};
  return calibration;
}

/// One least-squares problem over the lines of a plot.
class SheetProblem {
 public:
  SheetProblem(const std::vector<SightedLine>& lines, const AxisCalibration& calibration,
               const SheetUnknowns& start)
      : unknowns_(start), values_(lines.size()) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const SightedLine& line = lines[i];
      const double middle = line.ofForce ? start.middle_mm_N.y : start.middle_mm_N.x;
      const double half = line.ofForce ? start.half_mm_N.y : start.half_mm_N.x;
      values_[i] = (line.value.value_or(line.about) - middle) / half;
      for (const Point& p : line.points_px) addPlace(line, p, calibration, half, i);
      if (line.value) problem_.SetParameterBlockConstant(&values_[i]);
    }
    problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<WeaklyHeld, 2, bendUnknowns>(new WeaklyHeld),
                              nullptr, bend());
  }

  /// For lines that cannot distinguish a twist from a tilt: fixes the bend's mixed term (xy).
  void holdTwist() {
    problem_.SetManifold(bend(), new ceres::SubsetManifold(bendUnknowns, {1}));
    freeOfBend_ = {8, 10, 11, 12};
  }

  /// Least cost with the unknowns that the shape leaves free, starting from the last solution.
  double solve(SheetShape shape) {
    hold(map(), shape == SheetShape::asRead);
    hold(bend(), shape != SheetShape::bent);
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 60;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    cost_ = summary.IsSolutionUsable() ? summary.final_cost : HUGE_VAL;
    return cost_;
  }

  int places_() const { return static_cast<int>(lineOf_.size()); }
  double rms_px(double cost) const { return std::sqrt(2 * cost / std::max(1, places_())); }
  const SheetUnknowns& unknowns() const { return unknowns_; }
  void setUnknowns(const SheetUnknowns& unknowns) { unknowns_.at = unknowns.at; }

  /// Covariance of the unknowns that the last solve left free. All places of one line share errors.
  SheetCovariance covariance(int lines);

 private:
  double* map() { return unknowns_.at.data(); }
  double* bend() { return unknowns_.at.data() + mapUnknowns; }

  void hold(double* block, bool held) {
    if (held)
      problem_.SetParameterBlockConstant(block);
    else
      problem_.SetParameterBlockVariable(block);
  }

  void addPlace(const SightedLine& line, Point p, const AxisCalibration& calibration, double half,
                std::size_t index) {
    const Point step = line.ofForce ? Point{0, 1} : Point{1, 0};
    const Point units = calibration.toUnits(p + step) - calibration.toUnits(p);
    const double perPx = (line.ofForce ? units.y : units.x) / half;
    const Point n = (1 / unknowns_.half_px) * (p - unknowns_.middle_px);
    auto* cost = new ceres::AutoDiffCostFunction<OffItsLine, 1, mapUnknowns, bendUnknowns, 1>(
        new OffItsLine{n, line.ofForce ? 1 : 0, perPx});
    problem_.AddResidualBlock(cost, new ceres::HuberLoss(far_px), map(), bend(), &values_[index]);
    lineOf_.push_back(static_cast<int>(index));
  }

  SheetUnknowns unknowns_;
  std::vector<double> values_;
  std::vector<int> lineOf_;                        // line of each place
  std::vector<int> freeOfBend_{8, 9, 10, 11, 12};  // indices in SheetUnknowns::at
  ceres::Problem problem_;
  double cost_ = 0;
};

/// Number of neighbouring residuals along a line that share one error: the integrated autocorrelation, summed
/// until it vanishes.
double placesPerError(const std::vector<double>& residuals, const std::vector<int>& lineOf) {
  double variance = 0;
  for (const double r : residuals) variance += r * r;
  if (!(variance > 0)) return 1;
  double sum = 1;
  for (std::size_t lag = 1; lag < residuals.size(); ++lag) {
    double product = 0;
    for (std::size_t i = 0; i + lag < residuals.size(); ++i)
      if (lineOf[i] == lineOf[i + lag]) product += residuals[i] * residuals[i + lag];
    if (product <= 0.05 * variance) break;
    sum += 2 * product / variance;
  }
  return sum;
}

SheetCovariance SheetProblem::covariance(int lines) {
  SheetCovariance covariance{};
  ceres::Problem::EvaluateOptions options;
  std::vector<double*> blocks;
  std::vector<int> at;  // indices in SheetUnknowns::at of the first columns, those of map and bend
  if (!problem_.IsParameterBlockConstant(map())) {
    blocks.push_back(map());
    for (int k = 0; k < mapUnknowns; ++k) at.push_back(k);
  }
  if (!problem_.IsParameterBlockConstant(bend())) {
    blocks.push_back(bend());
    at.insert(at.end(), freeOfBend_.begin(), freeOfBend_.end());
  }
  for (double& value : values_)
    if (problem_.HasParameterBlock(&value) && !problem_.IsParameterBlockConstant(&value))
      blocks.push_back(&value);
  options.parameter_blocks = blocks;
  std::vector<double> residuals;
  ceres::CRSMatrix jacobian;
  problem_.Evaluate(options, nullptr, &residuals, nullptr, &jacobian);
  Eigen::MatrixXd j = Eigen::MatrixXd::Zero(jacobian.num_rows, jacobian.num_cols);
  for (int row = 0; row < jacobian.num_rows; ++row)
    for (int k = jacobian.rows[static_cast<std::size_t>(row)];
         k < jacobian.rows[static_cast<std::size_t>(row) + 1]; ++k)
      j(row, jacobian.cols[static_cast<std::size_t>(k)]) = jacobian.values[static_cast<std::size_t>(k)];
  const double perError =
      std::max(placesPerError({residuals.begin(), residuals.begin() + places_()}, lineOf_),
               double(places_()) / (placesPerLine * std::max(1, lines)));
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  const double independent = std::max(places_() / perError, 1.0);
  const double variance =
      sum / places_() * perError * independent / std::max(1.0, independent - static_cast<double>(j.cols()));
  const Eigen::MatrixXd all =
      variance * (j.transpose() * j).completeOrthogonalDecomposition().pseudoInverse();
  for (std::size_t r = 0; r < at.size(); ++r)
    for (std::size_t c = 0; c < at.size(); ++c)
      covariance[static_cast<std::size_t>(at[r])][static_cast<std::size_t>(at[c])] =
          all(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
  return covariance;
}

/// Counts of the lines of one axis.
struct LineMap {
  int lengthwise = 0;  ///< lines seen along their length
  int known = 0;       ///< lines of known value
  bool enough() const { return lengthwise >= 2 && known >= 2; }
  /// with only two lines a twist is indistinguishable from a tilt
  bool twist() const { return lengthwise >= 3; }
};

LineMap mapBy(const std::vector<SightedLine>& lines, bool ofForce) {
  LineMap lineMap;
  for (const SightedLine& line : lines) {
    if (line.ofForce != ofForce) continue;
    lineMap.lengthwise += line.points_px.size() > 1;
    lineMap.known += line.value.has_value();
  }
  return lineMap;
}

/// Returns true if the lower cost justifies the additional unknowns (Schwarz 1978), counting independent
/// samples.
bool worthIt(double before, double after, int unknowns, int lines) {
  const double independent = placesPerLine * lines;
  return independent * std::log(before / std::max(after, 1e-12)) > unknowns * std::log(independent);
}

}  // namespace

Point SheetUnknowns::toUnits(Point view_px) const {
  double units[2];
  onSheet(at.data(), at.data() + mapUnknowns, (1 / half_px) * (view_px - middle_px), units);
  return {middle_mm_N.x + half_mm_N.x * units[0], middle_mm_N.y + half_mm_N.y * units[1]};
}

PointNoise RefinedAxes::sigmaAt(Point mm_N) const {
  constexpr double step = 1e-5;  // step of an unknown, which is about 1
  const Point view_px = calibration.toView(mm_N);
  std::array<Point, SheetUnknowns::count> slope;
  for (std::size_t k = 0; k < slope.size(); ++k) {
    SheetUnknowns up = unknowns, down = unknowns;
    up.at[k] += step, down.at[k] -= step;
    slope[k] = (0.5 / step) * (up.toUnits(view_px) - down.toUnits(view_px));
  }
  double mm2 = 0, N2 = 0;
  for (std::size_t r = 0; r < slope.size(); ++r)
    for (std::size_t c = 0; c < slope.size(); ++c) {
      mm2 += slope[r].x * covariance[r][c] * slope[c].x;
      N2 += slope[r].y * covariance[r][c] * slope[c].y;
    }
  return {std::sqrt(std::max(0.0, mm2)), std::sqrt(std::max(0.0, N2))};
}

std::optional<RefinedAxes> refineAxes(const PageView& view, const PlotFrame& frame,
                                      const AxisCalibration& calibration, const Progress& progress) {
  if (view.raster.empty()) return {};
  const std::vector<SightedLine> lines = sightLines(view, frame, calibration);
  const LineMap byWay = mapBy(lines, false), byForce = mapBy(lines, true);
  if (progress.isCancelled() || !byWay.enough() || !byForce.enough()) return {};
  SheetProblem problem(lines, calibration, unknownsOf(calibration, frame));
  RefinedAxes refined;
  refined.calibration = calibration;
  refined.lines = static_cast<int>(lines.size());
  refined.places_ = problem.places_();
  const double asRead = problem.solve(SheetShape::asRead);
  const SheetUnknowns unknownsAsRead = problem.unknowns();
  const double tilted = problem.solve(SheetShape::tilted);
  const SheetUnknowns unknownsTilted = problem.unknowns();
  if (!byWay.twist() || !byForce.twist()) problem.holdTwist();
  const double bent = problem.solve(SheetShape::bent);
  if (worthIt(std::min(asRead, tilted), bent, bendUnknowns, refined.lines))
    refined.shape = SheetShape::bent;
  else if (worthIt(asRead, tilted, mapUnknowns, refined.lines))
    refined.shape = SheetShape::tilted;
  if (refined.shape != SheetShape::bent) {
    problem.setUnknowns(refined.shape == SheetShape::tilted ? unknownsTilted : unknownsAsRead);
    problem.solve(
        // computed also if the axes are kept: their error is that of a sheet that may be tilted
        SheetShape::tilted);
    if (refined.shape == SheetShape::asRead) problem.setUnknowns(unknownsAsRead);
  }
  const double least = refined.shape == SheetShape::bent     ? bent
                       : refined.shape == SheetShape::tilted ? tilted
                                                             : asRead;
  refined.before_px = problem.rms_px(asRead);
  refined.after_px = problem.rms_px(least);
  refined.unknowns = problem.unknowns();
  refined.covariance = problem.covariance(refined.lines);
  refined.calibration = calibrationOf(refined.unknowns, calibration, refined.shape);
  return refined;
}

}  // namespace detent::importer
