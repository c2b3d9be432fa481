// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Units that stand behind the numbers of an axis themselves: "20 gf", "0.5 mm".

#include <optional>

#include "importer/axes/axis_labels.h"
#include "model/units.h"

namespace detent::importer {

/// The unit read behind the numbers of an axis, where three of them at least and most of those that have one agree on it: a
/// single letter behind a single number may be anything's.
std::optional<LengthUnit> lengthUnitBehindNumbers(GraphReading& r, const AxisLabels& labels);
std::optional<ForceUnit> forceUnitBehindNumbers(GraphReading& r, const AxisLabels& labels);

}  // namespace detent::importer
