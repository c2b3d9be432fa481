// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Controller of one trial: which stimuli were tried, how often and how long, and whether the trial may be
// answered. The same for a terminal and a window. Times are of the caller's steady clock. One thread.

#include "playback/study/trials/participant_record.h"

namespace detent::playback {

class TrialController {
 public:
  /// The trial is shown at `now_s`; the period of work began at `began_s`.
  TrialController(const Study& study, const Trial& trial, double began_s, double now_s);

  const Trial& trial() const { return *trial_; }
  /// Returns true if X is a real switch, which is handed over, not played.
  bool physicalTarget() const { return physical_; }
  /// Number of that switch, from 1, in the study's order.
  std::size_t physicalNumber() const { return trial_->choices[trial_->target] + 1; }

  /// Returns true if there is an X to be felt.
  bool hasX() const { return asksForX(study_->design.kind) && !physical_; }
  /// Index of the stimulus X, which follows the choices.
  std::size_t slotOfX() const { return trial_->choices.size(); }
  std::size_t buttonIn(std::size_t slot) const {
    return feltButtons(study_->design, *trial_)[slot == slotOfX() ? trial_->target : slot];
  }

  /// Records that this stimulus is under the finger now.
  void tried(std::size_t slot, double now_s);
  /// Records the finger's movements with the stimulus under it, since tried() or the last call.
  void felt(const Felt& more);
  const Felt& feltOf(std::size_t slot) const { return felt_[slot]; }

  /// Returns true if an answer is allowed: every stimulus was felt (see feltEnough).
  bool mayAnswer() const { return feltEnough(*study_, asFelt()); }
  /// The finished answer. Only while mayAnswer().
  Answer answer(std::size_t choice, double now_s) const;

 private:
  Answer asFelt() const;

  const Study* study_;
  const Trial* trial_;
  bool physical_;
  double began_s_, shown_s_, firstPress_s_ = -1;
  std::vector<std::size_t> tries_;  ///< by slot
  std::vector<Felt> felt_;          ///< by slot
  std::size_t underFinger_ = 0;
};

}  // namespace detent::playback
