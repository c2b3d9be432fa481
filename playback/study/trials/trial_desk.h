// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One trial as it is worked on: what was tried, how often, how long, and whether it may be answered. The same
// for a terminal and a window. Times come from the caller's steady clock. One thread.

#include "playback/study/trials/participant_record.h"

namespace detent::playback {

class TrialDesk {
 public:
  /// The trial is shown at `now_s`; the stretch of work began at `began_s`.
  TrialDesk(const Study& study, const Trial& trial, double began_s, double now_s);

  const Trial& trial() const { return *trial_; }
  /// X is a real switch: it is handed over, not played.
  bool physicalTarget() const { return physical_; }
  /// Number of that switch, from 1, in the study's order.
  std::size_t physicalNumber() const { return trial_->choices[trial_->target] + 1; }

  void triedChoice(std::size_t choice, double now_s);
  void triedX(double now_s);
  std::size_t triesOf(std::size_t choice) const { return replays_[choice]; }
  std::size_t triesOfX() const { return replaysX_; }

  /// Nothing may be answered unfelt: X once, and in abx both choices, in matching at least one.
  bool mayAnswer() const;
  /// The finished answer. Only while mayAnswer().
  Answer answer(std::size_t choice, double now_s) const;

 private:
  void tried(double now_s);

  const Trial* trial_;
  bool abx_, physical_;
  double began_s_, shown_s_, firstPress_s_ = -1;
  std::vector<std::size_t> replays_;
  std::size_t replaysX_ = 0;
};

}  // namespace detent::playback
