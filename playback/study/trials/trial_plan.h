// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The list of trials of one participant: it depends only on the study's seed and the participant's id and
// place, so that it can be recreated after a crash, and verified by anyone.

#include <cstddef>
#include <string>
#include <vector>

#include "playback/study/trials/study_design.h"

namespace detent::playback {

/// One question: which of `choices` is X? Are the two the same? Threshold: which has more? Rating: how good
/// is it, or which is better? Timing: press, at a time.
struct Trial {
  std::size_t number = 0;  ///< from 1, practice first, in the order shown
  bool practice = false;   ///< answered and stored, but not counted
  FeedbackMode mode = FeedbackMode::full;
  std::vector<std::size_t> choices;  ///< indices of buttons in the order shown; abx: alpha, beta
  std::size_t target = 0;  ///< which of `choices` X is, or has more; same/different: 1 if they differ; else 0
  double interval_s = 0, window_s = 0;  ///< timing: cue and window; else 0
  bool breakBefore = false;             ///< the participant may rest before it, as long as they like
};

/// abx: every pair `trials` times in every mode. Within a pair and mode the four cells of who is alpha and
/// who is X are filled alike; of two trials that remain each has another alpha and another X, and which side
/// X falls on then alternates from pair to pair. same/different: likewise, for who is first and whether the
/// second is the other. matching: every button `trials` times in every mode, the
/// choices in a new order each time. threshold: every button `trials` times in every mode; what has more
/// stands first as often as second, and which level it is follows from the answers (next_level.cpp): until
/// then its place holds the button itself. timing: every button `trials` times in every mode, intervals and
/// windows each as often as the others. rating: every button, or pair, `trials` times in every mode; of a
/// pair each is first as often as second. Trials are shuffled within a mode; of rating, each button or pair
/// once before any comes again. Modes are blocks with a break between; over participants their order is
/// counterbalanced by `place`, which is planned (planned_places.h) or the number of those who began before.
/// So are the pairs where each gets some: they differ by at most one. Studies of version 1 were shuffled as
/// one list, and X was balanced by sides alone.
std::vector<Trial> planTrials(const Study& study, const std::string& participant, std::size_t place = 0);

/// The buttons that are felt, in the order shown: `choices`; in same/different the first of them twice where
/// the right answer is "same".
std::vector<std::size_t> feltButtons(const StudyDesign& design, const Trial& trial);
/// An answer as journals and tables name it: "same", "different", or the label of the choice.
std::string answerName(const Study& study, const Trial& trial, std::size_t choice);

/// Number of trials that count.
std::size_t countedTrials(const Study& study);

}  // namespace detent::playback
