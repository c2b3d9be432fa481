// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Units among the tick labels: "20 gf", "0.5 mm", or "N" instead of the last number but one.

#include <optional>

#include "importer/axes/axis_labels.h"
#include "model/units.h"

namespace detent::importer {

/// The unit read behind the tick labels, if at least three of them and most of those that have one agree on
/// it: a single letter behind a single number may mean anything.
std::optional<LengthUnit> lengthUnitBehindNumbers(GraphReading& r, const AxisLabels& labels);
std::optional<ForceUnit> forceUnitBehindNumbers(GraphReading& r, const AxisLabels& labels);

/// The unit that stands instead of the last number but one, as drawings by German standards have it: 10, 20,
/// N, 40.
std::optional<LengthUnit> lengthUnitInPlaceOfNumber(GraphReading& r, const AxisLabels& labels);
std::optional<ForceUnit> forceUnitInPlaceOfNumber(GraphReading& r, const AxisLabels& labels);

}  // namespace detent::importer
