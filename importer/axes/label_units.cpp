// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/label_units.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "importer/axes/printed_number.h"
#include "importer/axes/printed_unit.h"

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
    if (const auto unit = parse(letters)) ++votes[unit->unit];
  }
  const auto most = std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; });
  if (most == votes.end() || most->second < fewest || 2 * most->second <= lettered) return {};
  return most->first;
}

}  // namespace

std::optional<LengthUnit> lengthUnitBehindNumbers(GraphReading& r, const AxisLabels& labels) {
  return unitBehindNumbers<LengthUnit>(r, labels, lengthUnitIn);
}

std::optional<ForceUnit> forceUnitBehindNumbers(GraphReading& r, const AxisLabels& labels) {
  // The axis is to be one of forces: "of" is what the engine makes of "gf" there.
  return unitBehindNumbers<ForceUnit>(r, labels, [](const std::string& letters) {
    const auto unit = forceUnitIn(letters);
    return unit ? unit : forceUnitIn("force (" + letters + ")");
  });
}

}  // namespace detent::importer
