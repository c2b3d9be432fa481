// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The list of trials of one participant: a function of the study's seed and the participant's id, so that it
// can be made again after a crash and by anyone who doubts it.

#include <cstddef>
#include <string>
#include <vector>

#include "playback/study/trials/study_design.h"

namespace detent::playback {

/// One question: which of `choices` is X?
struct Trial {
  std::size_t number = 0;  ///< from 1, practice first, as the participant meets them
  bool practice = false;   ///< answered and kept, but counted nowhere
  FeedbackMode mode = FeedbackMode::full;
  std::vector<std::size_t> choices;  ///< indices of buttons in the order shown; abx: alpha, beta
  std::size_t target = 0;            ///< which of `choices` X is
};

/// abx: every pair `trials` times in every mode, shuffled as one list (K&L, Experiment 1). Within a pair and
/// mode, who is alpha and who is X are balanced independently of each other, by half (an odd one out falls by
/// chance). matching: every button `trials` times in every mode, the choices in a new order each time.
std::vector<Trial> planTrials(const Study& study, const std::string& participant);

/// How many of them count.
std::size_t countedTrials(const Study& study);

}  // namespace detent::playback
