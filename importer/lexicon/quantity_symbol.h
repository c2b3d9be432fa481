// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Letters of quantities in front of a unit: "a [g]", "F / N", "$s$ in mm".

#include <optional>
#include <string>
#include <string_view>

#include "importer/lexicon/lexicon.h"

namespace detent::importer {

/// The letter that a title has in place of words.
struct QuantitySymbol {
  std::string letter;   ///< U of "U [N]", a of "|a_z|(t) / g"
  bool agrees = false;  ///< the letter is usual for the quantity of the unit behind it
};

/// The letter at a title's start, with an index or an argument, in front of nothing but a unit.
std::optional<QuantitySymbol> symbolBeforeUnit(std::string_view title, TextSource source);

}  // namespace detent::importer
