// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/targets/targets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "model/check.h"
#include "model/targets/bendable_state.h"
#include "model/validation.h"

namespace detent {
namespace {

constexpr int mostSteps = 40;
constexpr int stepsOnceMet = 3;      // towards the least cost, when the figures are right already
constexpr double difference = 1e-6;  // of an unknown, for slopes of figures
constexpr double settled = 1e-5;     // an unknown that moves by less has arrived
constexpr double exact = 1e-9;       // shares of travel and range: a figure that is nearer than this is met
constexpr double leastPart = 1.0 / 32;  // of the way to the targets that one step must be able to go
constexpr double leastStep = 1.0 / 256;

FigureUnit unitOf(KeyFigure figure) { return keyFigureNames()[static_cast<std::size_t>(figure)].unit; }
const char* termOf(KeyFigure figure) { return keyFigureNames()[static_cast<std::size_t>(figure)].term; }

// One solve: the unknowns of a state, and how far its figures are from the targets, in shares of travel and range.
class Search {
 public:
  Search(const ButtonState& state, const std::vector<FigureTarget>& targets, const TargetTolerance& tolerance,
         const SectionSettings& settings, BendableState::Bulges bulges)
      : bendable_(state, settings, bulges), targets_(targets), tolerance_(tolerance), settings_(settings) {}

  std::optional<ButtonState> found() {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(bendable_.unknowns());
    auto now = seen(z);
    int onceMet = 0;
    for (int step = 0; now && step < mostSteps; ++step) {
      const bool met = isMet(*now);
      if (met && onceMet++ >= stepsOnceMet) break;
      const auto goal = next(z, *now);
      if (!goal) break;
      const Eigen::VectorXd way = *goal - z;
      if (met && way.cwiseAbs().maxCoeff() < settled) break;
      auto better = stepAlong(z, way, *now, met);
      if (!better) break;
      now = std::move(better);
    }
    if (!now || !isMet(*now)) return {};
    return std::move(now->state);
  }

 private:
  struct Seen {
    ButtonState state;
    Eigen::VectorXd missing;  // target less figure
    Eigen::VectorXd gaps;     // in shares of the range
  };

  double scaleOf(FigureUnit unit) const {
    const double mm = bendable_.travel_mm(), N = bendable_.range_N();
    switch (unit) {
      case FigureUnit::mm:
        return mm;
      case FigureUnit::N:
        return N;
      case FigureUnit::N_per_mm:
        return N / mm;
      case FigureUnit::mJ:
        return N * mm;
      case FigureUnit::share:
        return 1;
    }
    return 1;
  }
  // As exact as the arithmetic lets it, up to a part of what is tolerated.
  double bound(FigureUnit unit) const {
    const double mm = tolerance_.length_mm / bendable_.travel_mm(),
                 N = tolerance_.force_N / bendable_.range_N();
    return std::max(exact, unit == FigureUnit::mm  ? 0.1 * mm
                           : unit == FigureUnit::N ? 0.1 * N
                                                   : 0.1 * std::min(mm, N));
  }

  std::optional<Seen> seen(const Eigen::VectorXd& z) const {
    auto state = bendable_.at(z);
    if (!state) return {};
    const KeyFigures figures = keyFiguresOf(*state, settings_);
    Eigen::VectorXd missing(static_cast<Eigen::Index>(targets_.size()));
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const auto& value = figures[targets_[i].figure];
      if (!value) return {};
      missing[static_cast<Eigen::Index>(i)] =
          (targets_[i].value - *value) / scaleOf(unitOf(targets_[i].figure));
    }
    Eigen::VectorXd gaps = bendable_.gaps(z, *state) / bendable_.range_N();
    return Seen{*std::move(state), std::move(missing), std::move(gaps)};
  }

  bool isMet(const Seen& seen) const {
    for (std::size_t i = 0; i < targets_.size(); ++i)
      if (!(std::abs(seen.missing[static_cast<Eigen::Index>(i)]) <= bound(unitOf(targets_[i].figure))))
        return false;
    return seen.gaps.size() == 0 || seen.gaps.minCoeff() > -1e-6;
  }

  // Where the figures, taken as straight, are right at the least cost; part of the way there where that is no curve.
  std::optional<Eigen::VectorXd> next(const Eigen::VectorXd& z, const Seen& now) const {
    const Eigen::Index figures = now.missing.size(), gaps = now.gaps.size();
    Eigen::MatrixXd slopes(figures + gaps, z.size());
    for (Eigen::Index k = 0; k < z.size(); ++k) {
      Eigen::VectorXd beside = z;
      double way = difference;
      beside[k] += way;
      auto there = seen(beside);
      if (!there) {
        way = -difference;
        beside[k] = z[k] + way;
        there = seen(beside);
      }
      if (!there) return {};
      slopes.col(k).head(figures) = (now.missing - there->missing) / way;
      slopes.col(k).tail(gaps) = (there->gaps - now.gaps) / way;
    }
    for (double part = 1; part >= leastPart; part /= 2) {
      std::vector<LinearRule> rules;
      for (Eigen::Index i = 0; i < figures; ++i)
        rules.push_back({slopes.row(i).transpose(), slopes.row(i).dot(z) + part * now.missing[i], true});
      rules.insert(rules.end(), bendable_.rules().begin(), bendable_.rules().end());
      for (Eigen::Index i = 0; i < gaps; ++i) {
        const Eigen::VectorXd slope = slopes.row(figures + i).transpose();
        if (slope.squaredNorm() > 0) rules.push_back({slope, slope.dot(z) - now.gaps[i], false});
      }
      if (auto goal = leastUnder(rules, bendable_.inverseCost())) return goal;
    }
    return {};
  }

