// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Text around a frame: glyphs, words and lines found in the dark pixels, before anything is read.

#include <vector>

#include "importer/frame/plot_frame.h"

namespace detent::importer {

/// The members of `glyphs` that lie in `region` (view pixels) and are no larger than `maxSize_px`.
std::vector<Box> glyphsIn(const std::vector<Box>& glyphs, const Box& region, double maxSize_px);

/// A line of text and its letters.
struct TextLine {
  Box box;
  std::vector<Box> glyphs;
};

/// Glyphs side by side, up to `gapInHeights` of their height apart, joined to lines. Single marks are kept.
std::vector<TextLine> groupedLines(std::vector<Box> glyphs, double gapInHeights);

/// Lines of text: words up to `gapInHeights` of their height apart, joined. Dust and single marks are left
/// out.
std::vector<Box> textLines(const std::vector<Box>& glyphs, double gapInHeights);

}  // namespace detent::importer
