// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Results of same/different, thresholds, ratings and matching, as tables. Any thread.

#include <vector>

#include "playback/study/trials/figure_table.h"
#include "playback/study/trials/participant_record.h"

namespace detent::playback {

/// Same/different: hits, false alarms and d' of each pair, against people who do not tell the two apart.
std::vector<FigureTable> sameDifferentTables(const Study& study,
                                             const std::vector<ParticipantRecord>& participants);

/// Thresholds of each participant, and of each button over participants. A condition of its own for each of
/// listening, mode and who answered, as in the rows.
std::vector<FigureTable> thresholdTables(const Study& study,
                                         const std::vector<ParticipantRecord>& participants);

/// Scales: what each button got over participants. Pairwise: Bradley-Terry scores. Then every two buttons
/// against each other, participants as their own control; 1 to 7 also by order alone.
std::vector<FigureTable> ratingTables(const Study& study, const std::vector<ParticipantRecord>& participants);

/// Matching: how often each button was found, against guessing; how often the buttons of each pair were taken
/// for each other, against two that feel the same. With intervals and exact p.
std::vector<FigureTable> matchingTables(const Study& study,
                                        const std::vector<ParticipantRecord>& participants);

}  // namespace detent::playback
