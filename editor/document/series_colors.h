// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How many things can be drawn over each other in colours that people tell apart.

#include <cstddef>

namespace detent::editor {

/// `seriesColor` (graph_colors.h) begins anew after so many.
inline constexpr std::size_t seriesColors = 6;

}  // namespace detent::editor
