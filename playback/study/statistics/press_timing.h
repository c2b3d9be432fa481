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
  window,  ///< press while a target stands in its window
  tapping  ///< press as fast as can be kept up
};
inline constexpr auto timingTasks = named<TimingTask>(
    {{"cue", TimingTask::cue}, {"window", TimingTask::window}, {"tapping", TimingTask::tapping}});
inline const char* nameOf(TimingTask task) { return timingTasks.word(task); }

/// One trial of one person.
struct TimedPress {
  double interval_s = 0;  ///< cue, window: how long before it was known when it would come; > 0
  double window_s = 0;    ///< window: how long it stood; > 0
  /// cue: behind the cue, window: behind the window's beginning, negative before it; tapping: behind the
  /// press before, > 0. None: no press.
  std::optional<double> press_s;
};

/// The fitted figures. `place`, cue: mean press behind the cue as a share of the interval; window: the aim
/// within the window, as a share of the window; tapping: seconds between presses. `spread`: standard
/// deviation about that as a share of the interval; of tapping as a share of the time between presses.
struct PressTiming {
  double place = 0, spread = 0;
};

/// One person. Beside the two figures two nuisances are fitted that are theirs alone: a drift over the trials
/// and a share of presses that belong to nothing (lapses, spread evenly over an interval to either side).
struct PersonTiming {
  std::size_t trials = 0, presses = 0;
  PressTiming timing;
  /// from the first trial to the last, in the unit of `place` times interval (tapping: of the logarithm)
  double drift = 0;
  double lapses = 0;  ///< share of the presses
};

/// Fewer presses than this say nothing of a person's spread.
inline constexpr std::size_t leastPresses = 10;
inline constexpr std::size_t fewestForInterval = 3;  ///< people: two say too little of how people scatter

/// Fits one person. Empty for fewer than leastPresses presses, or if they do not differ at all. Values within
/// the ranges above (checked).
std::optional<PersonTiming> timingOf(TimingTask task, const std::vector<TimedPress>& trials);

/// A laboratory: the mean place and the geometric mean of the spreads over its people (of tapping geometric
/// means both), each person counting alike, with Student's intervals over people; none for fewer than three.
struct LaboratoryTiming {
  PressTiming timing;
  std::optional<Interval> place, spread;
};
/// `people` is not empty (checked). `confidence` in (0, 1).
LaboratoryTiming timingOver(TimingTask task, const std::vector<PersonTiming>& people,
                            double confidence = 0.95);

}  // namespace detent::playback
