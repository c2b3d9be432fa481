// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study's results as one HTML page without other files: K&L's Tables 1 and 2 with their shading as marks,
// diagrams as SVG, and on every printed page a statement whether a person answered at all.

#include <string>
#include <vector>

#include "playback/study/trials/study_results.h"

namespace detent::playback {

/// Forecast of one pair in one mode, shown beside the result.
struct ForetoldPair {
  FeedbackMode mode = FeedbackMode::full;
  std::size_t first = 0, second = 0;
  double dPrime = 0;
  double errorRate = 0;  ///< [0, 0.5]; for sorting the pairs, not for display
  std::string verdict;   ///< "people tell these apart: 0 to 7 errors in 90"
  std::string reason;
};

/// A page up to the beginning of its body, which gets the class `bodyClass` (may be empty). Style and print
/// layout are common to all pages of a study.
std::string pageBeginning(const std::string& title, const std::string& bodyClass = {});

/// The page in UTF-8. `foretold` may be empty; it is shown beside the groups of its mode.
std::string resultsPage(const StudyResults& results, const std::vector<ForetoldPair>& foretold);

}  // namespace detent::playback
