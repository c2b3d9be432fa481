// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/graph_reading.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "importer/axes/small_units.h"
#include "importer/axes/text_lines.h"
#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"

namespace detent::importer {
namespace {

constexpr double smallPrint_px =
    9;  // height of a line, brackets and all; the engine reads larger ones as well

std::vector<double> positions(const std::vector<GridLine>& lines) {
  std::vector<double> out;
  for (const auto& line : lines) out.push_back(line.position_px);
  return out;
}

bool ofUse(const SeenText& t) {
  const auto letters = std::count_if(t.utf8.begin(), t.utf8.end(),
                                     [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
  return t.confidence >= 0.5 && letters >= 2;
}

}  // namespace

GraphReading::GraphReading(const PageView& v, const PlotFrame& f)
    : view(v), frame(f), box(f.box()), darkness(darknessOf(v.raster, f.paper)), reader(v) {
  const cv::Mat ink = inkOf(darkness);
  glyphs = glyphBoxes(withoutFrameInk(ink, box, positions(frame.xLines), positions(frame.yLines)), 1,
                      largestGlyph_px());
}

double GraphReading::largestGlyph_px() const { return 0.16 * std::min(box.width(), box.height()) + 10; }

std::vector<SeenText> GraphReading::readLines(const Box& region, double angle_deg, Point towards,
                                              std::size_t atMost) {
  const int turns = angle_deg == 90 ? 1 : angle_deg == -90 ? 3 : 0;
  auto inside = glyphsIn(glyphs, region, largestGlyph_px());
  for (auto& g : inside) g = turned(g, turns);
  auto lines = textLines(inside, 1.3);
  for (auto& line : lines) line = turned(line, 4 - turns);
  std::sort(lines.begin(), lines.end(), [&](const Box& a, const Box& b) {
    return distance(a.middle(), towards) < distance(b.middle(), towards);
  });
  if (lines.size() > atMost) lines.resize(atMost);
  std::vector<SeenText> read;
  for (const auto& line : lines) {
    auto seen = reader.readLine(line, TextKind::words, angle_deg);
    if (seen.utf8.empty()) continue;
    if (std::min(line.width(), line.height()) <= smallPrint_px)
      if (const auto unit = bracketedUnit(darkness, line, turns)) seen.utf8 = withUnit(seen.utf8, *unit);
    if (ofUse(seen)) texts.push_back(seen);
    read.push_back(std::move(seen));
  }
  return read;
}

void GraphReading::setAside(const std::vector<Box>& words) {
  std::erase_if(glyphs, [&](const Box& glyph) {
    return std::any_of(words.begin(), words.end(), [&](const Box& word) { return word.contains(glyph); });
  });
}

std::vector<SeenText> GraphReading::ownTexts(const Box& region) const {
  std::vector<SeenText> out;
  for (const auto& t : view.texts)
    if (region.contains(t.box.middle())) out.push_back({t.utf8, t.box, 1.0, t.angle_deg});
  return out;
}

}  // namespace detent::importer
