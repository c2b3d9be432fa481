// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/timed_run.h"

#include <algorithm>

#include "model/check.h"

namespace detent::playback {

namespace {

constexpr double feelWithin_s = 1;  // time for a key's simulated finger to complete its press

const Trial& nextOf(const ParticipantSession& session) {
  DETENT_CHECK(session.trial() != nullptr, "a trial that comes next");
  return *session.trial();
}

}  // namespace

TimedRun::TimedRun(const Study& study, ParticipantSession& session, StudyPlayer& player, double began_s)
    : study_(study),
      session_(session),
      player_(player),
      trial_(nextOf(session)),
      shown_s_(player.clock_s()),
      controller_(study, trial_, began_s, shown_s_) {
  player_.beginTrial();
  player_.place(0, trial_.choices[0], trial_.mode);
  player_.takeTrouble();
  sound();
}

/// Plays the whole count-in as one sound, so that its beats are exact to the sample.
void TimedRun::sound() {
  if (study_.design.task != TimingTask::cue) return;
  std::vector<double> delays_s;
  const double from_s = player_.clock_s();
  for (const double beat_s : controller_.beats_s()) delays_s.push_back(std::max(0.0, beat_s - from_s));
  player_.soundBeats(delays_s);
}

void TimedRun::pressed(double at_s, double within_s) {
  if (player_.sensed() || at_s < shown_s_) return;
  controller_.felt(player_.takeFelt());
  controller_.pressed(at_s, within_s);
  player_.press(0, trial_.choices[0], trial_.mode);
}

Result<TimedOutcome> TimedRun::update() {
  TimedOutcome outcome;
  outcome.trouble = player_.takeTrouble();
  if (outcome.trouble != StudyTrouble::none) {
    outcome.state = TimedState::lost;
    return again(nameOf(outcome.trouble), outcome);
  }
  controller_.felt(player_.takeFelt());
  if (player_.sensed()) {
    for (const ContactClosing& c : player_.takeClosings())
      if (c.time_s >= shown_s_) controller_.pressed(c.time_s, c.within_s);
  }
  const double now_s = player_.clock_s();
  if (!controller_.over(now_s)) return outcome;
  if (!over_s_) over_s_ = now_s;
  // The simulated finger of a key is still moving.
  if (controller_.fault() == TimingFault::notFelt && now_s < *over_s_ + feelWithin_s) return outcome;
  return finish(now_s);
}

Result<TimedOutcome> TimedRun::finish(double now_s) {
  TimedOutcome outcome;
  outcome.state = TimedState::anew;
  outcome.fault = controller_.fault();
  if (outcome.fault != TimingFault::none) return again(nameOf(outcome.fault), outcome);
  const Answer answer = controller_.answer(now_s);
  if (Result<Done> kept = session_.record(answer); !kept) {
    outcome.failure = kept.failure();
    return again("not kept", outcome);
  }
  outcome.state = TimedState::kept;
  if (study_.design.task == TimingTask::window) {
    const double press_s = *countedPress(trial_, answer.presses_s);
    outcome.hit = press_s >= 0 && press_s < trial_.window_s;
  }
  return outcome;
}

Result<TimedOutcome> TimedRun::again(const std::string& reason, TimedOutcome outcome) {
  if (Result<Done> ok = session_.interrupted(reason); !ok) return ok.failure();
  return outcome;
}

}  // namespace detent::playback
