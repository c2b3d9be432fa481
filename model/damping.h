// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button's damping b(x) as a polyline.

#include <vector>

#include "model/button.h"

namespace detent {

/// Returns b(x) in N·s/mm: linear between points, constant beyond the outermost ones, 0 without points. Any
/// thread.
double dampingAt(const std::vector<DampingPoint>& points, double displacement_mm);

}  // namespace detent
