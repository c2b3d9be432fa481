// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Letters of quantities in front of a unit: "a [g]", "F / N", "$s$ in mm".

#include <string_view>
#include <vector>

#include "importer/lexicon/lexicon.h"

namespace detent::importer {

/// Quantities that the letter at the start of a title stands for, with an index or an argument behind it:
/// "a_z [g]", "F(s) / N", "|a| (g)", "Δl in mm". Empty if the title does not begin with a letter that stands
/// alone before its unit. In recognised text the case of a letter says nothing, and a letter that may be a
/// misread one of the `wanted` quantity stands for nothing.
std::vector<std::string_view> quantitiesOfSymbol(std::string_view title, std::string_view wanted,
                                                 TextSource source);

}  // namespace detent::importer
