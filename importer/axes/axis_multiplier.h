// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A power of ten at the end of an axis, by which all its numbers are to be multiplied: "1e-1", "×10³".

#include <optional>
#include <string_view>

#include "importer/axes/axis_labels.h"

namespace detent::importer {

/// The power of ten if the text consists of nothing else. The digit one may have been read as "l". Exponents
/// from -9 to 9.
std::optional<double> multiplierIn(std::string_view text);

/// The multiplier above the upper end of a force axis, or below the right end of a displacement axis; 1 if
/// there is none.
double multiplierAtEnd(GraphReading& r, Axis axis, const Box& labels);

}  // namespace detent::importer
