// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Detects scales that are not linear, so that the refusal names the kind of scale.

#include <string>
#include <utility>
#include <vector>

#include "importer/axes/axis_labels.h"

namespace detent::importer {

/// The kind of scale of labels at these positions (pixels along the axis, value): logarithmicScale,
/// categoriesScale or brokenScale. Empty if a linear scale fits, or if there are too few labels.
std::string unevenScaleOf(std::vector<std::pair<double, double>> labels);

/// Returns true if gridlines or ticks stand as the logarithms of 1, 2, 3 to 10 do.
bool isLogarithmic(const std::vector<GridLine>& lines);

/// categoriesScale if labels that count unevenly stand at even distances, two or more of them aside from the
/// progression of the others; else empty. All but one must have been read with certainty.
std::string unevenRowIn(const AxisLabels& labels, Axis axis);

/// Returns true if numbers are printed at both ends (pixels along the axis, value) that confirm the values
/// there, while three or more labels make a scale of another step: it is uneven somewhere between them. If
/// the labels are misread, no number confirms the ends, or the steps differ by far more.
bool isUnevenBetween(const AxisLabels& labels, const std::pair<double, double>& first,
                     const std::pair<double, double>& last);

/// The kind of scale of an axis' labels that were read with certainty; a break is found among all of them.
std::string unevenScaleIn(const AxisLabels& labels, Axis axis);

}  // namespace detent::importer
