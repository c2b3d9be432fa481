// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One timed trial from its start to the journal, for any display and any source of presses: terminal or
// window; keys, pad or sensor.

#include <optional>

#include "playback/study/study_player.h"
#include "playback/study/trials/participant_session.h"
#include "playback/study/trials/timing_controller.h"

namespace detent::playback {

/// Progress of a timed trial.
enum class TimedState : std::uint8_t {
  running,
  kept,  ///< the answer is on disk
  lost,  ///< a device was lost: the trial is repeated, and the journal states the reason
  /// the trial is repeated because of what the participant did, or because the answer could not be stored
  anew
};
struct TimedOutcome {
  TimedState state = TimedState::running;
  bool hit = false;                               ///< with `kept`, window task: the window was hit
  StudyTrouble trouble = StudyTrouble::none;      ///< with `lost`
  TimingFault fault = TimingFault::none;          ///< with `anew`; none: see `failure`
  std::optional<Failure> failure = std::nullopt;  ///< the reason why the answer could not be stored
};

/// Runs the next trial until it has ended. One thread.
class TimedRun {
 public:
  /// Starts the trial now: the button is under the finger, and a cue's beats are scheduled. `began_s`: start
  /// of this stretch of work, on the player's clock. All arguments must outlive it.
  TimedRun(const Study& study, ParticipantSession& session, StudyPlayer& player, double began_s);
  TimedRun(const TimedRun&) = delete;
  TimedRun& operator=(const TimedRun&) = delete;

  const Trial& trial() const { return trial_; }
  const TimingController& controller() const { return controller_; }

  /// A key or a pad went down: presses, unless a sensor does, or it was before the trial. See
  /// TimingController::pressed.
  void pressed(double at_s, double within_s);
  /// Takes the finger's movements. Call it about every 10 ms until the trial is no longer running. Failure:
  /// of the journal.
  Result<TimedOutcome> update();

 private:
  void sound();
  Result<TimedOutcome> finish(double now_s);
  Result<TimedOutcome> again(const std::string& reason, TimedOutcome outcome);

  const Study& study_;
  ParticipantSession& session_;
  StudyPlayer& player_;
  const Trial trial_;  // a copy, because the session moves on to the next trial
  const double shown_s_;
  TimingController controller_;
  std::optional<double> over_s_;
};

}  // namespace detent::playback
