// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/axis_calibration.h"

#include <cmath>

namespace detent::importer {
namespace {

/// Change of (mm, N) per view pixel near the point at these coordinates.
Point unitsPerPx(const AxisCalibration& c) {
  const auto middle = [](const AxisReading& a) { return 0.5 * (a.min + a.max); };
  const double mm = middle(c.x) * millimetresPer(lengthUnitFrom(c.x.unit).value_or(LengthUnit::millimetre));
  const double newton = middle(c.y) * newtonsPer(forceUnitFrom(c.y.unit).value_or(ForceUnit::newton));
  const Point at = c.toView({mm, newton});
  const Point right = c.toUnits({at.x + 1, at.y}), down = c.toUnits({at.x, at.y + 1});
  return {std::hypot(right.x - mm, down.x - mm), std::hypot(right.y - newton, down.y - newton)};
}

/// A number with three significant digits, and its unit.
MessageValue shownIn(const std::string& unit, double value) {
  const double last = value == 0 ? 1 : std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2);
  return Message::of("%1 %2", {std::round(value / last) * last, unit});
}

}  // namespace

Point SheetBend::straightened(Point view_px) const {
  const Point n = (1 / half_px) * (view_px - middle_px);
  const double away = depth[0] * n.x * n.x + depth[1] * n.x * n.y + depth[2] * n.y * n.y;
  return view_px + (half_px * away) * (from + n);
}

Point SheetBend::bent(Point straight_px) const {
  // fixed-point iterations; each multiplies the error by about bend / size of the sheet
  constexpr int steps = 30;
  Point at = straight_px;
  for (int k = 0; k < steps; ++k) at = straight_px - (straightened(at) - at);
  return at;
}

Point AxisCalibration::toUnits(Point view_px) const {
  return viewToUnits(bend ? bend->straightened(view_px) : view_px);
}

Point AxisCalibration::toView(Point mm_N) const {
  const Point straight_px = viewToUnits.inverse()(mm_N);
  return bend ? bend->bent(straight_px) : straight_px;
}
double AxisCalibration::mmPerPx() const { return unitsPerPx(*this).x; }
double AxisCalibration::newtonPerPx() const { return unitsPerPx(*this).y; }

MessageValue shownTravel(const AxisReading& x, double travel_mm) {
  return shownIn(x.unit, travel_mm / millimetresPer(lengthUnitFrom(x.unit).value_or(LengthUnit::millimetre)));
}

MessageValue shownForce(const AxisReading& y, double force_N) {
  return shownIn(y.unit, force_N / newtonsPer(forceUnitFrom(y.unit).value_or(ForceUnit::newton)));
}

bool areExchanged(const AxisCalibration& axes) {
  return forceUnitFrom(axes.x.otherQuantity) && lengthUnitFrom(axes.y.otherQuantity);
}

Doubt otherQuantityOn(const char* axis, const std::string& quantity, RemedyKind unit) {
  // No unit makes such a scale even.
  const auto evenAxes = Message("Import a graph of the same button with evenly divided axes");
  if (quantity == logarithmicScale)
    return {DoubtCode::otherQuantity, {axis, Message("it is logarithmic")}, evenAxes};
  if (quantity == categoriesScale)
    return {DoubtCode::otherQuantity, {axis, Message("it has categories instead of a scale")}, evenAxes};
  if (quantity == brokenScale)
    return {DoubtCode::otherQuantity,
            {axis, Message("it has a break, after which the numbers stand at another spacing")},
            evenAxes};
  const bool isTravel = unit == RemedyKind::giveXUnit;
  return {DoubtCode::otherQuantity,
          {axis, Message("it measures \"%1\"", quantity)},
          {{unit, isTravel ? "if it is a travel all the same" : "if it is a force all the same"}}};
}

std::vector<Doubt> otherQuantitiesOf(const AxisCalibration& axes) {
  if (areExchanged(axes)) return {{DoubtCode::axesExchanged, {}, {}}};
  std::vector<Doubt> doubts;
  if (!axes.x.otherQuantity.empty())
    doubts.push_back(otherQuantityOn("x", axes.x.otherQuantity, RemedyKind::giveXUnit));
  if (!axes.y.otherQuantity.empty())
    doubts.push_back(otherQuantityOn("y", axes.y.otherQuantity, RemedyKind::giveYUnit));
  return doubts;
}

}  // namespace detent::importer
