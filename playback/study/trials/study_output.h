// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A study's results as files and text: tidy CSV, BIDS, tables in the layout of K&L's Tables 1 and 2. Pages
// with pictures are in study_page.h.

#include <filesystem>
#include <string>

#include "playback/study/trials/study_results.h"

namespace detent::playback {

/// One row per trial; `study,participant,trial,pair,a,b,x,answer,correct,replays_a,replays_b,replays_x,
/// answer_s,condition`; `level`, `rating` or times for those kinds; then `feel,finished,site`. Fields with
/// commas, quotes or line ends are quoted (RFC 4180); decimal points.
std::string resultsCsv(const StudyResults& results);

/// Felt stimuli: one row per trial and stimulus (1, 2, … as shown, x);
/// `study,participant,trial,stimulus,button,presses,whole,peak_N, travel_mm,condition`. Journals that did not
/// record it give no rows.
std::string feltCsv(const StudyResults& results);

/// Writes `folder`/dataset_description.json, participants.tsv, task-NAME_events.json and, per participant,
/// sub-ID/beh/sub-ID_task-NAME_events.tsv (BIDS: onset first, duration second, n/a for missing values).
Result<Done> writeBids(const StudyResults& results, const std::filesystem::path& folder);

/// The results by the other rule for unfinished participants: with them if `results` leaves them out, without
/// them if it counts them. Groups and tables are empty if that makes no difference.
StudyResults otherwise(const StudyResults& results);
/// Title of the other results: "With those who did not finish", or without.
std::string otherwiseTitle(const StudyResults& results);

/// Both tables as text, with intervals, d' and the caveats.
std::string resultsText(const StudyResults& results);
/// One JSON object, one line.
std::string resultsJson(const StudyResults& results);

}  // namespace detent::playback
