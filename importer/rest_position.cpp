// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/rest_position.h"

#include <algorithm>

#include "importer/page/findings.h"

namespace detent::importer {

Result<StrokeCurve> startingAtRest(const StrokeCurve& curve) {
  if (curve.start_mm() >= 0) return curve;
  if (curve.end_mm() <= 0)
    return failureOf({DoubtCode::negativeTravel,
                      {millimetres(curve.start_mm())},
                      {{RemedyKind::giveXAxis, "if the axis was misread"}}});
  const std::vector<Knot>& before = curve.knots();
  std::vector<Knot> knots = before;
  std::size_t atRest = 0;  // number of knots that are moved to 0 mm
  for (std::size_t i = 0; i < knots.size(); ++i) {
    knots[i].displacement_mm = std::max(knots[i].displacement_mm, 0.0);
    if (knots[i].displacement_mm <= 0) ++atRest;
    if (i == 0) continue;
    // The slope of a piece that is compressed along displacement grows by the same factor; a vertical piece
    // has none.
    const double width_mm = before[i].displacement_mm - before[i - 1].displacement_mm;
    const double squeezed_mm = knots[i].displacement_mm - knots[i - 1].displacement_mm;
    const double factor = squeezed_mm > 0 ? width_mm / squeezed_mm : 0;
    knots[i - 1].slopeAfter_N_per_mm *= factor;
    knots[i].slopeBefore_N_per_mm *= factor;
  }
  if (atRest > 2) {  // a vertical rise has two ends
    knots.erase(knots.begin() + 1, knots.begin() + static_cast<std::ptrdiff_t>(atRest) - 1);
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

}  // namespace detent::importer
