// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study before the first person comes: how many people and trials for which difference, what will be tested
// (a page to preregister), and who gets which list. Any thread.

#include <string>
#include <vector>

#include "playback/study/trials/figure_table.h"
#include "playback/study/trials/planned_places.h"
#include "playback/study/trials/study_design.h"
#include "playback/study/trials/study_page.h"

namespace detent::playback {

/// The list of one place: `participant,trial,practice,rest_before,mode,choice_1,...,x`; x is empty if the
/// trial has none, and for a threshold the choice that has more. Timing adds interval_s,window_s.
std::string listCsv(const Study& study, const std::string& participant, std::size_t place);

/// Writes ID.csv for everybody into `folder`, and the plan into the study, which keeps to it. Gives the
/// SHA-256 over all lists in order. Failure wrongUsage: somebody has begun already.
Result<std::string> writeLists(const Study& study, const PlannedPlaces& places,
                               const std::filesystem::path& folder);
/// The rule for the unfinished alone; lists made before stay. Failure wrongUsage: somebody has begun already.
Result<Done> writeUnfinishedRule(const Study& study, Unfinished rule);

/// Power for each number of people and trials; some seconds for many people.
std::vector<FigureTable> powerTables(const Study& study);

/// Contents of a preregistration.
struct Preregistration {
  std::size_t people = 0;
  std::string listsSha256;               ///< empty: no lists were made
  std::vector<FigureTable> power;        ///< powerTables()
  std::vector<ForetoldPair> foretold{};  ///< may be empty
  Unfinished unfinished = Unfinished::leftOut;
};

/// One HTML page: hypotheses, design, stimuli, people, randomisation, measures, tests, exclusions; blanks
/// where only the researcher knows.
std::string preregistrationPage(const Study& study, const Preregistration& plan);

}  // namespace detent::playback
