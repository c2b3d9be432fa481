// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/text_lines.h"

#include <algorithm>
#include <cmath>

#include "importer/frame/glyph_marks.h"

namespace detent::importer {

std::vector<Box> glyphsIn(const std::vector<Box>& glyphs, const Box& region, double maxSize_px) {
  std::vector<Box> inside;
  for (const auto& g : glyphs)
    if (region.contains(g) && std::max(g.width(), g.height()) <= maxSize_px) inside.push_back(g);
  return inside;
}

std::vector<TextLine> groupedLines(std::vector<Box> glyphs, double gapInHeights) {
  std::sort(glyphs.begin(), glyphs.end(), [](const Box& a, const Box& b) { return a.x0 < b.x0; });
  std::vector<TextLine> lines;
  for (const auto& g : glyphs) {
    const auto follows = [&](const TextLine& line) {
      const Box& l = line.box;
      const double overlap = std::min(l.y1, g.y1) - std::max(l.y0, g.y0);
      return (overlap >= 0.4 * std::min(l.height(), g.height()) || isComma(g, l) || isUnderscore(g, l)) &&
             g.x0 - l.x1 <= gapInHeights * std::max(l.height(), g.height()) &&
             g.height() <= 2.5 * l.height() + 3;
    };
    const auto line = std::find_if(lines.rbegin(), lines.rend(), follows);
    if (line == lines.rend()) {
      lines.push_back({g, {g}});
      continue;
    }
    line->box = line->box.joined(g);
    line->glyphs.push_back(g);
  }
  return lines;
}

std::vector<Box> textLines(const std::vector<Box>& glyphs, double gapInHeights) {
  auto lines = wordBoxes(glyphs, gapInHeights);
  std::erase_if(lines, [](const Box& b) { return b.height() < 4 || b.width() < 0.8 * b.height(); });
  return lines;
}

}  // namespace detent::importer
