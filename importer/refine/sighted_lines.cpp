// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/refine/sighted_lines.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>

#include "importer/frame/darkness.h"
#include "importer/frame/line_profile.h"

namespace detent::importer {
namespace {

constexpr int positions = 48;          // places examined along a line
constexpr double leastSeen = 1.0 / 3;  // share of the examined places at which a line must be seen
constexpr double apart_px = 3;         // closer lines count as one
constexpr double leastContrast = 7;    // grey levels of a mean profile, as for the lines of a frame
constexpr int halfWidest_px = 9;       // thicker lines are bars

/// One axis of a plot, presented so that both axes are treated alike: across = across the line, along = along
/// it.
struct AxisView {
  bool ofForce;
  const cv::Mat& darkness;  // transposed for the force axis, so that the lines are vertical
  const AxisCalibration& calibration;

  const AxisReading& reading() const { return ofForce ? calibration.y : calibration.x; }
  const AxisReading& other() const { return ofForce ? calibration.x : calibration.y; }
  double unitOf(const AxisReading& axis, bool force) const {
    return force ? newtonsPer(forceUnitFrom(axis.unit).value_or(ForceUnit::newton))
                 : millimetresPer(lengthUnitFrom(axis.unit).value_or(LengthUnit::millimetre));
  }
  double unit() const { return unitOf(reading(), ofForce); }
  /// View pixels of a value of this axis at a share of the other one's range.
  Point at(double value, double share) const {
    const AxisReading& o = other();
    const double across = unitOf(o, !ofForce) * (o.min + share * (o.max - o.min));
    return calibration.toView(ofForce ? Point{across, value} : Point{value, across});
  }
  double valueAt(Point view_px) const {
    const Point units = calibration.toUnits(view_px);
    return ofForce ? units.y : units.x;
  }
};

double acrossOf(Point p, bool ofForce) { return ofForce ? p.y : p.x; }
double alongOf(Point p, bool ofForce) { return ofForce ? p.x : p.y; }

/// Centroid of the ridge around a crest, above the line between its ends; empty if there is none or it is too
/// thick.
std::optional<double> centreOf(const std::vector<double>& profile, int crest) {
  const auto at = [&](int i) { return profile[static_cast<std::size_t>(i)]; };
  const int n = static_cast<int>(profile.size());
  const auto baseline = [&](int step) {
    int i = crest;
    while (i + step >= 0 && i + step < n && std::abs(i + step - crest) <= halfWidest_px &&
           at(i + step) < at(i))
      i += step;
    return i;
  };
  const int left = baseline(-1), right = baseline(1);
  if (at(crest) - std::max(at(left), at(right)) < leastContrast || right - left >= 2 * halfWidest_px)
    return {};
  double mass = 0, moment = 0;
  for (int i = left; i <= right; ++i) {
    const double background = at(left) + (at(right) - at(left)) * (i - left) / std::max(1, right - left);
    const double above = std::max(0.0, at(i) - background);
    mass += above, moment += above * i;
  }
  return moment / mass;
}

/// The ridge nearest to a place, within `reach_px` across.
std::optional<double> ridgeNear(const cv::Mat& d, double across, double along, double reach_px,
                                double half_px) {
  const int x0 = std::max(0, static_cast<int>(std::floor(across - reach_px)) - 4);
  const int x1 = std::min(d.cols, static_cast<int>(std::ceil(across + reach_px)) + 5);
  const int y0 = std::max(0, static_cast<int>(std::lround(along - half_px)));
  const int y1 = std::min(d.rows, static_cast<int>(std::lround(along + half_px)) + 1);
  if (x1 - x0 < 5 || y1 <= y0) return {};
  const std::vector<double> profile = meanColumns(d, x0, x1, y0, y1);
  std::optional<double> best;
  for (int k = 1; k + 1 < x1 - x0; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (profile[i] < profile[i - 1] || profile[i] <= profile[i + 1]) continue;
    const auto centre = centreOf(profile, k);
    if (!centre || std::abs(x0 + *centre - across) > reach_px) continue;
    if (!best || std::abs(x0 + *centre - across) < std::abs(*best - across)) best = x0 + *centre;
  }
  return best;
}

/// Measures one line; each place is searched near the offset from the calibration that the last places had.
SightedLine sightLine(const AxisView& axis, double about, double reach_px) {
  SightedLine line{axis.ofForce, about, {}, {}};
  const Point from = axis.at(about, 0), to = axis.at(about, 1);
  const double half_px =
      std::abs(alongOf(to, axis.ofForce) - alongOf(from, axis.ofForce)) / (2.0 * positions) - 0.5;
  if (!(half_px >= 0.5)) return line;
  for (int k = 0; k < positions; ++k) {
    const Point expected = axis.at(about, (k + 0.5) / positions);
    const double across = acrossOf(expected, axis.ofForce), along = alongOf(expected, axis.ofForce);
    const auto seen = ridgeNear(axis.darkness, across, along, reach_px, std::max(0.5, half_px));
    if (!seen) continue;
    line.points_px.push_back(axis.ofForce ? Point{along, *seen} : Point{*seen, along});
  }
  return line;
}

/// Values of labels in mm or N with the pixel of their tick along the axis; of the frame's ends if no label
/// counts.
struct Known {
  double position_px, value;
};
std::vector<Known> knownOf(const AxisView& axis) {
  std::vector<Known> known;
  for (const TickLabel& tick : axis.reading().ticks)
    if (tick.used) known.push_back({tick.position_px, tick.value * axis.unit()});
  if (known.size() >= 2) return known;
  known.clear();
  for (const double end : {axis.reading().min, axis.reading().max})
    known.push_back({acrossOf(axis.at(end * axis.unit(), 0), axis.ofForce), end * axis.unit()});
  return known;
}

void sightAxis(const AxisView& axis, const std::vector<GridLine>& drawn, std::vector<SightedLine>& lines) {
  const double span_px = std::abs(acrossOf(axis.at(axis.reading().max * axis.unit(), 0), axis.ofForce) -
                                  acrossOf(axis.at(axis.reading().min * axis.unit(), 0), axis.ofForce));
  const double reach_px = std::clamp(0.006 * span_px, 3.0, 10.0);
  const std::vector<Known> known = knownOf(axis);
  std::vector<double> taken_px;
  const auto add = [&](double position_px, bool spans) {
    const bool near = std::any_of(taken_px.begin(), taken_px.end(),
                                  [&](double t) { return std::abs(t - position_px) < apart_px; });
    if (near) return;
    const double along = alongOf(axis.at(axis.reading().min * axis.unit(), 0), axis.ofForce);
    const Point baseline = axis.ofForce ? Point{along, position_px} : Point{position_px, along};
    SightedLine line{axis.ofForce, axis.valueAt(baseline), {}, {}};
    if (spans) line = sightLine(axis, line.about, reach_px);
    for (const Known& k : known)
      if (std::abs(k.position_px - position_px) < 2) line.value = k.value;
    const bool seen = static_cast<double>(line.points_px.size()) >= leastSeen * positions;
    if (!seen) line.points_px = line.value ? std::vector<Point>{baseline} : std::vector<Point>{};
    if (line.points_px.empty()) return;
    taken_px.push_back(position_px);
    lines.push_back(std::move(line));
  };
  for (const GridLine& line : drawn)
    if (line.spansFrame) add(line.position_px, true);
  for (const double end : {axis.reading().min, axis.reading().max})
    add(acrossOf(axis.at(end * axis.unit(), 0), axis.ofForce), true);
  for (const Known& k : known) add(k.position_px, false);
}

}  // namespace

std::vector<SightedLine> sightLines(const PageView& view, const PlotFrame& frame,
                                    const AxisCalibration& calibration) {
  const cv::Mat darkness = darknessOf(view.raster, frame.paper);
  const cv::Mat turned = darkness.t();
  std::vector<SightedLine> lines;
  sightAxis({false, darkness, calibration}, frame.xLines, lines);
  sightAxis({true, turned, calibration}, frame.yLines, lines);
  return lines;
}

}  // namespace detent::importer