  // Goes as far as the figures come nearer; `z` moves along.
  std::optional<Seen> stepAlong(Eigen::VectorXd& z, const Eigen::VectorXd& way, const Seen& now,
                                bool met) const {
    const double before = distance(now);
    for (double part = 1; part >= leastStep; part /= 2) {
      const Eigen::VectorXd place = z + part * way;
      auto there = seen(place);
      if (!there) continue;
      if (met ? !isMet(*there) : !(distance(*there) < before)) continue;
      z = place;
      return there;
    }
    return {};
  }
  static double distance(const Seen& seen) {
    const double gap = seen.gaps.size() > 0 ? std::max(0.0, -seen.gaps.minCoeff()) : 0;
    return (seen.missing.size() > 0 ? seen.missing.cwiseAbs().sum() : 0) + gap;
  }

  BendableState bendable_;
  const std::vector<FigureTarget>& targets_;
  TargetTolerance tolerance_;
  SectionSettings settings_;
};

std::set<Rule> rulesBroken(const Button& button, const SectionSettings& settings) {
  std::set<Rule> rules;
  for (const Warning& warning : validate(button, settings)) rules.insert(warning.rule);
  return rules;
}

std::optional<Button> solved(const Button& button, std::size_t state,
                             const std::vector<FigureTarget>& targets, const TargetTolerance& tolerance,
                             const SectionSettings& settings) {
  const std::set<Rule> before = rulesBroken(button, settings);
  for (const auto bulges : {BendableState::Bulges::atKnots, BendableState::Bulges::finer}) {
    auto found = Search(button.states()[state], targets, tolerance, settings, bulges).found();
    if (!found) continue;
    std::vector<ButtonState> states = button.states();
    states[state] = *std::move(found);
    auto next = Button::fromStates(button.name(), std::move(states), button.provenance());
    if (!next) continue;
    const std::set<Rule> after = rulesBroken(*next, settings);
    if (std::includes(before.begin(), before.end(), after.begin(), after.end())) return *std::move(next);
  }
  return {};
}

Failure refusal(Message problem, Remedies remedies) {
  return {FailureCode::wrongUsage, "key figures", {}, std::move(problem), std::move(remedies)};
}

TargetConflict conflictOf(const std::vector<KeyFigure>& figures) {
  if (figures.size() == 1)
    return {figures, refusal(Message("%1 cannot have this value: the button would lose its shape",
                                     Message::of(termOf(figures[0]), {})),
                             Message("Give a value nearer to the present one"))};
  const Message first = Message::of(termOf(figures[0]), {}), second = Message::of(termOf(figures[1]), {});
  if (figures.size() == 2)
    return {figures, refusal(Message("%1 and %2 contradict each other", first, second),
                             Message("Leave one of the two free, or give it another value"))};
  std::vector<Message> rest;
  for (std::size_t i = 2; i < figures.size(); ++i) rest.push_back(Message::of(termOf(figures[i]), {}));
  return {figures, refusal(Message("%1 and %2 contradict each other as long as this is kept as well: %3",
                                   first, second, std::move(rest)),
                           Message("Leave one of them free, or give it another value"))};
}

// Targets of which none can be done without: as few as still contradict each other.
std::vector<FigureTarget> fewest(const Button& button, std::size_t state, std::vector<FigureTarget> targets,
                                 const TargetTolerance& tolerance, const SectionSettings& settings) {
  // What a solve could not reach with more of them it may reach with fewer: tried until nothing goes any more.
  for (bool gone = true; gone;) {
    gone = false;
    for (std::size_t i = targets.size(); i-- > 0 && targets.size() > 1;) {
      std::vector<FigureTarget> without = targets;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      if (solved(button, state, without, tolerance, settings)) continue;
      targets = std::move(without);
      gone = true;
    }
  }
  return targets;
}

bool allMet(const KeyFigures& figures, const std::vector<FigureTarget>& targets) {
  return std::all_of(targets.begin(), targets.end(),
                     [&](const FigureTarget& target) { return figures[target.figure] == target.value; });
}

std::vector<FigureTarget> lastOfEach(const std::vector<FigureTarget>& targets) {
  std::vector<FigureTarget> kept;
  for (const FigureTarget& target : targets) {
    std::erase_if(kept, [&](const FigureTarget& other) { return other.figure == target.figure; });
    kept.push_back(target);
  }
  return kept;
}

}  // namespace

TargetOutcome bentToTargets(const Button& button, std::size_t state, const std::vector<FigureTarget>& targets,
                            const TargetTolerance& tolerance, const SectionSettings& settings) {
  DETENT_CHECK(state < button.states().size(), "a state of the button");
  const std::vector<FigureTarget> wanted = lastOfEach(targets);
  const KeyFigures now = keyFiguresOf(button.states()[state], settings);
  for (const FigureTarget& target : wanted) {
    if (!now[target.figure])
      return {{},
              TargetConflict{{target.figure},
                             refusal(Message("the button has no such figure: %1",
                                             Message::of(termOf(target.figure), {})),
                                     Message("Add what it measures to the curve first"))}};
    if (!std::isfinite(target.value)) return {{}, conflictOf({target.figure})};
  }
  if (allMet(now, wanted)) return {button, {}};
  if (auto next = solved(button, state, wanted, tolerance, settings)) return {*std::move(next), {}};
  std::vector<KeyFigure> figures;
  for (const FigureTarget& target : fewest(button, state, wanted, tolerance, settings))
    figures.push_back(target.figure);
  return {{}, conflictOf(figures)};
}

}  // namespace detent
