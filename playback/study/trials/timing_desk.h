// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One timed trial as it is worked on: when its cue comes, which presses count, when it is over. The same for
// a terminal, a window and a simulation. Every time comes from the caller's steady clock. One thread.

#include <cstdint>
#include <vector>

#include "playback/study/trials/participant_record.h"

namespace detent::playback {

/// The reason why a trial has to begin again.
enum class TimingFault : std::uint8_t {
  none,
  noPress,  ///< none that counts; tapping: fewer than two
  /// presses so close upon another that no finger made them: a key that repeats, a contact that chatters
  held,
  notFelt  ///< the button under the finger was not pressed
};
/// Name in the journal: "no press".
const char* nameOf(TimingFault fault);

class TimingDesk {
 public:
  /// The trial is shown at `now_s`; the stretch of work began at `began_s`.
  TimingDesk(const Study& study, const Trial& trial, double began_s, double now_s);

  const Trial& trial() const { return *trial_; }
  /// Cue: four beats an interval apart, the last of them is the cue. Window: one, at which the target has
  /// come to its window. Tapping: none.
  const std::vector<double>& beats_s() const { return beats_s_; }
  /// Cue, window: the last beat.
  double cue_s() const { return beats_s_.back(); }
  /// Window: the target's way, 0 where it sets out an interval before the window, 1 where the window begins.
  double wayAt(double time_s) const { return 1 + (time_s - cue_s()) / trial_->interval_s; }

  /// A press was made at `at_s`; the readings it rests on lay `within_s` apart. In order.
  void pressed(double at_s, double within_s);
  /// The finger's movements with the button since the last call.
  void felt(const Felt& more) { felt_.add(more); }
  /// Seconds of a run that are left; tapping, from the first press on.
  double left_s(double now_s) const;

  /// Returns true if nothing that comes now counts any more.
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
