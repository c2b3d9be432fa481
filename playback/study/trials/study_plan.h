// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Planning of a study before the first person comes: number of people and trials for a difference, the tests
// (a page for preregistration), and the lists of trials. Any thread.

#include <string>
#include <vector>

#include "playback/study/trials/figure_table.h"
#include "playback/study/trials/planned_places.h"
#include "playback/study/trials/study_design.h"
#include "playback/study/trials/study_page.h"

namespace detent::playback {

/// The list for one place: `participant,trial,practice,rest_before,mode,choice_1,...,x`; x is empty if the
/// trial has none, and for a threshold the choice that has more. Timing adds interval_s,window_s.
std::string listCsv(const Study& study, const std::string& participant, std::size_t place);

/// Writes ID.csv for every participant into `folder`, and the plan into the study, which then follows it.
/// Returns the SHA-256 over all lists in order. Failure wrongUsage: somebody has begun already.
Result<std::string> writeLists(const Study& study, const PlannedPlaces& plan,
                               const std::filesystem::path& folder);
/// Changes only the rule for the unfinished; existing lists are kept. Failure wrongUsage: somebody has begun
/// already.
Result<Done> writeUnfinishedRule(const Study& study, Unfinished rule);

/// Power for various numbers of people and trials; takes some seconds for many people.
std::vector<FigureTable> powerTables(const Study& study);

/// Contents of a preregistration.
struct Preregistration {
  std::size_t people = 0;
  std::string listsSha256;               ///< empty: no lists were made
  std::vector<FigureTable> power;        ///< powerTables()
  std::vector<ForetoldPair> foretold{};  ///< may be empty
  Unfinished unfinished = Unfinished::leftOut;
};

/// One HTML page: hypotheses, design, stimuli, people, randomisation, measures, tests, exclusions; blanks for
/// what only the researcher knows.
std::string preregistrationPage(const Study& study, const Preregistration& plan);

}  // namespace detent::playback
