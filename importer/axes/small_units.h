// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reads the unit in the brackets of a title that is too small for the text engine, which reads "(rnre)" for
// "(mm)" or "(N)" for "(cN)".

#include <optional>
#include <string>

#include <opencv2/core/mat.hpp>

#include "importer/page/raster.h"

namespace detent::importer {

/// The unit in brackets at the end of a line, if the pixels resemble it more than any other unit that occurs
/// in plots: of force, of length, or of a quantity that shows that the chart is no force graph. `darkness`:
/// of the line's view; a high value is dark. `quarterTurns`: clockwise, until the line stands upright.
std::optional<std::string> bracketedUnit(const cv::Mat& darkness, const Box& line, int quarterTurns);

/// The line's text with this unit in its brackets, instead of what was read there.
std::string withUnit(const std::string& utf8, const std::string& unit);

}  // namespace detent::importer
