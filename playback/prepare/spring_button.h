// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The paper's button from its equation: F = k(x) x + b(x) v with polynomials k and b (Shrestha, "Basic
// Model").

#include <string>
#include <vector>

#include "model/button.h"
#include "model/result.h"

namespace detent::playback {

/// Coefficients of x^0, x^1, ... with x in mm.
struct SpringPolynomials {
  std::vector<double> stiffness_N_per_mm;  ///< 1 to 12
  std::vector<double> damping_Ns_per_mm;   ///< 0 to 12; none: undamped
  double travel_mm = 4;                    ///< > 0
};

/// Button whose strokes both have the spring's force. Failure wrongUsage: too many or no coefficients, a
/// damping below 0 somewhere, a force that is no curve.
Result<Button> springButton(const std::string& name, const SpringPolynomials& spring);

}  // namespace detent::playback
