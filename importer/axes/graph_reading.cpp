// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/graph_reading.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "importer/axes/small_units.h"
#include "importer/axes/text_lines.h"
#include "importer/axes/unit_token.h"
#include "importer/frame/darkness.h"
#include "importer/frame/glyph_marks.h"
#include "importer/lexicon/printed_factor.h"
#include "importer/lexicon/printed_unit.h"

namespace detent::importer {
namespace {

// Heights of a line including brackets: the engine also reads larger ones; print below the smallest height
// cannot be read.
constexpr double smallPrint_px = 9, smallestPrint_px = 5;

std::vector<double> positions(const std::vector<GridLine>& lines) {
  std::vector<double> out;
  for (const auto& line : lines) out.push_back(line.position_px);
  return out;
}

/// Returns true if a text consists of words only. A text with a long dash is left out: it may be a legend
/// row, with keys between its entries.
bool ofUse(const SeenText& t) {
  if (t.utf8.find("\xE2\x80\x94") != std::string::npos) return false;
  const auto letters = std::count_if(t.utf8.begin(), t.utf8.end(),
                                     [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
  return t.confidence >= 0.5 && letters >= 2;
}

int quarterTurnsOf(double angle_deg) { return angle_deg == 90 ? 1 : angle_deg == -90 ? 3 : 0; }

/// The blobs of a region, rotated so that lines at this angle read along +x.
std::vector<Box> turnedLetters(const GraphReading& r, const std::vector<Box>& glyphs, const Box& region,
                               double angle_deg) {
  auto letters = glyphsIn(glyphs, region, r.largestGlyph_px());
  for (auto& letter : letters) letter = turned(letter, quarterTurnsOf(angle_deg));
  return letters;
}

/// Returns true if two lines are closer than lines of text ever are: parts of the same letters.
bool areParts(const Box& a, const Box& b) {
  constexpr double closest = 0.13;  // share of the height of both together
  const double along = std::min(a.x1, b.x1) - std::max(a.x0, b.x0);
  const double gap = std::max(a.y0, b.y0) - std::min(a.y1, b.y1);
  return along >= 0.5 * std::min(a.width(), b.width()) &&
         gap <= std::max(1.5, closest * a.joined(b).height());
}

/// Parts of letters joined to lines; empty if there are none.
std::vector<Box> joinedParts(std::vector<Box> lines) {
  const std::size_t before = lines.size();
  for (std::size_t i = 0; i < lines.size();) {
    const auto other = std::find_if(lines.begin() + static_cast<std::ptrdiff_t>(i) + 1, lines.end(),
                                    [&](const Box& line) { return areParts(lines[i], line); });
    if (other == lines.end()) {
      ++i;
      continue;
    }
    lines[i] = lines[i].joined(*other);
    lines.erase(other);
    i = 0;
  }
  if (lines.size() == before) return {};
  // Lines whose parts were joined separately are now beside each other, so they are joined too.
  return textLines(lines, 1.3);
}

/// Returns true if a line may have an unread unit: it is long enough to be a title and has none, or so short
/// that one letter may be lost.
bool mayHideUnit(const Box& line, const std::string& text) {
  if (line.width() < 2 * line.height() || !otherQuantityIn(text).empty()) return false;
  const auto force = forceUnitIn(text);
  if (force) return force->unit == ForceUnit::newton || force->unit == ForceUnit::gramForce;
  return !lengthUnitIn(text);
}

/// The bracketed unit of a line in which the engine saw a bracket but could not read the letters, if nothing
/// else in it names a unit.
std::optional<std::string> unreadUnit(const cv::Mat& darkness, const Box& place, double height_px,
                                      int quarterTurns, const std::string& text) {
  constexpr double largest_px = 16;  // the engine reads larger print correctly
  if (height_px > largest_px || forceUnitIn(text) || printedFactorIn(text) ||
      text.find_first_of("()[]") == std::string::npos)
    return {};
  return bracketedUnit(darkness, place, quarterTurns);
}

}  // namespace

GraphReading::GraphReading(const PageView& v, const PlotFrame& f)
    : view(v), frame(f), box(f.box()), darkness(darknessOf(v.raster, f.paper)), reader(v) {
  darkMask = darkMaskOf(darkness);
  glyphs = glyphBoxes(withoutFrameMarks(darkMask, box, positions(frame.xLines), positions(frame.yLines)), 1,
                      largestGlyph_px());
}

double GraphReading::largestGlyph_px() const { return 0.16 * std::min(box.width(), box.height()) + 10; }

std::vector<SeenText> GraphReading::readLines(const Box& region, double angle_deg, Point towards,
                                              std::size_t atMost) {
  const auto letters = turnedLetters(*this, glyphs, region, angle_deg);
  return read(textLines(letters, 1.3), letters, angle_deg, towards, atMost);
}

std::vector<SeenText> GraphReading::readLinesInside(const Box& region, double angle_deg, Point towards,
                                                    std::size_t atMost) {
  // Curves, gridlines and the axes are larger than letters.
  const auto letters = turnedLetters(*this, glyphBoxes(darkMask, 2, largestGlyph_px()), region, angle_deg);
  return read(textLines(letters, 1.3), letters, angle_deg, towards, atMost);
}

std::vector<SeenText> GraphReading::readLinesOfParts(const Box& region, double angle_deg, Point towards,
                                                     std::size_t atMost) {
  const auto letters = turnedLetters(*this, glyphs, region, angle_deg);
  const auto joined = joinedParts(wordBoxes(letters, 1.3));
  return joined.empty() ? std::vector<SeenText>{} : read(joined, letters, angle_deg, towards, atMost);
}

std::vector<SeenText> GraphReading::read(std::vector<Box> lines, const std::vector<Box>& letters,
                                         double angle_deg, Point towards, std::size_t atMost) {
  const int turns = quarterTurnsOf(angle_deg);
  const auto away = [&](const Box& line) { return distance(turned(line, 4 - turns).middle(), towards); };
  std::sort(lines.begin(), lines.end(), [&](const Box& a, const Box& b) { return away(a) < away(b); });
  if (lines.size() > atMost) lines.resize(atMost);
  const auto all = wordBoxes(letters, 1.3);
  std::vector<SeenText> found;
  for (const auto& line : lines) {
    const bool part = std::any_of(all.begin(), all.end(), [&](const Box& other) {
      return !line.contains(other) && areParts(line, other);
    });
    const Box place = turned(line, 4 - turns);
    auto seen = reader.readLine(place, TextKind::words, angle_deg);
    const bool small = line.height() <= smallPrint_px && line.height() >= smallestPrint_px;
    const auto drawn =
        small && !part && !seen.utf8.empty() ? bracketedUnit(darkness, place, turns) : std::nullopt;
    if (drawn) {
      seen.utf8 = withUnit(seen.utf8, *drawn);
    } else if (angle_deg >= 0 && mayHideUnit(line, seen.utf8)) {
      const auto unit = unitAtEnd(reader, glyphsIn(letters, line, largestGlyph_px()), turns, angle_deg);
      if (unit)
        seen.utf8 = unit->endOf(seen.utf8);
      else if (const auto alike =
                   part ? std::nullopt : unreadUnit(darkness, place, line.height(), turns, seen.utf8))
        seen.utf8 = withUnit(seen.utf8, *alike);
    }
    if (seen.utf8.empty()) continue;
    if (ofUse(seen)) texts.push_back(seen);
    found.push_back(std::move(seen));
  }
  return found;
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
