// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Results of thresholds and ratings, as tables. Any thread.

#include <vector>

#include "playback/study/trials/figure_table.h"
#include "playback/study/trials/participant_record.h"

namespace detent::playback {

/// Thresholds of each participant, and of each button over participants. A condition of its own for each of
/// listening, mode and who answered, as in the rows.
std::vector<FigureTable> thresholdTables(const Study& study,
                                         const std::vector<ParticipantRecord>& participants);

/// Scales: what each button got over participants. Pairwise: Bradley-Terry scores. Then every two buttons
/// against each other, participants as their own control.
std::vector<FigureTable> ratingTables(const Study& study, const std::vector<ParticipantRecord>& participants);

}  // namespace detent::playback
