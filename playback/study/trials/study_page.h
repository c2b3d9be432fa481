// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study's results as one HTML page that needs nothing else: K&L's Tables 1 and 2 with their shading as
// marks, pictures as SVG, and on every page of a print whether a person answered at all.

#include <string>
#include <vector>

#include "playback/study/trials/study_results.h"

namespace detent::playback {

/// Forecast of one pair in one mode, to be shown beside the result.
struct ForetoldPair {
  FeedbackMode mode = FeedbackMode::full;
  std::size_t first = 0, second = 0;
  double dPrime = 0;
  double errorRate = 0;  ///< [0, 0.5]; for the order of the pairs, not for reading
  std::string verdict;   ///< "people tell these apart: 0 to 7 errors in 90"
  std::string reason;
};

/// A page up to the beginning of its body, which is given `bodyClass` (may be empty). Style and printing are
/// those of all pages of a study.
std::string pageBeginning(const std::string& title, const std::string& bodyClass = {});

/// UTF-8. `foretold` may be empty; it stands beside the groups of its mode.
std::string resultsPage(const StudyResults& results, const std::vector<ForetoldPair>& foretold);

}  // namespace detent::playback
