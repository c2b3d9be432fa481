// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The unit in the brackets of a title too small for the text engine, which makes "(rnre)" of "(mm)" and "(N)"
// of "(cN)".

#include <optional>
#include <string>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// The unit in brackets at the end of a line of print, if it is more similar to one than to any other that
/// plots are drawn in: of force, of length, or of a quantity that makes a chart no force graph. `darkness`:
/// of the line's view, dark is high. `quarterTurns`: clockwise, until the line stands upright.
std::optional<std::string> bracketedUnit(const cv::Mat& darkness, const Box& line, int quarterTurns);

/// The line's text with this unit in its brackets, in place of what was read there.
std::string withUnit(const std::string& utf8, const std::string& unit);

}  // namespace detent::importer
