// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stroke may begin at 0 mm, where the key is free of force, or later, but never before.

#include "model/stroke_curve.h"

namespace detent::importer {

/// The curve with everything left of 0 mm moved to 0 mm: that part is compressed along displacement and keeps
/// its forces, so a rise that leans slightly to the left becomes vertical with the same height. Failure:
/// nothing lies right of 0 mm.
Result<StrokeCurve> startingAtRest(const StrokeCurve& curve);

}  // namespace detent::importer
