#include "importer/axes/text_lines.h"

#include <algorithm>
#include <cmath>

#include "importer/frame/glyph_marks.h"

namespace detent::importer {

std::vector<Box> glyphsIn(const std::vector<Box>& glyphs, const Box& region, double maxSize_px) {
  std::vector<Box> inside;
  for (const auto& g : glyphs)
    if (g.x0 >= region.x0 && g.x1 <= region.x1 && g.y0 >= region.y0 && g.y1 <= region.y1 &&
        std::max(g.width(), g.height()) <= maxSize_px)
      inside.push_back(g);
  return inside;
}

std::vector<Box> textLines(const std::vector<Box>& glyphs, double gapInHeights) {
  auto lines = wordBoxes(glyphs, gapInHeights);
  std::erase_if(lines, [](const Box& b) { return b.height() < 4 || b.width() < 0.8 * b.height(); });
  return lines;
}

}  // namespace detent::importer
