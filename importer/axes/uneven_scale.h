// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scales that are not linear, named so that a refusal says what was seen.

#include <string>
#include <utility>
#include <vector>

#include "importer/axes/axis_labels.h"

namespace detent::importer {

/// The kind of scale of labels at these positions (pixels along the axis, value): "values on a logarithmic
/// scale", "categories, not to scale". Empty if a linear scale fits, or if there are too few labels.
std::string unevenScaleOf(std::vector<std::pair<double, double>> labels);

inline constexpr char logarithmicScale[] = "values on a logarithmic scale";

/// Returns true if gridlines or ticks stand as the logarithms of 1, 2, 3 to 10 do.
bool isLogarithmic(const std::vector<GridLine>& lines);

/// The same of an axis' labels that were read with certainty.
std::string unevenScaleIn(const AxisLabels& labels, Axis axis);

}  // namespace detent::importer
