// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Buttons between buttons. Force graphs are averaged feature by feature, not displacement by displacement, where the peaks of two
// buttons would become two bumps: start, peak, valley, operating or reset point, the foot of the bottom-out and the end are laid on one
// another, travels and forces of each are averaged, and so is what lies between two of them, over the share of the way from one to the
// next.

#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

/// The weighted mean of buttons. A feature that one of them lacks, or has in another order, is not aligned. Exact: where all
/// curves are the same, so is the mean, to rounding. The work of each stroke is kept between the least and the largest of the buttons'
/// by one factor on its forces. A release, an operating and a reset point need one in every button; damping missing counts as none.
///
/// `weights`: one per button, finite, >= 0, with a sum above 0; only their ratios count. The name is the first button's, the provenance
/// none. Failure wrongUsage: no buttons, weights that do not fit, momentary and self-locking buttons mixed. Any thread.
Result<Button> blend(const std::vector<Button>& buttons, const std::vector<double>& weights,
                     const SectionSettings& settings = {});

/// The button on the way from `from` to `to`; `share` in [0, 1]. 0 and 1 give the buttons themselves, to the bit; near them the curves
/// are within rounding of theirs. Its name is "FROM - TO". Failures: as of blend; wrongUsage for a share outside.
Result<Button> between(const Button& from, const Button& to, double share,
                       const SectionSettings& settings = {});

}  // namespace detent
