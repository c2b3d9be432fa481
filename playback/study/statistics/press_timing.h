// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Accuracy of people's timed presses: two figures for each person and for a laboratory. Deterministic; any
// thread.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/named_values.h"
#include "playback/study/statistics/binomial.h"

namespace detent::playback {

/// The participants' task.
enum class TimingTask : std::uint8_t {
  cue,     ///< press with the cue
  window,  ///< press while a target is in its window
  tapping  ///< press as fast as one can sustain
};
inline constexpr auto timingTasks = named<TimingTask>(
    {{"cue", TimingTask::cue}, {"window", TimingTask::window}, {"tapping", TimingTask::tapping}});
inline const char* nameOf(TimingTask task) { return timingTasks.word(task); }

/// One trial of one person.
struct TimedPress {
  double interval_s = 0;  ///< cue, window: time by which the cue is known in advance; > 0
  double window_s = 0;    ///< window: its duration; > 0
  /// cue: time after the cue; window: after the window's beginning, negative before it; tapping: after the
  /// previous press, > 0. None: no press.
  std::optional<double> press_s;
};

/// The fitted figures. `place`: for cue, mean delay of the press as a share of the interval; for window, the
/// aim as a share of the window; for tapping, seconds between presses. `spread`: standard deviation around
/// that, as a share of the interval; for tapping, as a share of the time between presses.
struct PressTiming {
  double place = 0, spread = 0;
};

/// One person. Besides the two figures, two nuisance parameters are fitted: a drift over the trials, and a
/// share of presses unrelated to the task (lapses, distributed evenly over an interval to either side).
struct PersonTiming {
  std::size_t trials = 0, presses = 0;
  PressTiming timing;
  /// change from the first trial to the last, in the unit of `place` times interval (tapping: of the
  /// logarithm)
  double drift = 0;
  double lapses = 0;  ///< share of the presses
};

/// With fewer presses, a person's spread cannot be estimated.
inline constexpr std::size_t leastPresses = 10;
/// people: with two, the scatter between people is unknown
inline constexpr std::size_t fewestForInterval = 3;

/// Fits one person. Empty for fewer than leastPresses presses, or if they are all equal. Values must be
/// within the ranges above (checked).
std::optional<PersonTiming> timingOf(TimingTask task, const std::vector<TimedPress>& trials);

/// A laboratory: the mean place and the geometric mean of the spreads of its people (for tapping, geometric
/// means of both), with equal weights, and Student's intervals over people; none for fewer than three.
struct LaboratoryTiming {
  PressTiming timing;
  std::optional<Interval> place, spread;
};
/// `people` is not empty (checked). `confidence` in (0, 1).
LaboratoryTiming timingOver(TimingTask task, const std::vector<PersonTiming>& people,
                            double confidence = 0.95);

}  // namespace detent::playback
