// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Draws words in the fonts that the program carries, to compare them with writing that the text engine cannot
// read.

#include <optional>
#include <string>

#include "importer/page/raster.h"

namespace detent::importer {

/// Black on white, letters as high as `height_px` allows; height in [8, 256], text at most 64 bytes. Empty
/// where the build draws no text (without MuPDF) or has no letter for one of it.
std::optional<Raster> wordsDrawn(const std::string& utf8, int height_px);

}  // namespace detent::importer
