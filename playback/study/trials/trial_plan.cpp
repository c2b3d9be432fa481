// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/trial_plan.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "playback/study/statistics/shuffle.h"

namespace detent::playback {

namespace {

using Pair = std::pair<std::size_t, std::size_t>;

// K&L, Table 1: 8.4 s per trial, so a rest every seven minutes
constexpr std::size_t trialsBetweenBreaks = 50;

/// Half true and half false in random order; for an odd number the last one is random.
std::vector<bool> balanced(std::size_t count, StudyRandom& random) {
  std::vector<char> sides;
  for (std::size_t i = 0; i + 1 < count; i += 2) sides.insert(sides.end(), {0, 1});
  if (sides.size() < count) sides.push_back(static_cast<char>(drawBelow(random, 2)));
  shuffle(sides, random);
  return {sides.begin(), sides.end()};
}

/// Arrangement of one trial of a pair: which button is alpha, and the side of X.
struct PlanCell {
  bool swapped = false;    ///< the pair's second button is alpha
  bool secondIsX = false;  ///< X is the pair's second button
  std::size_t side() const { return swapped == secondIsX ? 0 : 1; }
};

/// Uses the four arrangements equally often. If one trial remains, its arrangement is random; if three
/// remain, they are different. Two remaining trials have another alpha and another X each, with X on the side
/// that `toTheRight` states.
std::vector<PlanCell> fourCells(std::size_t count, bool toTheRight, StudyRandom& random) {
  constexpr std::array<PlanCell, 4> all{
      {{false, false}, {true, true}, {false, true}, {true, false}}};  // X on the left, left, right, right
  std::vector<PlanCell> cells;
  for (std::size_t i = 0; i + 4 <= count; i += 4) cells.insert(cells.end(), all.begin(), all.end());
  std::vector<PlanCell> rest(all.begin(), all.end());
  if (count % 4 == 2) {
    rest = toTheRight ? std::vector<PlanCell>{all[2], all[3]} : std::vector<PlanCell>{all[0], all[1]};
  } else {
    shuffle(rest, random);
  }
  cells.insert(cells.end(), rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(count % 4));
  shuffle(cells, random);
  return cells;
}

/// Arrangement in studies of version 1: sides balanced, X random.
std::vector<PlanCell> balancedSides(std::size_t count, StudyRandom& random) {
  const std::vector<bool> swapped = balanced(count, random), right = balanced(count, random);
  std::vector<PlanCell> cells;
  for (std::size_t i = 0; i < count; ++i) cells.push_back({swapped[i], swapped[i] != right[i]});
  return cells;
}

/// Pairs of this participant: the next ones in a list that all participants go through in turn.
std::vector<Pair> pairsFor(const Study& study, std::size_t place, StudyRandom& random) {
  std::vector<Pair> pairs = pairsOf(study.buttons.size());
  const std::size_t each = study.design.pairsEach;
  if (each == 0) return pairs;
  if (study.version == 1) {
    shuffle(pairs, random);
    pairs.resize(each);
    return pairs;
  }
  StudyRandom everyones = randomSeededBy(std::to_string(study.design.seed) + ":pairs");
  shuffle(pairs, everyones);
  std::rotate(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(place * each % pairs.size()),
              pairs.end());
  pairs.resize(each);
  return pairs;
}

std::vector<Trial> abxTrials(const Study& study, const std::vector<Pair>& pairs, FeedbackMode mode,
                             StudyRandom& random) {
  std::vector<Trial> trials;
  bool toTheRight = study.version > 1 && drawBelow(random, 2) == 1;
  for (const auto& [first, second] : pairs) {
    const std::vector<PlanCell> cells = study.version == 1
                                            ? balancedSides(study.design.trials, random)
                                            : fourCells(study.design.trials, toTheRight, random);
    toTheRight = !toTheRight;
    for (const PlanCell& cell : cells) {
      Trial trial;
      trial.mode = mode;
      trial.choices = cell.swapped ? std::vector{second, first} : std::vector{first, second};
      trial.target = cell.side();
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

std::vector<Trial> matchingTrials(const Study& study, FeedbackMode mode, StudyRandom& random) {
  std::vector<std::size_t> all(study.buttons.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < study.design.trials * all.size(); ++i) {
    Trial trial;
    trial.mode = mode;
    trial.choices = all;
    shuffle(trial.choices, random);
    const auto at = std::find(trial.choices.begin(), trial.choices.end(), i % all.size());
    trial.target = static_cast<std::size_t>(at - trial.choices.begin());
    trials.push_back(std::move(trial));
  }
  return trials;
}

std::vector<Trial> thresholdTrials(const Study& study, FeedbackMode mode, StudyRandom& random) {
  std::vector<Trial> trials;
  for (std::size_t reference = 0; reference < study.givenButtons(); ++reference) {
    for (const bool second : balanced(study.design.trials, random)) {
      Trial trial;
      trial.mode = mode;
      trial.choices = {reference, reference};
      trial.target = second ? 1 : 0;
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

/// The items to be rated: buttons, or pairs of them.
std::vector<std::vector<std::size_t>> ratedThings(const Study& study, const std::vector<Pair>& pairs) {
  std::vector<std::vector<std::size_t>> things;
  if (study.design.scale == RatingScale::pairwise) {
    for (const auto& [first, second] : pairs) things.push_back({first, second});
  } else {
    for (std::size_t i = 0; i < study.buttons.size(); ++i) things.push_back({i});
  }
  return things;
}

/// Trials in rounds: all items once, in a new order each time.
std::vector<Trial> ratingTrials(const Study& study, const std::vector<Pair>& pairs, FeedbackMode mode,
                                StudyRandom& random) {
  const std::vector<std::vector<std::size_t>> things = ratedThings(study, pairs);
  std::vector<std::vector<bool>> turned;
  for (std::size_t i = 0; i < things.size(); ++i) turned.push_back(balanced(study.design.trials, random));
  std::vector<Trial> trials;
  std::vector<std::size_t> order(things.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t round = 0; round < study.design.trials; ++round) {
    shuffle(order, random);
    for (const std::size_t i : order) {
      Trial trial;
      trial.mode = mode;
      trial.choices = things[i];
      if (turned[i][round]) std::reverse(trial.choices.begin(), trial.choices.end());
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

/// Possible times of a trial: every window at every interval; none for tapping.
std::vector<std::pair<double, double>> timesOf(const StudyDesign& d) {
  if (d.task == TimingTask::tapping) return {{0, 0}};
  std::vector<std::pair<double, double>> times;
  for (const double interval_s : d.intervals_s) {
    if (d.task == TimingTask::cue) times.emplace_back(interval_s, 0);
    if (d.task == TimingTask::window)
      for (const double window_s : d.windows_s) times.emplace_back(interval_s, window_s);
  }
  return times;
}

std::vector<Trial> timingTrials(const Study& study, FeedbackMode mode, StudyRandom& random) {
  std::vector<Trial> trials;
  std::vector<std::pair<double, double>> times = timesOf(study.design);
  for (std::size_t button = 0; button < study.givenButtons(); ++button) {
    for (std::size_t i = 0; i < study.design.trials; ++i) {
      if (i % times.size() == 0) shuffle(times, random);  // the remaining trials get random times
      Trial trial;
      trial.mode = mode;
      trial.choices = {button};
      std::tie(trial.interval_s, trial.window_s) = times[i % times.size()];
      trials.push_back(std::move(trial));
    }
  }
  return trials;
}

std::vector<Trial> trialsOf(const Study& study, const std::vector<Pair>& pairs, FeedbackMode mode,
                            StudyRandom& random) {
  switch (study.design.kind) {
    case StudyKind::abx:
    case StudyKind::sameDifferent:
      break;
    case StudyKind::matching:
      return matchingTrials(study, mode, random);
    case StudyKind::threshold:
      return thresholdTrials(study, mode, random);
    case StudyKind::rating:
      return ratingTrials(study, pairs, mode, random);
    case StudyKind::timing:
      return timingTrials(study, mode, random);
  }
  return abxTrials(study, pairs, mode, random);
}

/// Order of the modes, so that each is equally often first, second and last as far as the number of people
/// allows: rotated from one person to the next, then the same backwards.
std::vector<FeedbackMode> modesInTurn(const Study& study, std::size_t place) {
  std::vector<FeedbackMode> modes = study.design.modes;
  if (study.version == 1) return modes;
  std::rotate(modes.begin(), modes.begin() + static_cast<std::ptrdiff_t>(place % modes.size()), modes.end());
  if (place / modes.size() % 2 == 1) std::reverse(modes.begin(), modes.end());
  return modes;
}

/// Adds shuffled trials, with a rest at the beginning of a block and within long ones.
void addBlock(const Study& study, std::vector<Trial> block, StudyRandom& random, std::vector<Trial>& trials) {
  if (study.version > 1) {
    if (study.design.kind != StudyKind::rating) shuffle(block, random);
    for (std::size_t i = 0; i < block.size(); ++i)
      block[i].breakBefore = i % trialsBetweenBreaks == 0 && (i > 0 || !trials.empty());
  }
  trials.insert(trials.end(), block.begin(), block.end());
}

}  // namespace

std::vector<std::size_t> feltButtons(const StudyDesign& design, const Trial& trial) {
  if (design.kind != StudyKind::sameDifferent || trial.target == 1) return trial.choices;
  return {trial.choices[0], trial.choices[0]};
}

std::string answerName(const Study& study, const Trial& trial, std::size_t choice) {
  if (study.design.kind == StudyKind::sameDifferent) return choice == 0 ? "same" : "different";
  return study.buttons[trial.choices[choice]].label;
}

std::size_t countedTrials(const Study& study) {
  const StudyDesign& d = study.design;
  const std::size_t buttons = study.givenButtons(), pairs = buttons * (buttons - 1) / 2;
  const std::size_t cells = !asksForPairs(d) ? buttons : d.pairsEach > 0 ? d.pairsEach : pairs;
  return cells * d.trials * d.modes.size();
}

std::vector<Trial> planTrials(const Study& study, const std::string& participant, std::size_t place) {
  StudyRandom random = randomSeededBy(std::to_string(study.design.seed) + ":" + participant);
  std::vector<Pair> pairs;
  if (asksForPairs(study.design)) pairs = pairsFor(study, place, random);
  std::vector<Trial> counted;
  for (const FeedbackMode mode : modesInTurn(study, place))
    addBlock(study, trialsOf(study, pairs, mode, random), random, counted);
  if (study.version == 1) shuffle(counted, random);
  std::vector<Trial> plan;
  for (std::size_t i = 0; i < study.design.practice; ++i) {
    plan.push_back(counted[drawBelow(random, counted.size())]);
    plan.back().practice = true;
    plan.back().breakBefore = false;
  }
  plan.insert(plan.end(), counted.begin(), counted.end());
  for (std::size_t i = 0; i < plan.size(); ++i) plan[i].number = i + 1;
  return plan;
}

}  // namespace detent::playback
