// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a page came to be, as far as it shows: what a confidence is worth was counted for each kind apart
// (docs/measurements/import-confidence.md).

#include <string_view>

#include "importer/page/raster.h"

namespace detent::importer {

enum class PageClass {
  vector,   ///< the curves are the document's own paths
  picture,  ///< drawn by a program: even paper without grain
  scan,     ///< from paper: grain, paper that is not quite even, or black and white alone
  photo     ///< by a camera: light that falls off across the paper
};

/// "vector", "picture", "scan", "photo".
std::string_view nameOf(PageClass pageClass);

/// What the pixels say, so never `vector`; a picture too small to tell is a `picture`.
PageClass classOfPixels(const Raster& raster);

}  // namespace detent::importer
