// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Position of a finger on the force graph.

#include "model/stroke_curve.h"

namespace detent::editor {

struct FingerPosition {
  double displacement_mm = 0;
  double force_N = 0;
  Stroke stroke = Stroke::press;
};

}  // namespace detent::editor
