// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/trial_plan.h"

#include <algorithm>
#include <numeric>

#include "playback/study/statistics/shuffle.h"

namespace detent::playback {

namespace {

using Pair = std::pair<std::size_t, std::size_t>;

/// Half true, half false, in a random order; of an odd number the last one by chance.
std::vector<bool> balanced(std::size_t count, StudyRandom& random) {
  std::vector<char> sides;
  for (std::size_t i = 0; i + 1 < count; i += 2) sides.insert(sides.end(), {0, 1});
  if (sides.size() < count) sides.push_back(static_cast<char>(drawBelow(random, 2)));
  shuffle(sides, random);
  return {sides.begin(), sides.end()};
}

std::vector<Pair> pairsFor(const Study& study, StudyRandom& random) {
  std::vector<Pair> pairs = pairsOf(study.buttons.size());
  if (study.design.pairsEach == 0) return pairs;
  shuffle(pairs, random);
  pairs.resize(study.design.pairsEach);
  return pairs;
}

void addAbx(const Study& study, StudyRandom& random, std::vector<Trial>& trials) {
  const std::vector<Pair> pairs = pairsFor(study, random);
  for (const FeedbackMode mode : study.design.modes) {
    for (const auto& [first, second] : pairs) {
      const std::vector<bool> swapped = balanced(study.design.trials, random);
      const std::vector<bool> second_is_x = balanced(study.design.trials, random);
      for (std::size_t i = 0; i < study.design.trials; ++i) {
        Trial trial;
        trial.mode = mode;
        trial.choices = swapped[i] ? std::vector{second, first} : std::vector{first, second};
        trial.target = second_is_x[i] ? 1 : 0;
        trials.push_back(std::move(trial));
      }
    }
  }
}

void addMatching(const Study& study, StudyRandom& random, std::vector<Trial>& trials) {
  std::vector<std::size_t> all(study.buttons.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const FeedbackMode mode : study.design.modes) {
    for (std::size_t i = 0; i < study.design.trials * all.size(); ++i) {
      Trial trial;
      trial.mode = mode;
      trial.choices = all;
      shuffle(trial.choices, random);
      const auto at = std::find(trial.choices.begin(), trial.choices.end(), i % all.size());
      trial.target = static_cast<std::size_t>(at - trial.choices.begin());
      trials.push_back(std::move(trial));
    }
  }
}

}  // namespace

std::size_t countedTrials(const Study& study) {
  const StudyDesign& d = study.design;
  const std::size_t buttons = study.buttons.size(), pairs = buttons * (buttons - 1) / 2;
  const std::size_t cells = d.kind == StudyKind::matching ? buttons : d.pairsEach > 0 ? d.pairsEach : pairs;
  return cells * d.trials * d.modes.size();
}

std::vector<Trial> planTrials(const Study& study, const std::string& participant) {
  StudyRandom random = randomSeededBy(std::to_string(study.design.seed) + ":" + participant);
  std::vector<Trial> counted;
  if (study.design.kind == StudyKind::abx) addAbx(study, random, counted);
  if (study.design.kind == StudyKind::matching) addMatching(study, random, counted);
  shuffle(counted, random);
  std::vector<Trial> plan;
  for (std::size_t i = 0; i < study.design.practice; ++i) {
    plan.push_back(counted[drawBelow(random, counted.size())]);
    plan.back().practice = true;
  }
  plan.insert(plan.end(), counted.begin(), counted.end());
  for (std::size_t i = 0; i < plan.size(); ++i) plan[i].number = i + 1;
  return plan;
}

}  // namespace detent::playback
