// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/axis_quantity.h"

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

}  // namespace detent::editor
