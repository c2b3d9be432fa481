// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Units among the tick labels: "20 gf", "0.5 mm", or "N" in place of the second-highest number.

#include <optional>

#include "importer/axes/axis_labels.h"
#include "model/units.h"

namespace detent::importer {

/// The unit that follows the numbers, if at least three labels have one and most of those agree: a single
/// letter behind a single number may mean anything.
std::optional<LengthUnit> lengthUnitBehindNumbers(GraphReading& r, const AxisLabels& labels);
std::optional<ForceUnit> forceUnitBehindNumbers(GraphReading& r, const AxisLabels& labels);

/// The unit that stands in place of the second-highest number, as German drawing standards prescribe: 10, 20,
/// N, 40.
std::optional<LengthUnit> lengthUnitInPlaceOfNumber(GraphReading& r, const AxisLabels& labels);
std::optional<ForceUnit> forceUnitInPlaceOfNumber(GraphReading& r, const AxisLabels& labels);

}  // namespace detent::importer
