// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an edit has to keep together (EditLinks): both ends of the travel, the release below its press, pinned points.

#include "model/annotations.h"
#include "model/result.h"

namespace detent {

/// What an edit from `before` to `after` gives while `links` hold: where one stroke's end has moved, the bottom-out of every
/// other stroke of all states goes to the same end; then each release is its press less the offset. Without links, and where
/// they are kept already, `after` itself. Failure wrongUsage: two ends that were moved to different places, a stroke too short
/// to end there, a release that was edited while it follows its press, a pinned place that would move. Any thread.
Result<Button> keptLinks(const Button& before, const Button& after, const EditLinks& links);

/// The button as the links want it from now on: every stroke ends where the press of `state` does, each release is its press
/// less the offset. Pins ask for nothing. Failures: as above.
Result<Button> linkedTo(const Button& button, std::size_t state, const EditLinks& links);

}  // namespace detent
