// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table of limits as JSON: [{"standard", "edition", "clause", "kind", "figure", "least", "most", "tolerance"}, ...].

#include <string>
#include <vector>

#include "model/result.h"
#include "playback/performance/limits.h"

namespace detent::playback {

/// "key_force_N", "travel_mm": a figure as files and --json name it.
const char* keyOf(LimitedFigure figure);

Result<std::vector<Limit>> readLimits(const std::string& file);

}  // namespace detent::playback
