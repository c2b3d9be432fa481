// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button's damping b(x) as a polyline.

#include <vector>

#include "model/button.h"

namespace detent {

/// N·s/mm, straight between points, the nearest end outside them, 0 without any. Any thread.
double dampingAt(const std::vector<DampingPoint>& points, double displacement_mm);

}  // namespace detent
