// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/trial_desk.h"

#include <algorithm>

#include "model/check.h"

namespace detent::playback {

TrialDesk::TrialDesk(const Study& study, const Trial& trial, double began_s, double now_s)
    : trial_(&trial),
      abx_(study.design.kind == StudyKind::abx),
      physical_(study.design.targets == TargetKind::physicalButton),
      began_s_(began_s),
      shown_s_(now_s),
      replays_(trial.choices.size(), 0) {}

void TrialDesk::tried(double now_s) {
  if (firstPress_s_ < 0) firstPress_s_ = now_s - shown_s_;
}

void TrialDesk::triedChoice(std::size_t choice, double now_s) {
  DETENT_CHECK(choice < replays_.size(), "a choice of the trial");
  ++replays_[choice];
  tried(now_s);
}

void TrialDesk::triedX(double now_s) {
  ++replaysX_;
  tried(now_s);
}

bool TrialDesk::mayAnswer() const {
  const auto felt = [](std::size_t times) { return times > 0; };
  if (!physical_ && replaysX_ == 0) return false;
  return abx_ ? std::all_of(replays_.begin(), replays_.end(), felt)
              : std::any_of(replays_.begin(), replays_.end(), felt);
}

Answer TrialDesk::answer(std::size_t choice, double now_s) const {
  DETENT_CHECK(mayAnswer() && choice < replays_.size(), "answered only what was felt");
  Answer answer;
  answer.trial = trial_->number;
  answer.choice = choice;
  answer.replays = replays_;
  answer.replaysX = replaysX_;
  answer.onset_s = shown_s_ - began_s_;
  answer.firstPress_s = firstPress_s_;
  answer.answer_s = now_s - shown_s_;
  return answer;
}

}  // namespace detent::playback
