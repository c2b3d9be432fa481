// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One timed trial at a terminal: beats or a moving target, presses by the space bar, the sensor or the force
// device.

#include "playback/device/terminal.h"
#include "playback/program/command.h"
#include "playback/study.h"
#include "playback/study/trials/participant_words.h"

namespace detent::playback {

/// Outcome of a trial at a terminal.
enum class TrialEnd : std::uint8_t {
  answered,
  again,  ///< it begins anew; said and in the journal
  paused,
  stopping  ///< the participant wants to stop for good
};

/// Objects that a timed trial needs.
struct TimedDesk {
  const Study& study;
  ParticipantSession& session;
  StudyPlayer& player;
  RawTerminal& terminal;
  const ParticipantWords& words;
  const Cancelled& cancelled;
  double began_s = 0;  ///< of this stretch of work
};

inline constexpr char escapeKey = 27;

/// Waits until nothing is wrong any more; the key a arms a force device that was stopped.
void awaitDevice(StudyPlayer& player, RawTerminal& terminal, const ParticipantWords& words,
                 StudyTrouble trouble, const Cancelled& cancelled);

/// Shows the trial that comes next and keeps what was pressed. Failure: of the journal.
Result<TrialEnd> askTimed(const TimedDesk& desk);

}  // namespace detent::playback
