// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Results of same/different, thresholds, ratings and matching, as tables. Any thread.

#include <vector>

#include "playback/study/trials/figure_table.h"
#include "playback/study/trials/participant_record.h"

namespace detent::playback {

/// Same/different: hits, false alarms and d' of each pair, tested against people who cannot distinguish the
/// two.
std::vector<FigureTable> sameDifferentTables(const Study& study,
                                             const std::vector<ParticipantRecord>& participants);

/// Thresholds of each participant, and of each button over participants, separately for each combination of
/// listening, mode and who answered, as in the rows.
std::vector<FigureTable> thresholdTables(const Study& study,
                                         const std::vector<ParticipantRecord>& participants);

/// Scales: the ratings of each button over participants; for pairwise comparisons, Bradley-Terry scores. Then
/// all pairs of buttons compared, with participants as their own control; for 1 to 7 also by order alone.
std::vector<FigureTable> ratingTables(const Study& study, const std::vector<ParticipantRecord>& participants);

/// Matching: how often each button was found, compared with guessing; how often the buttons of each pair were
/// confused, compared with two that feel the same. With intervals and exact p.
std::vector<FigureTable> matchingTables(const Study& study,
                                        const std::vector<ParticipantRecord>& participants);

}  // namespace detent::playback
