// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/timing_controller.h"

#include <algorithm>

#include "model/check.h"

namespace detent::playback {

namespace {

constexpr double lead_s = 0.5;    // silence before anything moves or sounds
constexpr int beatsOfCue = 4;     // three beats to learn the interval, and the cue
constexpr double settle_s = 0.5;  // after the press, for the finger to come up
/// Presses closer than this are not made by a finger: a held key repeats every 30 to 40 ms on most systems,
/// and even two alternating fingers are slower than 50 ms.
constexpr double closest_s = 0.05;
constexpr std::size_t closeInRow = 3;

}  // namespace

const char* nameOf(TimingFault fault) {
  switch (fault) {
    case TimingFault::none:
      return "none";
    case TimingFault::noPress:
      return "no press";
    case TimingFault::held:
      return "key held";
    case TimingFault::notFelt:
      break;
  }
  return "not felt";
}

TimingController::TimingController(const Study& study, const Trial& trial, double began_s, double now_s)
    : study_(&study), trial_(&trial), began_s_(began_s), shown_s_(now_s) {
  const double first_s = now_s + lead_s;
  if (study.design.task == TimingTask::cue)
    for (int beat = 0; beat < beatsOfCue; ++beat) beats_s_.push_back(first_s + beat * trial.interval_s);
  if (study.design.task == TimingTask::window) beats_s_.push_back(first_s + trial.interval_s);
}

void TimingController::pressed(double at_s, double within_s) {
  if (!presses_s_.empty() && at_s <= presses_s_.back()) return;
  presses_s_.push_back(at_s);
  within_s_ = std::max(within_s_, within_s);
}

double TimingController::left_s(double now_s) const {
  const double run_s = study_->design.run_s;
  return presses_s_.empty() ? run_s : std::max(0.0, presses_s_.front() + run_s - now_s);
}

double TimingController::zero_s() const {
  if (!isTapping()) return cue_s();
  return presses_s_.empty() ? shown_s_ : presses_s_.front();
}

std::vector<double> TimingController::counted() const {
  std::vector<double> presses;
  for (const double at_s : presses_s_)
    if (!isTapping() || at_s - zero_s() <= study_->design.run_s) presses.push_back(at_s - zero_s());
  return presses;
}

bool TimingController::over(double now_s) const {
  if (isTapping()) return !presses_s_.empty() && left_s(now_s) <= 0 && now_s >= presses_s_.back() + settle_s;
  if (presses_s_.empty() || !countedPress(*trial_, counted())) return now_s >= cue_s() + trial_->interval_s;
  return now_s >= std::max(cue_s() + trial_->window_s, presses_s_.back()) + settle_s;
}

TimingFault TimingController::fault() const {
  const std::vector<double> presses = counted();
  if (isTapping() ? presses.size() < 2 : !countedPress(*trial_, presses)) return TimingFault::noPress;
  std::size_t close = 0;
  for (std::size_t i = 1; i < presses.size(); ++i) {
    close = presses[i] - presses[i - 1] < closest_s ? close + 1 : 0;
    if (close >= closeInRow) return TimingFault::held;
  }
  return felt_.presses == 0 ? TimingFault::notFelt : TimingFault::none;
}

Answer TimingController::answer(double now_s) const {
  DETENT_CHECK(fault() == TimingFault::none, "answered only what was pressed and felt");
  Answer answer;
  answer.trial = trial_->number;
  answer.presses_s = counted();
  answer.pressWithin_s = within_s_;
  answer.replays = {answer.presses_s.size()};
  answer.felt = {felt_};
  answer.onset_s = shown_s_ - began_s_;
  answer.firstPress_s = presses_s_.front() - shown_s_;
  answer.answer_s = now_s - shown_s_;
  return answer;
}

}  // namespace detent::playback
