// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds a switch by its name if the text engine cannot read the name's letters: the user gives the name,
// which is drawn and searched for on the page. docs/develop/decisions/0701-several-switches.md

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "importer/strokes/switches.h"

namespace detent::importer {

/// Index of the switch whose legend key has the requested name beside it. Empty if the name is all ASCII, if
/// nothing on the picture resembles it, if two positions resemble it equally, if a curve runs through the
/// position, or if the colour beside it is not that of exactly one switch.
std::optional<std::size_t> switchSpotted(const std::vector<PlotSwitch>& switches,
                                         const std::vector<CurveTrace>& traces, const Raster& picture,
                                         const std::string& requested);

}  // namespace detent::importer
