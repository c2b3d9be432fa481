// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/axis_titles.h"

#include <algorithm>

namespace detent::importer {
namespace {

template <class Unit, class Parse>
void consider(AxisTitle<Unit>& best, const std::vector<SeenText>& lines, Parse parse) {
  for (const auto& line : lines) {
    const auto unit = parse(line.utf8);
    if (unit && (!best.unit || unit->sure > best.unit->sure)) {
      best.unit = unit;
      best.text = line.utf8;
    }
    if (best.text.empty()) best.text = line.utf8;
  }
}

}  // namespace

AxisTitle<LengthUnit> readXTitle(GraphReading& r, const Box& labels) {
  const Box& b = r.box;
  const double below_px = std::max(0.2 * b.height(), 6 * labels.height());
  const Box below{b.x0 - 0.05 * b.width(), labels.y1 + 1, b.x1 + 0.15 * b.width(), labels.y1 + below_px};
  const Box beside{std::min(labels.x1 + 2, b.x1), b.y1 - 0.15 * b.height(), b.x1 + 0.45 * b.width(),
                   b.y1 + 0.25 * b.height()};
  AxisTitle<LengthUnit> best;
  consider(best, r.ownTexts(below), lengthUnitIn);
  consider(best, r.ownTexts(beside), lengthUnitIn);
  if (best.unit) return best;
  consider(best, r.readLines(below, 0, {0.5 * (b.x0 + b.x1), labels.y1}, 3), lengthUnitIn);
  if (!best.unit) consider(best, r.readLines(beside, 0, {b.x1, b.y1}, 4), lengthUnitIn);
  return best;
}

AxisTitle<ForceUnit> readYTitle(GraphReading& r, const Box& labels) {
  const Box& b = r.box;
  const Box left{b.x0 - 0.45 * b.width(), b.y0 - 0.05 * b.height(), labels.x0 - 1, b.y1 + 0.05 * b.height()};
  const Box leftOfAxis{left.x0, left.y0, b.x0, left.y1};
  const Box above{b.x0 - 0.4 * b.width(), b.y0 - 0.4 * b.height(), b.x0 + 0.5 * b.width(), b.y0 - 1};
  const Box corner{b.x0 - 0.35 * b.width(), b.y0 - 0.6 * b.height(), b.x0 + 0.12 * b.width(),
                   b.y0 + 0.02 * b.height()};
  AxisTitle<ForceUnit> best;
  for (const auto& region : {leftOfAxis, above, corner}) consider(best, r.ownTexts(region), forceUnitIn);
  if (best.unit) return best;
  consider(best, r.readLines(left, 90, {labels.x0, 0.5 * (b.y0 + b.y1)}, 2), forceUnitIn);
  if (!best.unit) consider(best, r.readLines(above, 0, {b.x0, b.y0}, 4), forceUnitIn);
  if (!best.unit) consider(best, r.readLines(corner, 90, {b.x0, b.y0}, 3), forceUnitIn);
  if (!best.unit) consider(best, r.readLines(left, 0, {labels.x0, b.y0}, 2), forceUnitIn);
  return best;
}

}  // namespace detent::importer
