// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Weighted means of buttons. Force graphs are averaged feature by feature: start, peak, valley, contact
// points, start of the bottom-out and end are aligned before forces and travels are averaged. Averaging by
// displacement would turn one peak at different places into two bumps.

#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent {

/// Returns the weighted mean of buttons. A feature that one button lacks, or has in another order, is not
/// aligned.
/// If all curves are equal, so is the mean, to rounding. One factor on the forces keeps the work of each
/// stroke between those of the buttons. Release, operating point and reset point exist in the mean only if
/// every button has them; missing damping counts as 0.
/// `weights`: one per button, finite, >= 0, with a sum above 0; only their ratios count. The name is the
/// first button's; there is no provenance. Failure wrongUsage: no buttons, weights that do not fit, momentary
/// and self-locking buttons mixed. Any thread.
Result<Button> blend(const std::vector<Button>& buttons, const std::vector<double>& weights,
                     const SectionSettings& settings = {});

/// Returns the button at `share` in [0, 1] of the way from `from` to `to`. 0 and 1 return the buttons
/// themselves, bit for bit. The name is "FROM - TO". Failures: as of blend; wrongUsage for a share outside
/// [0, 1].
Result<Button> between(const Button& from, const Button& to, double share,
                       const SectionSettings& settings = {});

}  // namespace detent
