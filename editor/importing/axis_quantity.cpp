// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/axis_quantity.h"

#include <cmath>

namespace detent::editor {

AxisQuantity axisQuantity(GraphAxis axis, const std::string& printedUnit) {
  AxisQuantity typed;
  if (axis == GraphAxis::x) {
    const auto unit = lengthUnitFrom(printedUnit);
    if (unit) typed = {Quantity::length, {*unit, {}}};
  } else {
    const auto unit = forceUnitFrom(printedUnit);
    if (unit) typed = {Quantity::force, {{}, *unit}};
  }
  return typed;
}

QString endText(double end, double span) {
  constexpr double share = 1e-3;
  constexpr int digits = 5;
  const double step = std::pow(10, std::floor(std::log10(share * std::abs(span))));
  return numberText(std::isnormal(step) ? std::round(end / step) * step : end, digits);
}

}  // namespace detent::editor
