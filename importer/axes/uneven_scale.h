// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scales that are not linear, named so that a refusal says what was seen.

#include <string>
#include <utility>
#include <vector>

#include "importer/axes/axis_labels.h"

namespace detent::importer {

/// What labels at these places (pixels along the axis, value) are a scale of: "values on a logarithmic
/// scale", "categories, not to scale". Empty where a linear scale fits, or where too few labels say.
std::string unevenScaleOf(std::vector<std::pair<double, double>> labels);

/// The same of an axis' labels that were read with certainty.
std::string unevenScaleIn(const AxisLabels& labels, Axis axis);

}  // namespace detent::importer
