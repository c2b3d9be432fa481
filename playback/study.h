// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Public interface of studies with people: can they tell these buttons apart, and will they?
//
// In: buttons, a design, answers of participants. Out: a journal for each participant, figures with intervals
// as text, JSON, CSV, BIDS and a page; a forecast without participants. Reading order:
//   study/trials/consent.h             what participants agree to
//   study/trials/study_design.h        which buttons, which task, how often: one folder
//   study/trials/study_plan.h          power, a page to preregister, lists of trials (planned_places.h)
//   study/trials/trial_plan.h          the list of one participant
//   study/trials/participant_record.h  what a journal says (study/journal: lines that are on the disk)
//   study/trials/trial_controller.h          one running trial; timing_controller.h: one with timed presses
//   study/trials/participant_session.h one participant at work
//   study/trials/figure_table.h        a table for every format; answer_tables.h: thresholds and ratings,
//                                      timing_tables.h: timed presses
//   study/trials/study_results.h       rows and figures (study/statistics)
//   study/trials/study_output.h        prints them as text, JSON, CSV and BIDS; study_page.h: as a page
//   study/perception/*                 what is felt, who is confused with whom, what would help
//   study/study_player.h               the button under the participant's finger
//   study/timed_run.h                  one timed trial from its first sight to the journal
//   this file                          the forecast of a study
//
// Threads: ordinary threads only. A library built without DETENT_WITH_STUDIES has none of it.

#include <vector>

#include "playback/study/perception/design_help.h"
#include "playback/study/perception/forecast_words.h"
#include "playback/study/study_player.h"
#include "playback/study/timed_run.h"
#include "playback/study/trials/consent.h"
#include "playback/study/trials/participant_session.h"
#include "playback/study/trials/study_output.h"
#include "playback/study/trials/study_page.h"
#include "playback/study/trials/timing_controller.h"
#include "playback/study/trials/trial_controller.h"

namespace detent::playback {

/// Forecast for a study's buttons on its device, mode by mode in the order of pairsOf(); empty if the study
/// does not ask which one X is. Some ten milliseconds per button and mode. Failure: as feel(). Any thread.
Result<std::vector<ForetoldPair>> foretold(const Study& study);

}  // namespace detent::playback
