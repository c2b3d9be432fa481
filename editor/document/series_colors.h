// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Number of colours that people can tell apart.

#include <cstddef>

namespace detent::editor {

/// `seriesColor` (graph_colors.h) repeats after this many.
inline constexpr std::size_t seriesColors = 6;

}  // namespace detent::editor
