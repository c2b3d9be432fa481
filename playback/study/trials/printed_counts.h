// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Published results: counts by pair without single trials, such as K&L's Tables 1 and 2. The same figures are
// computed from them as from answers, and the counts are checked against each other.

#include <filesystem>

#include "playback/study/trials/study_results.h"

namespace detent::playback {

/// Returns true if a folder holds printed counts (counts.json) instead of a study.
bool holdsPrintedCounts(const std::filesystem::path& folder);

/// The published counts as results without rows, with a warning if they do not add up. Failure
/// unreadableInput: broken, or of another version.
Result<StudyResults> readPrintedCounts(const std::filesystem::path& folder);

}  // namespace detent::playback
