// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/axis_titles.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include "importer/axes/text_source.h"
#include "importer/lexicon/printed_factor.h"

namespace detent::importer {
namespace {

template <class Unit, class Parse>
void consider(AxisTitle<Unit>& best, const std::vector<SeenText>& lines, Parse parse) {
  constexpr double sureLetter = 0.85;  // below this confidence a single letter may be part of another mark
  for (const auto& line : lines) {
    if (line.utf8.size() < 2 && line.confidence < sureLetter) continue;
    const auto factor = printedFactorIn(line.utf8);
    const auto unit = parse(factor ? factor->title : line.utf8, sourceOf(line));
    const bool isBetter = unit && (!best.unit || unit->sure > best.unit->sure);
    if (isBetter) best.unit = unit;
    if (!isBetter && !best.text.empty()) continue;
    best.text = line.utf8;
    best.factor = factor ? factor->factor.value_or(1) : 1;
    best.factorUnread = factor && !factor->factor;
  }
}

/// From this certainty on, a unit stands in a place reserved for units: in brackets or after a slash.
constexpr double surePlace = 0.9;

std::ptrdiff_t letterCountOfLine(const SeenText& line) {
  return std::count_if(line.utf8.begin(), line.utf8.end(), [](char c) {
    return static_cast<unsigned char>(c) >= 0x80 || std::isalpha(static_cast<unsigned char>(c)) != 0;
  });
}

bool hasLetters(const SeenText& line) { return letterCountOfLine(line) >= 2; }

bool hasBracket(const SeenText& line) { return line.utf8.find_first_of("([") != std::string::npos; }

/// Removes level lines that are part of a longer upward line: the z of "[oz]", turned, reads as N. A line
/// that is much higher than wide runs upwards, whatever was read in it.
std::vector<SeenText> withoutPartsOf(const std::vector<SeenText>& others, std::vector<SeenText> lines) {
  constexpr double upright = 2;  // times as high as wide
  std::erase_if(lines, [&](const SeenText& line) {
    return std::ranges::any_of(others, [&](const SeenText& other) {
      return other.box.contains(line.box.middle()) && (letterCountOfLine(other) > letterCountOfLine(line) ||
                                                       (other.box.height() > upright * other.box.width() &&
                                                        other.box.height() > upright * line.box.height()));
    });
  });
  return lines;
}

/// The line with letters that is nearest to the axis; null without any.
const SeenText* nearestLine(const std::vector<SeenText>& lines, Point towards) {
  const SeenText* nearest = nullptr;
  const auto away = [&](const SeenText& t) {
    return std::hypot(std::clamp(towards.x, t.box.x0, t.box.x1) - towards.x,
                      std::clamp(towards.y, t.box.y0, t.box.y1) - towards.y);
  };
  for (const SeenText& line : lines)
    if (hasLetters(line) && (nearest == nullptr || away(line) < away(*nearest))) nearest = &line;
  return nearest;
}

/// Takes over the quantity of the line nearest to the axis if that is neither displacement nor force; returns
/// true then. If no line names a unit of this axis, no other text beside it does.
template <class Unit>
bool isContradicted(AxisTitle<Unit>& best, const std::vector<SeenText>& lines, Point towards) {
  const SeenText* const nearest = best.unit ? nullptr : nearestLine(lines, towards);
  if (nearest == nullptr) return false;
  best.other = otherQuantityIn(nearest->utf8, sourceOf(*nearest));
  return !best.other.empty();
}

/// Quantity named in the line nearest to the axis, if it is not the one that the axis must measure. `alien`:
/// the unit of the other axis, in its brackets.
template <class Alien>
std::string otherQuantity(const std::vector<SeenText>& lines, Point towards, Alien alien) {
  const SeenText* const nearest = nearestLine(lines, towards);
  if (nearest == nullptr) return {};
  if (auto other = otherQuantityIn(nearest->utf8, sourceOf(*nearest)); !other.empty()) return other;
  const auto unit = alien(nearest->utf8, sourceOf(*nearest));
  return unit && unit->sure >= surePlace ? std::string(symbolOf(unit->unit)) : std::string();
}

/// Reads the other axis' unit from a line, but not from the line that gave this axis its own unit: "mn" may
/// be either.
template <class Unit, class Parse>
auto besides(const AxisTitle<Unit>& best, Parse parse) {
  return [&best, parse](const std::string& line, TextSource source) {
    return best.unit && line == best.text ? decltype(parse(line, source)){} : parse(line, source);
  };
}

/// Reads titles in small print once more at other sizes, the nearest first, until one names a unit.
template <class Unit, class Parse>
void considerAgain(AxisTitle<Unit>& best, GraphReading& r, const std::vector<SeenText>& lines, Parse parse) {
  constexpr std::size_t nearest = 2;
  for (std::size_t i = 0; i < std::min(nearest, lines.size()) && !best.unit; ++i)
    if (hasLetters(lines[i]) || hasBracket(lines[i]))
      consider(best, r.reader.readLineOtherwise(lines[i].box, lines[i].angle_deg), parse);
}

/// Title from lines inside the plot, if they name a unit with certainty. A title at the end of an axis may
/// stand inside the frame; callouts ("4.2 mm") are not titles.
template <class Unit, class Parse>
void considerInside(AxisTitle<Unit>& best, const std::vector<SeenText>& lines, Parse parse) {
  AxisTitle<Unit> inside;
  consider(inside, lines, parse);
  if (inside.unit && inside.unit->sure >= surePlace) best = std::move(inside);
}

/// The lines that contain a bracket. Most other writing beside a plot is no title.
std::vector<SeenText> withBracket(std::vector<SeenText> lines) {
  std::erase_if(lines, [](const SeenText& line) { return !hasBracket(line); });
  return lines;
}

}  // namespace

namespace {

/// Regions where a displacement axis' title may stand; mirrored for an axis at the top.
struct LevelPlaces {
  Box below, close, beside, besideAxis, overEnd;
  Point towards, end;
};

LevelPlaces placesBelow(const Box& b, const Box& numbers) {
  const bool atTop = numbers.y1 < b.y0;
  const auto sided = [&](const Box& box) {
    return atTop ? Box{box.x0, b.y0 + b.y1 - box.y1, box.x1, b.y0 + b.y1 - box.y0} : box;
  };
  const Box labels = sided(numbers);
  LevelPlaces at;
  const double below_px = std::max(0.2 * b.height(), 6 * labels.height());
  at.below = sided({b.x0 - 0.05 * b.width(), labels.y1 + 1, b.x1 + 0.15 * b.width(), labels.y1 + below_px});
  // With little spacing the title's line overlaps that of the numbers.
  at.close =
      sided({b.x0 - 0.05 * b.width(), labels.middle().y + 1, b.x1 + 0.15 * b.width(), labels.y1 + below_px});
  at.beside = sided({std::min(labels.x1 + 2, b.x1), b.y1 - 0.15 * b.height(), b.x1 + 0.9 * b.width(),
                     b.y1 + 0.25 * b.height()});
  // If a force axis begins below zero, the displacement axis lies higher, with its title beside its end.
  at.besideAxis = sided({b.x1 + 2, b.y1 - 0.5 * b.height(), b.x1 + 0.4 * b.width(), b.y1 - 0.1 * b.height()});
  at.overEnd = sided({b.x0 + 0.5 * b.width(), b.y1 - 0.12 * b.height(), b.x1 + 0.1 * b.width(), b.y1});
  at.towards = {0.5 * (b.x0 + b.x1), atTop ? numbers.y0 : numbers.y1};
  at.end = {b.x1, atTop ? b.y0 : b.y1};
  return at;
}

}  // namespace

AxisTitle<LengthUnit> readXTitle(GraphReading& r, const Box& labels) {
  const LevelPlaces at = placesBelow(r.box, labels);
  AxisTitle<LengthUnit> best;
  std::vector<SeenText> nearby = r.ownTexts(at.below), read;
  consider(best, nearby, lengthUnitIn);
  if (!best.unit) {
    nearby = r.ownTexts(at.close);
    consider(best, nearby, lengthUnitIn);
  }
  consider(best, r.ownTexts(at.beside), lengthUnitIn);
  if (!best.unit) considerInside(best, r.ownTexts(at.overEnd), lengthUnitIn);
  if (isContradicted(best, nearby, at.towards)) return best;
  if (!best.unit) {
    read = r.readLines(at.below, 0, at.towards, 3);
    consider(best, read, lengthUnitIn);
    nearby.insert(nearby.end(), read.begin(), read.end());
  }
  if (isContradicted(best, nearby, at.towards)) return best;
  std::vector<SeenText> readBeside;
  if (!best.unit) {
    readBeside = r.readLines(at.beside, 0, at.end, 4);
    consider(best, readBeside, lengthUnitIn);
  }
  if (!best.unit) consider(best, r.readLinesOfParts(at.below, 0, at.towards, 2), lengthUnitIn);
  if (!best.unit) considerInside(best, r.readLinesInside(at.overEnd, 0, at.end, 2), lengthUnitIn);
  if (!best.unit) considerInside(best, r.readLines(at.besideAxis, 0, at.end, 2), lengthUnitIn);
  if (!best.unit && !r.glyphs.empty()) consider(best, r.readLines(at.close, 0, at.towards, 2), lengthUnitIn);
  if (!best.unit) considerAgain(best, r, read, lengthUnitIn);
  if (!best.unit) considerAgain(best, r, withBracket(readBeside), lengthUnitIn);
  if (!best.unit || best.unit->sure < surePlace)
    best.other = otherQuantity(nearby, at.towards, besides(best, forceUnitIn));
  return best;
}

namespace {

/// Regions where a force axis' title may stand; mirrored for an axis at the right.
struct TitlePlaces {
  Box left, leftOfAxis, above, corner, besideEnd, overEnd;
  Point towards;
  bool mirrored = false;
};

TitlePlaces placesBeside(const Box& b, const Box& numbers) {
  TitlePlaces at;
  at.mirrored = numbers.x0 > b.x1;
  const auto sided = [&](const Box& box) {
    return at.mirrored ? Box{b.x0 + b.x1 - box.x1, box.y0, b.x0 + b.x1 - box.x0, box.y1} : box;
  };
  const Box labels = sided(numbers);
  // With little spacing the title overlaps the first digit of the widest label.
  const Box left{b.x0 - 0.45 * b.width(), b.y0 - 0.05 * b.height(), labels.x0 + 0.3 * (labels.x1 - labels.x0),
                 b.y1 + 0.05 * b.height()};
  at.left = sided(left);
  at.leftOfAxis = sided({left.x0, left.y0, b.x0, left.y1});
  at.above = sided({b.x0 - 0.4 * b.width(), b.y0 - 0.6 * b.height(), b.x0 + 0.5 * b.width(), b.y0 - 1});
  at.corner = sided(
      {b.x0 - 0.35 * b.width(), b.y0 - 0.6 * b.height(), b.x0 + 0.12 * b.width(), b.y0 + 0.02 * b.height()});
  at.besideEnd = sided({b.x0, b.y0 - 0.1 * b.height(), b.x0 + 0.12 * b.width(), b.y0 + 0.4 * b.height()});
  at.overEnd = sided({b.x0, b.y0 - 0.1 * b.height(), b.x0 + 0.35 * b.width(), b.y0 + 0.1 * b.height()});
  at.towards = {at.mirrored ? numbers.x1 : numbers.x0, 0.5 * (b.y0 + b.y1)};
  return at;
}

AxisTitle<ForceUnit> readYTitleAt(GraphReading& r, const TitlePlaces& at) {
  const Box& b = r.box;
  const double axis = at.mirrored ? b.x1 : b.x0;
  AxisTitle<ForceUnit> best;
  std::vector<SeenText> upwards, read;
  for (const auto& t : r.ownTexts(at.leftOfAxis))
    if (std::abs(t.angle_deg) > 45) upwards.push_back(t);
  for (const auto& region : {at.leftOfAxis, at.above, at.corner})
    consider(best, r.ownTexts(region), forceUnitIn);
  if (!best.unit) considerInside(best, r.ownTexts(at.besideEnd), forceUnitIn);
  if (isContradicted(best, upwards, at.towards)) return best;
  if (!best.unit) {
    read = r.readLines(at.left, 90, at.towards, 2);
    consider(best, read, forceUnitIn);
    upwards.insert(upwards.end(), read.begin(), read.end());
  }
  if (isContradicted(best, upwards, at.towards)) return best;
  if (!best.unit) {
    const auto ofParts = r.readLinesOfParts(at.left, 90, at.towards, 1);
    consider(best, ofParts, forceUnitIn);
    upwards.insert(upwards.end(), ofParts.begin(), ofParts.end());
  }
  if (!best.unit) consider(best, r.readLines(at.above, 0, {axis, b.y0}, 6), forceUnitIn);
  // A title that runs upwards, read as a level line, gives units of single letters, so a level unit must be
  // certain.
  if (!best.unit || best.unit->sure < surePlace)
    consider(best, r.readLines(at.corner, 90, {axis, b.y0}, 5), forceUnitIn);
  if (!best.unit)
    consider(best, withoutPartsOf(upwards, r.readLines(at.left, 0, {at.towards.x, b.y0}, 2)), forceUnitIn);
  // downwards, as in Chinese sheets; other writing read in this direction gives units of single letters
  if (!best.unit) {
    AxisTitle<ForceUnit> downwards;
    consider(downwards, r.readLines(at.left, -90, at.towards, 1), forceUnitIn);
    if (downwards.unit && downwards.unit->sure >= surePlace) best = std::move(downwards);
  }
  if (!best.unit) considerInside(best, r.readLinesInside(at.besideEnd, 90, {axis, b.y0}, 2), forceUnitIn);
  // A level title beside the axis' arrow, with the frame's top edge through its letters.
  if (!best.unit) considerInside(best, r.readLinesInside(at.overEnd, 0, {axis, b.y0}, 2), forceUnitIn);
  if (!best.unit) considerAgain(best, r, read, forceUnitIn);
  if (!best.unit || best.unit->sure < surePlace)
    best.other = otherQuantity(upwards, at.towards, besides(best, lengthUnitIn));
  // If no title runs along the axis, a level one over its end names the quantity.
  if (!best.unit && best.other.empty())
    best.other = otherQuantity(r.ownTexts(at.corner), {axis, b.y0}, besides(best, lengthUnitIn));
  return best;
}

}  // namespace

AxisTitle<ForceUnit> readYTitle(GraphReading& r, const Box& labels) {
  const Box& b = r.box;
  const TitlePlaces at = placesBeside(b, labels);
  AxisTitle<ForceUnit> title = readYTitleAt(r, at);
  if (title.unit || !title.other.empty() || !at.mirrored) return title;
  // Some programs move the tick labels to the right side but leave the title on the left.
  AxisTitle<ForceUnit> left = readYTitleAt(r, placesBeside(b, {b.x0 - 1, b.y0, b.x0, b.y1}));
  return left.unit ? left : title;
}

AxisTitle<ForceUnit> readRightTitle(GraphReading& r, const Box& labels) {
  return readYTitleAt(r, placesBeside(r.box, labels));
}

}  // namespace detent::importer
