// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads a number typed at a page's axis: in the unit printed there, or with one of its own.

#include <string>

#include "editor/importing/corrections.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {

/// Arguments for readQuantity(); QuantityReading::shown is then in the printed unit.
struct AxisQuantity {
  Quantity quantity = Quantity::number;
  DisplayUnits units;  ///< the axis' own unit is the printed one
};

/// `printedUnit` as AxisReading::unit; numbers of an unknown unit have no unit.
AxisQuantity axisQuantity(GraphAxis axis, const std::string& printedUnit);

/// An end of an axis that spans `span`, as it was read: to a thousandth of the axis, no finer than the page's
/// resolution.
QString endText(double end, double span);

}  // namespace detent::editor
