// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Transforms and straight path data of SVG attributes. Private to importer/page.

#include <optional>
#include <string_view>
#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

/// A `transform` attribute of matrix, translate and scale; nothing if it turns, skews or cannot be read.
std::optional<Affine> svgUprightTransform(std::string_view text);

/// A plain number in front of `text`; nothing if there is none.
std::optional<double> svgNumber(std::string_view text);

/// Path data of straight lines (M L H V Z in both cases); nothing if it has curves or cannot be read. Closed
/// subpaths end where they began.
std::optional<std::vector<std::vector<Point>>> svgStraightLines(std::string_view data);

}  // namespace detent::importer
