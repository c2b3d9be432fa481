// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Origin of a page (drawn, scanned, photographed), as its pixels show it. Confidences were calibrated for
// each class (docs/measurements/import-confidence.md).

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

/// The class by the pixels alone, so never `vector`; `picture` if the picture is too small to decide.
PageClass classOfPixels(const Raster& raster);

}  // namespace detent::importer
