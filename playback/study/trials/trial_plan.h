// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The list of trials of one participant: it depends only on the study's seed and the participant's id and
// place, so that it can be recreated after a crash, and verified by anyone.

#include <cstddef>
#include <string>
#include <vector>

#include "playback/study/trials/study_design.h"

namespace detent::playback {

/// One question. abx, matching: which of `choices` is X? same/different: are the two the same? threshold:
/// which has more? rating: how good is it, or which is better? timing: press at a time.
struct Trial {
  std::size_t number = 0;  ///< from 1, practice first, in the order shown
  bool practice = false;   ///< answered and stored, but not counted
  FeedbackMode mode = FeedbackMode::full;
  std::vector<std::size_t> choices;  ///< indices of buttons in the order shown; abx: alpha, beta
  /// index in `choices` of X, or of the one that has more; same/different: 1 if the two differ; else 0
  std::size_t target = 0;
  double interval_s = 0, window_s = 0;  ///< timing: interval to the cue, and duration of the window; else 0
  bool breakBefore = false;             ///< the participant may rest before this trial for any time
};

/// Makes the list of trials: `trials` of every pair (abx, same/different, pairwise rating) or button (all
/// others) in every mode.
/// abx: within a pair and mode, the four combinations of "which is alpha" and "which is X" are equally
/// frequent. Of two remaining trials each has another alpha and another X; the side of X then alternates from
/// pair to pair. same/different: likewise, for which button is first and whether the second one is the other
/// button.
/// matching: the choices have a new order in each trial.
/// threshold: the choice that has more is first as often as second. Its level follows from the answers
/// (next_level.cpp); until then, its place contains the button itself.
/// timing: all intervals and windows are equally frequent.
/// rating: in pairs, each button is first as often as second.
/// Trials are shuffled within a mode; in rating, each button or pair occurs once before any occurs again.
/// Modes are blocks with a rest between. Over participants, the order of modes is counterbalanced by `place`,
/// which is planned (planned_places.h) or the number of participants who began before. If each participant
/// gets only some pairs, these are counterbalanced too: their numbers differ by at most one. Studies of
/// version 1 were shuffled as one list, and X was balanced only by sides.
std::vector<Trial> planTrials(const Study& study, const std::string& participant, std::size_t place = 0);

/// The buttons that are felt, in the order shown: `choices`, or the first of them twice if the right answer
/// is "same".
std::vector<std::size_t> feltButtons(const StudyDesign& design, const Trial& trial);
/// An answer in the words of journals and tables: "same", "different", or the label of the choice.
std::string answerName(const Study& study, const Trial& trial, std::size_t choice);

/// Number of trials that count.
std::size_t countedTrials(const Study& study);

}  // namespace detent::playback
