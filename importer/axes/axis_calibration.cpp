// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/axis_calibration.h"

#include <cmath>

namespace detent::importer {
namespace {

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

Point AxisCalibration::toUnits(Point view_px) const { return viewToUnits(view_px); }
Point AxisCalibration::toView(Point mm_N) const { return viewToUnits.inverse()(mm_N); }
double AxisCalibration::mmPerPx() const { return unitsPerPx(*this).x; }
double AxisCalibration::newtonPerPx() const { return unitsPerPx(*this).y; }

}  // namespace detent::importer
