// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Constraints that edits keep (EditLinks): common travel end, release below its press, pinned points.

#include "model/annotations.h"
#include "model/result.h"

namespace detent {

/// Returns `after` changed so that `links` hold: if one stroke's end moved, the bottom-outs of all other
/// strokes move to the same end; then each release is its press less the offset. Returns `after` itself if
/// the links hold already. Failure wrongUsage: two ends moved to different places, a stroke too short to end
/// there, a release edited while it follows its press, or a pinned place that would move. Any thread.
Result<Button> keptLinks(const Button& before, const Button& after, const EditLinks& links);

/// Returns the button with the links applied: every stroke ends where the press of `state` does, each release
/// is its press less the offset. Pins require nothing. Failures: as above.
Result<Button> linkedTo(const Button& button, std::size_t state, const EditLinks& links);

}  // namespace detent
