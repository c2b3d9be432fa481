// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One timed trial from its first sight to the journal, whatever shows it and whatever presses: a terminal, a
// window; keys, a pad, a sensor.

#include <optional>

#include "playback/study/study_player.h"
#include "playback/study/trials/participant_session.h"
#include "playback/study/trials/timing_desk.h"

namespace detent::playback {

/// Progress of a timed trial.
enum class TimedState : std::uint8_t {
  running,
  kept,  ///< the answer is on the disk
  lost,  ///< a device: it begins anew, and the journal says why
  anew   ///< likewise, for what the participant did, or because the answer could not be kept
};
struct TimedOutcome {
  TimedState state = TimedState::running;
  bool hit = false;                               ///< kept, window: the window was hit
  StudyTrouble trouble = StudyTrouble::none;      ///< lost
  TimingFault fault = TimingFault::none;          ///< anew; none: see failure
  std::optional<Failure> failure = std::nullopt;  ///< why it could not be kept
};

/// Owns the trial that comes next until it has ended. One thread.
class TimedRun {
 public:
  /// Shows it now: the button is under the finger, and a cue's beats are on their way. `began_s`: this
  /// stretch of work, on the player's clock. All must outlive it.
  TimedRun(const Study& study, ParticipantSession& session, StudyPlayer& player, double began_s);
  TimedRun(const TimedRun&) = delete;
  TimedRun& operator=(const TimedRun&) = delete;

  const Trial& trial() const { return trial_; }
  const TimingDesk& desk() const { return desk_; }

  /// A key or a pad went down: presses, unless a sensor does, or it was before the trial. See
  /// TimingDesk::pressed.
  void pressed(double at_s, double within_s);
  /// Takes the finger's movements. To be called every 10 ms or so until it is no longer running. Failure: of
  /// the journal.
  Result<TimedOutcome> look();

 private:
  void sound();
  Result<TimedOutcome> finish(double now_s);
  Result<TimedOutcome> again(const std::string& reason, TimedOutcome outcome);

  const Study& study_;
  ParticipantSession& session_;
  StudyPlayer& player_;
  const Trial trial_;  // the session's goes on with it
  const double shown_s_;
  TimingDesk desk_;
  std::optional<double> over_s_;
};

}  // namespace detent::playback
