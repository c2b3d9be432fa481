// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/trial_controller.h"

#include "model/check.h"

namespace detent::playback {

TrialController::TrialController(const Study& study, const Trial& trial, double began_s, double now_s)
    : study_(&study),
      trial_(&trial),
      physical_(study.design.targets == TargetKind::physicalButton),
      began_s_(began_s),
      shown_s_(now_s),
      tries_(trial.choices.size() + 1, 0),
      felt_(trial.choices.size() + 1),
      underFinger_(tries_.size()) {}

void TrialController::tried(std::size_t slot, double now_s) {
  DETENT_CHECK(slot < tries_.size(), "a choice of the trial, or X");
  ++tries_[slot];
  underFinger_ = slot;
  if (firstPress_s_ < 0) firstPress_s_ = now_s - shown_s_;
}

void TrialController::felt(const Felt& more) {
  if (underFinger_ < felt_.size()) felt_[underFinger_].add(more);
}

Answer TrialController::asFelt() const {
  Answer answer;
  answer.felt.assign(felt_.begin(), felt_.end() - 1);
  answer.feltX = felt_.back();
  return answer;
}

Answer TrialController::answer(std::size_t choice, double now_s) const {
  DETENT_CHECK(mayAnswer() && choice < trial_->choices.size(), "answered only what was felt");
  Answer answer = asFelt();
  answer.trial = trial_->number;
  answer.choice = choice;
  answer.replays.assign(tries_.begin(), tries_.end() - 1);
  answer.replaysX = tries_.back();
  answer.onset_s = shown_s_ - began_s_;
  answer.firstPress_s = firstPress_s_;
  answer.answer_s = now_s - shown_s_;
  return answer;
}

}  // namespace detent::playback
