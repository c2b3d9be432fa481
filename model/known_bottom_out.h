// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What sections.h gives, where the curve's bottom-out is known already: to find it is most of the work.

#include <vector>

#include "model/stroke_curve.h"

namespace detent {

struct BottomOut;
struct Section;
struct SectionSettings;
struct TactilePoint;

/// As tactilePoints() and sectionsOf() without it; `bottomOut` is bottomOutOf(curve, settings).
std::vector<TactilePoint> tactilePoints(const StrokeCurve& curve, Stroke stroke, const BottomOut& bottomOut,
                                        const SectionSettings& settings);
std::vector<Section> sectionsOf(const StrokeCurve& curve, Stroke stroke, const BottomOut& bottomOut,
                                const SectionSettings& settings);

}  // namespace detent
