// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A switch's name in letters that the text engine does not read: the person says it, it is drawn and looked
// for on the page. docs/develop/decisions/0701-several-switches.md

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "importer/strokes/switches.h"

namespace detent::importer {

/// Index of the switch beside whose legend key the requested name is written. Empty if the name is all of
/// ASCII, if nothing on the picture resembles it, if two positions do equally, if a curve runs through the
/// position, and if no one switch's colour is beside it.
std::optional<std::size_t> switchSpotted(const std::vector<PlotSwitch>& switches,
                                         const std::vector<CurveTrace>& traces, const Raster& picture,
                                         const std::string& requested);

}  // namespace detent::importer
