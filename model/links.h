// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Constraints that later edits keep (EditLinks): common travel end, release that follows its press, pinned
// points. Setting a link changes no curve.

#include "model/annotations.h"
#include "model/result.h"

namespace detent {

/// Returns `after` changed so that `links` hold: a release whose press the edit changed moves along (its
/// knots go where the press went, with the press's changes of force and slope); if one stroke's end moved,
/// the bottom-outs of all other strokes move to the same end. An edit that changes a release itself leaves
/// it so. Failure wrongUsage: two ends moved to different places, a stroke too short to end there, or a
/// pinned place that would move. Any thread.
Result<Button> keptLinks(const Button& before, const Button& after, const EditLinks& links);

/// Lowers all forces of every release (by_N < 0: raises). Failure if a curve cannot have such forces.
Result<Button> lowerReleases(Button button, double by_N);

}  // namespace detent
