// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/library_switch.h"

#include <algorithm>

#include "model/units.h"

namespace detent::importer {
namespace {

// Any limit from 5 to 8 gf classifies 94 to 96 % of 112 labelled switches correctly.
constexpr double linearBelow_gf = 5, tactileAbove_gf = 8;

// Of 1,008 records with a peak, 125 are of linear switches; 99 of these have the peak this near to the start.
constexpr double contactReach_mm = 0.3;

}  // namespace

std::string_view nameOf(SwitchKind kind) {
  switch (kind) {
    case SwitchKind::linear:
      return "linear";
    case SwitchKind::between:
      return "between";
    case SwitchKind::tactile:
      return "tactile";
  }
  return "";
}

SwitchKind kindOf(const KeyFigures& figures) {
  const double drop_gf = figures[KeyFigure::drop].value_or(0) / newtonsPer(ForceUnit::gramForce);
  if (drop_gf < linearBelow_gf) return SwitchKind::linear;
  return drop_gf > tactileAbove_gf ? SwitchKind::tactile : SwitchKind::between;
}

void forgetContactBump(KeyFigures& figures, KeyFigures& sigmas, double start_mm) {
  const auto& peak_mm = figures[KeyFigure::peakTravel];
  if (!peak_mm || kindOf(figures) != SwitchKind::linear ||
      *peak_mm - std::max(start_mm, 0.0) > contactReach_mm)
    return;
  for (const KeyFigure figure : {KeyFigure::peakForce, KeyFigure::peakTravel, KeyFigure::valleyForce,
                                 KeyFigure::valleyTravel, KeyFigure::drop, KeyFigure::snapRatio,
                                 KeyFigure::slopeToPeak, KeyFigure::slopeOfDrop, KeyFigure::slopeToBottomOut})
    figures[figure] = sigmas[figure] = {};
}

}  // namespace detent::importer
