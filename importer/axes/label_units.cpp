// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/label_units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "importer/axes/printed_number.h"
#include "importer/lexicon/printed_unit.h"

namespace detent::importer {
namespace {

template <class Unit, class Parse>
std::optional<Unit> unitBehindNumbers(GraphReading& r, const AxisLabels& labels, Parse parse) {
  constexpr int fewest = 3;
  std::map<Unit, int> votes;
  int lettered = 0;
  const std::vector<Box> wholes = withLettersBehind(r.glyphs, labels);
  for (std::size_t i = 0; i < wholes.size(); ++i) {
    if (labels.readings[i].empty()) continue;
    const auto [number, letters] = numberAndSuffix(r.reader.readLine(wholes[i], TextKind::words).utf8);
    if (letters.empty() || !printedNumber(number)) continue;
    ++lettered;
    if (const auto unit = parse(letters, TextSource::recognised)) ++votes[unit->unit];
  }
  const auto most = std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; });
  if (most == votes.end() || most->second < fewest || 2 * most->second <= lettered) return {};
  return most->first;
}

/// Box in place of the highest number's neighbour on an axis; empty if a number or nothing is there.
Box placeBelowHighest(const GraphReading& r, const AxisLabels& labels, bool alongX) {
  // share of a step along the axis; share of a number's height across it
  constexpr double near = 0.3, beside = 0.5;
  const Progression& p = *labels.progression;
  double highest = -HUGE_VAL, height = 0;
  Box row;
  for (std::size_t i = 0; i < labels.words.size(); ++i) {
    if (p.reading[i] < 0) continue;
    const Box& word = labels.words[i].box;
    row = row.empty() ? word : row.joined(word);
    height = std::max(height, word.height());
    highest = std::max(highest, labels.readings[i][static_cast<std::size_t>(p.reading[i])].value);
  }
  const double at = p.position(highest - p.step), reach = near * std::abs(p.step / p.perPx);
  const Box place = alongX ? Box{at - reach, row.y0 - beside * height, at + reach, row.y1 + beside * height}
                           : Box{row.x0 - beside * height, at - reach, row.x1 + 2, at + reach};
  Box there;
  for (const Box& glyph : r.glyphs)
    if (place.contains(glyph)) there = there.empty() ? glyph : there.joined(glyph);
  const bool isLabel = std::ranges::any_of(labels.words, [&](const SeenText& word) {
    const auto i = static_cast<std::size_t>(&word - labels.words.data());
    return p.reading[i] >= 0 && !word.box.common(there).empty();
  });
  return isLabel ? Box{} : there;
}

template <class Unit, class Parse>
std::optional<Unit> unitInPlaceOfNumber(GraphReading& r, const AxisLabels& labels, bool alongX,
                                        double certain, Parse parse) {
  constexpr int fewest = 4;  // least number of other labels, which then define the scale
  if (!labels.progression || !labels.progression->fromTicks || labels.progression->labels < fewest) return {};
  const Box place = placeBelowHighest(r, labels, alongX);
  if (place.empty()) return {};
  const SeenText text = r.reader.readLine(place, TextKind::words);
  const bool isWord = std::ranges::none_of(text.utf8, [](char c) { return c >= '0' && c <= '9'; });
  if (!isWord || text.confidence < certain) return {};
  const auto unit = parse(text.utf8, TextSource::recognised);
  return unit ? std::optional<Unit>(unit->unit) : std::nullopt;
}

}  // namespace

std::optional<LengthUnit> lengthUnitInPlaceOfNumber(GraphReading& r, const AxisLabels& labels) {
  constexpr double certain =
      0.8;  // confidence of the engine: units of length are hardly confused, but cN and mN are
  return unitInPlaceOfNumber<LengthUnit>(r, labels, true, certain, lengthUnitIn);
}

std::optional<ForceUnit> forceUnitInPlaceOfNumber(GraphReading& r, const AxisLabels& labels) {
  return unitInPlaceOfNumber<ForceUnit>(r, labels, false, readWithCertainty, forceUnitIn);
}

std::optional<LengthUnit> lengthUnitBehindNumbers(GraphReading& r, const AxisLabels& labels) {
  return unitBehindNumbers<LengthUnit>(r, labels, lengthUnitIn);
}

std::optional<ForceUnit> forceUnitBehindNumbers(GraphReading& r, const AxisLabels& labels) {
  // On a force axis the engine reads "gf" as "of".
  return unitBehindNumbers<ForceUnit>(r, labels, [](const std::string& letters, TextSource source) {
    const auto unit = forceUnitIn(letters, source);
    return unit ? unit : forceUnitIn("force (" + letters + ")", source);
  });
}

}  // namespace detent::importer
