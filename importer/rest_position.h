// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a stroke may begin: at the force-free key, 0 mm, or later.

#include "model/stroke_curve.h"

namespace detent::importer {

/// The curve with everything left of 0 mm pushed onto 0 mm: shapes are squeezed along displacement, forces
/// stay, so a rise that leans slightly to the left becomes vertical and keeps its height. Failure: nothing
/// right of 0 mm.
Result<StrokeCurve> startingAtRest(const StrokeCurve& curve);

}  // namespace detent::importer
