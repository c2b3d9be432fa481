// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Variants of the functions in sections.h for a known bottom-out, whose search is most of their work.

#include <vector>

#include "model/stroke_curve.h"

namespace detent {

struct BottomOut;
struct Section;
struct SectionSettings;
struct TactilePoint;

/// Like tactilePoints() and sectionsOf() without this argument; `bottomOut` must equal bottomOutOf(curve,
/// settings).
std::vector<TactilePoint> tactilePoints(const StrokeCurve& curve, Stroke stroke, const BottomOut& bottomOut,
                                        const SectionSettings& settings);
std::vector<Section> sectionsOf(const StrokeCurve& curve, Stroke stroke, const BottomOut& bottomOut,
                                const SectionSettings& settings);

}  // namespace detent
