// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/axis_calibration.h"

#include <cmath>

#include "model/check.h"

namespace detent::importer {
namespace {

Point applied(const std::array<double, 9>& h, Point p) {
  const double w = h[6] * p.x + h[7] * p.y + h[8];
  return {(h[0] * p.x + h[1] * p.y + h[2]) / w, (h[3] * p.x + h[4] * p.y + h[5]) / w};
}

std::array<double, 9> inverseOf(const std::array<double, 9>& h) {
  const std::array<double, 9> adjugate{
      h[4] * h[8] - h[5] * h[7], h[2] * h[7] - h[1] * h[8], h[1] * h[5] - h[2] * h[4],
      h[5] * h[6] - h[3] * h[8], h[0] * h[8] - h[2] * h[6], h[2] * h[3] - h[0] * h[5],
      h[3] * h[7] - h[4] * h[6], h[1] * h[6] - h[0] * h[7], h[0] * h[4] - h[1] * h[3]};
  const double det = h[0] * adjugate[0] + h[1] * adjugate[3] + h[2] * adjugate[6];
  DETENT_CHECK(det != 0 && std::isfinite(det), "a calibration is invertible");
  auto inverse = adjugate;
  for (auto& v : inverse) v /= det;
  return inverse;
}

/// Length of the step in the units' plane per view pixel, about the point that stands at (mm, N).
Point unitsPerPx(const AxisCalibration& c) {
  const auto middle = [](const AxisReading& a) { return 0.5 * (a.min + a.max); };
  const double mm = middle(c.x) * millimetresPer(lengthUnitFrom(c.x.unit).value_or(LengthUnit::millimetre));
  const double newton = middle(c.y) * newtonsPer(forceUnitFrom(c.y.unit).value_or(ForceUnit::newton));
  const Point at = c.toView({mm, newton});
  const Point right = c.toUnits({at.x + 1, at.y}), down = c.toUnits({at.x, at.y + 1});
  return {std::hypot(right.x - mm, down.x - mm), std::hypot(right.y - newton, down.y - newton)};
}

}  // namespace

Point AxisCalibration::toUnits(Point view_px) const { return applied(viewToUnits, view_px); }
Point AxisCalibration::toView(Point mm_N) const { return applied(inverseOf(viewToUnits), mm_N); }
double AxisCalibration::mmPerPx() const { return unitsPerPx(*this).x; }
double AxisCalibration::newtonPerPx() const { return unitsPerPx(*this).y; }

}  // namespace detent::importer
