// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Controller of one timed trial: when its cue comes, which presses count, when it is over. The same for a
// terminal, a window and a simulation. All times are of the caller's steady clock. One thread.

#include <cstdint>
#include <vector>

#include "playback/study/trials/participant_record.h"

namespace detent::playback {

/// The reason why a trial has to begin again.
enum class TimingFault : std::uint8_t {
  none,
  noPress,  ///< no press that counts; tapping: fewer than two
  /// presses in such fast succession that no finger made them: a repeating key, a bouncing contact
  held,
  notFelt  ///< the button under the finger was not pressed
};
/// Name in the journal: "no press".
const char* nameOf(TimingFault fault);

class TimingController {
 public:
  /// The trial is shown at `now_s`; the period of work began at `began_s`.
  TimingController(const Study& study, const Trial& trial, double began_s, double now_s);

  const Trial& trial() const { return *trial_; }
  /// Cue: four beats, one interval apart, of which the last is the cue. Window: one, when the target reaches
  /// its window. Tapping: none.
  const std::vector<double>& beats_s() const { return beats_s_; }
  /// Cue, window: the last beat.
  double cue_s() const { return beats_s_.back(); }
  /// Window: position of the target, 0 where it starts, one interval before the window, and 1 where the
  /// window begins.
  double wayAt(double time_s) const { return 1 + (time_s - cue_s()) / trial_->interval_s; }

  /// Records a press at `at_s`, measured between readings `within_s` apart. Calls in order of time.
  void pressed(double at_s, double within_s);
  /// Records the finger's movements with the button since the last call.
  void felt(const Felt& more) { felt_.add(more); }
  /// Remaining seconds of a run; for tapping counted from the first press.
  double left_s(double now_s) const;

  /// Returns true if further events do not count any more.
  bool over(double now_s) const;
  /// Fault of the trial, once it is over.
  TimingFault fault() const;
  /// The finished answer. Only without a fault (checked).
  Answer answer(double now_s) const;

 private:
  double zero_s() const;
  bool isTapping() const { return study_->design.task == TimingTask::tapping; }
  std::vector<double> counted() const;

  const Study* study_;
  const Trial* trial_;
  double began_s_, shown_s_;
  std::vector<double> beats_s_;
  std::vector<double> presses_s_;  ///< on the caller's clock
  double within_s_ = 0;
  Felt felt_;
};

}  // namespace detent::playback
