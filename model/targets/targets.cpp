// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/targets/targets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <set>

#include "model/check.h"
#include "model/metrics.h"
#include "model/targets/bendable_state.h"
#include "model/validation.h"

namespace detent {
namespace {

constexpr int mostSteps = 40;
constexpr int stepsOnceMet = 3;         // steps towards the least cost, after the figures are met
constexpr double difference = 1e-6;     // step of an unknown for numeric slopes of figures
constexpr double noSlope = 1e-6;        // smaller numeric slopes are rounding
constexpr double settled = 1e-5;        // an unknown that moves by less has converged
constexpr double exact = 1e-9;          // shares of travel and range: a closer figure is met
constexpr double leastPart = 1.0 / 32;  // smallest share of the way to the targets that a step must achieve
constexpr double leastStep = 1.0 / 256;
// if a bottom-out's start moves this many times as far as any landmark, another place has become the start
constexpr double largestStep = 4;
constexpr double leastOfWay = 1.0 / 64;  // resolution of the limit of an impossible value

// Rules that can block a step, most informative first.
constexpr ShapeRule rulesOfSteps[] = {ShapeRule::inOrder, ShapeRule::onStroke, ShapeRule::releaseBelow,
                                      ShapeRule::noPull,  ShapeRule::tactile,  ShapeRule::mainEvent,
                                      ShapeRule::width,   ShapeRule::direction};

// Freedom of landmarks that no requested figure is measured at.
enum class Others { held, free };

FigureUnit unitOf(KeyFigure figure) { return keyFigureNames()[static_cast<std::size_t>(figure)].unit; }
const char* termOf(KeyFigure figure) { return keyFigureNames()[static_cast<std::size_t>(figure)].term; }

// Work done and its limit.
class Effort {
 public:
  explicit Effort(const TargetPatience& patience) : patience_(patience) {}

  void spend(const ButtonState& measured) {
    knots_ += measured.graph.press().knots().size();
    if (measured.graph.release()) knots_ += measured.graph.release()->knots().size();
  }
  bool givenUp() const { return patience_.givenUp && patience_.givenUp(); }
  bool spent() const { return knots_ > patience_.mostKnots; }
  bool over() const { return givenUp() || spent(); }

 private:
  const TargetPatience& patience_;
  std::size_t knots_ = 0;
};

// One solve: the unknowns of a state, and the distances of its figures from the targets, in shares of travel
// and range.
class Search {
 public:
  Search(BendableState bendable, const std::vector<FigureTarget>& targets, const TargetTolerance& tolerance,
         const SectionSettings& settings, Effort& effort)
      : bendable_(std::move(bendable)),
        targets_(targets),
        tolerance_(tolerance),
        settings_(settings),
        effort_(effort) {}

  std::optional<ButtonState> found(Others others) {
    restrictUnknowns(others);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(bendable_.unknowns());
    auto now = z.size() > 0 ? seen(z) : std::nullopt;
    int onceMet = 0;
    for (int step = 0; now && step < mostSteps && !effort_.givenUp(); ++step) {
      if (onceMet == 0 && effort_.spent()) break;  // once met, the change is still minimised
      const bool met = isMet(*now);
      if (met && onceMet++ >= stepsOnceMet) break;
      const auto slopes = slopesAt(z, *now);
      const auto goal = slopes ? next(*slopes, z, *now) : std::nullopt;
      if (!goal) {
        if (slopes) stuck_ = Stuck{z, *slopes, *now, {}};
        break;
      }
      const Eigen::VectorXd way = *goal - z;
      if (met && way.cwiseAbs().maxCoeff() < settled) break;
      auto better = stepAlong(z, way, *now, met);
      if (!better) {
        stuck_ = Stuck{z, *slopes, *now, way};
        break;
      }
      now = std::move(better);
    }
    if (!now || !isMet(*now)) return {};
    return std::move(now->state);
  }

  /// The blocking rule if nothing was found.
  std::optional<ShapeRule> obstacle() const {
    if (!stuck_) return {};
    return stuck_->way ? firstLost(stuck_->z, *stuck_->way) : holdingUp(*stuck_);
  }

 private:
  struct Seen {
    ButtonState state;
    Eigen::VectorXd missing;  // target minus figure
    Eigen::VectorXd gaps;     // in shares of the range
    bool bottomOutAtEnd;      // or none
  };
  // State from which no step helped: either none was allowed (`way` is empty), or the allowed step `way`
  // brought the figures no nearer.
  struct Stuck {
    Eigen::VectorXd z;
    Eigen::MatrixXd slopes;
    Seen seen;
    std::optional<Eigen::VectorXd> way;
  };

  // Removes the unknowns that move the bottom-out or the ends, unless a requested figure depends on them.
  void restrictUnknowns(Others others) {
    const bool travel = isWanted({KeyFigure::bottomOutTravel, KeyFigure::totalTravel}),
               force = isWanted({KeyFigure::bottomOutForce, KeyFigure::endForce, KeyFigure::slopeToPeak,
                                 KeyFigure::slopeToBottomOut});
    const std::vector<Moved>& moved = bendable_.moved();
    std::vector<bool> may(moved.size());
    std::transform(moved.begin(), moved.end(), may.begin(), [&](Moved what) {
      return what == Moved::stopTravel ? travel : what == Moved::stopForce ? force : true;
    });
    if (others == Others::held) keepCarriers(may);
    std::vector<Eigen::Index> kept;
    for (std::size_t i = 0; i < may.size(); ++i)
      if (may[i]) kept.push_back(static_cast<Eigen::Index>(i));
    bendable_.keepOnly(kept);
  }
  // Removes unknowns on which no requested figure depends. Bulges of the press stay, those of the release
  // only if the release moves.
  void keepCarriers(std::vector<bool>& may) const {
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(bendable_.unknowns());
    const auto now = seen(still);
    const auto slopes = now ? slopesAt(still, *now) : std::nullopt;
    if (!slopes) return;
    const std::vector<Moved>& moved = bendable_.moved();
    bool releaseMoves = false;
    for (std::size_t i = 0; i < may.size(); ++i) {
      if (moved[i] == Moved::bulge || moved[i] == Moved::releaseBulge) continue;
      const auto column = slopes->col(static_cast<Eigen::Index>(i)).head(now->missing.size());
      may[i] = may[i] && column.cwiseAbs().maxCoeff() > noSlope;
      releaseMoves = releaseMoves || (may[i] && moved[i] == Moved::release);
    }
    for (std::size_t i = 0; i < may.size(); ++i)
      if (moved[i] == Moved::releaseBulge) may[i] = releaseMoves;
  }
  bool isWanted(std::initializer_list<KeyFigure> figures) const {
    return std::ranges::any_of(targets_, [&](const FigureTarget& target) {
      return std::ranges::find(figures, target.figure) != figures.end();
    });
  }

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
  // Accuracy to aim at, in shares of travel and range: a tenth of the tolerance, but not below rounding.
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
    effort_.spend(*state);
    const KeyFigures figures = keyFiguresOf(*state, settings_);
    Eigen::VectorXd missing(static_cast<Eigen::Index>(targets_.size()));
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const auto& value = figures[targets_[i].figure];
      if (!value) return {};
      missing[static_cast<Eigen::Index>(i)] =
          (targets_[i].value - *value) / scaleOf(unitOf(targets_[i].figure));
    }
    Eigen::VectorXd gaps = bendable_.gaps(z, *state) / bendable_.range_N();
    const bool bottomOutAtEnd = figures[KeyFigure::bottomOutTravel] == figures[KeyFigure::totalTravel];
    return Seen{*std::move(state), std::move(missing), std::move(gaps), bottomOutAtEnd};
  }

  bool isMet(const Seen& seen) const {
    for (std::size_t i = 0; i < targets_.size(); ++i)
      if (!(std::abs(seen.missing[static_cast<Eigen::Index>(i)]) <= bound(unitOf(targets_[i].figure))))
        return false;
    return seen.gaps.size() == 0 || seen.gaps.minCoeff() > -1e-6;
  }

  // Derivatives of figures and gaps by the unknowns.
  std::optional<Eigen::MatrixXd> slopesAt(const Eigen::VectorXd& z, const Seen& now) const {
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
    return slopes;
  }

  // Unknowns at which the linearised figures meet their targets at the least cost. If the rules forbid that,
  // part of the way there; nullopt if they forbid even `leastPart` of it.
  std::optional<Eigen::VectorXd> next(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& z,
                                      const Seen& now) const {
    for (double part = 1; part >= leastPart; part /= 2)
      if (auto goal = leastUnder(rulesFor(part, slopes, z, now, {}), bendable_.inverseCost())) return goal;
    return {};
  }

  // The single rule whose removal would allow the smallest step; nullopt if there is no such rule.
  std::optional<ShapeRule> holdingUp(const Stuck& stuck) const {
    for (const ShapeRule rule : rulesOfSteps)
      if (leastUnder(rulesFor(leastPart, stuck.slopes, stuck.z, stuck.seen, rule), bendable_.inverseCost()))
        return rule;
    return {};
  }

  // Linearised figures at `part` of the way to the targets, and the shape rules.
  std::vector<LinearRule> rulesFor(double part, const Eigen::MatrixXd& slopes, const Eigen::VectorXd& z,
                                   const Seen& now, std::optional<ShapeRule> without) const {
    const Eigen::Index figures = now.missing.size();
    std::vector<LinearRule> rules;
    for (Eigen::Index i = 0; i < figures; ++i)
      rules.push_back({slopes.row(i).transpose(), slopes.row(i).dot(z) + part * now.missing[i], true});
    for (const BendableState::Rule& rule : bendable_.rules())
      if (rule.kind != without) rules.push_back(rule.linear);
    for (Eigen::Index i = 0; i < now.gaps.size() && without != ShapeRule::releaseBelow; ++i) {
      const Eigen::VectorXd slope = slopes.row(figures + i).transpose();
      if (slope.squaredNorm() > 0) rules.push_back({slope, slope.dot(z) - now.gaps[i], false});
    }
    return rules;
  }

  // Takes the longest part of `way` that brings the figures nearer to their targets, or keeps them met;
  // updates `z`. nullopt if no part does.
  std::optional<Seen> stepAlong(Eigen::VectorXd& z, const Eigen::VectorXd& way, const Seen& now,
                                bool met) const {
    const double before = distance(now);
    for (double part = 1; part >= leastStep; part /= 2) {
      const Eigen::VectorXd place = z + part * way;
      auto there = seen(place);
      if (!there || (now.bottomOutAtEnd && !there->bottomOutAtEnd)) continue;
      if (met ? !isMet(*there) : !(distance(*there) < before)) continue;
      z = place;
      return there;
    }
    return {};
  }
  // The first shape rule that is broken along `way`, a direction that brings the figures no nearer.
  std::optional<ShapeRule> firstLost(const Eigen::VectorXd& z, const Eigen::VectorXd& way) const {
    const auto before = bendable_.at(z);
    for (double part = leastStep; before && part <= 1; part *= 2) {
      const auto there = bendable_.at(z + part * way);
      if (!there) return ShapeRule::width;
      const StrokeMetrics then = metricsOf(there->graph.press(), Stroke::press, settings_),
                          first = metricsOf(before->graph.press(), Stroke::press, settings_);
      const auto atEnd = [](const StrokeMetrics& metrics, const ButtonState& state) {
        return metrics.bottomOut.displacement_mm == state.graph.press().end_mm();
      };
      if (then.bottomOut.isSteep != first.bottomOut.isSteep ||
          (atEnd(first, *before) && !atEnd(then, *there)))
        return ShapeRule::bottomOut;
      const double moved_mm = std::abs(then.bottomOut.displacement_mm - first.bottomOut.displacement_mm);
      if (moved_mm > largestStep * part * way.cwiseAbs().maxCoeff() * bendable_.travel_mm())
        return ShapeRule::bottomOut;
      if (then.tactile.size() != first.tactile.size()) return ShapeRule::tactile;
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
  Effort& effort_;
  std::optional<Stuck> stuck_;
};

std::set<Rule> rulesBroken(const Button& button, const SectionSettings& settings) {
  std::set<Rule> rules;
  for (const Warning& warning : validate(button, settings)) rules.insert(warning.rule);
  return rules;
}

Failure refusal(Message problem, Remedies remedies) {
  return {FailureCode::wrongUsage, "key figures", {}, std::move(problem), std::move(remedies)};
}

// Describes what breaking a rule would do to the button.
Message lossOf(ShapeRule rule) {
  switch (rule) {
    case ShapeRule::width:
      return Message("a part of the curve would have no width left");
    case ShapeRule::direction:
      return Message("a rising part of the curve would fall, or a falling part would rise");
    case ShapeRule::noPull:
      return Message("the force would fall below 0, and the button would pull");
    case ShapeRule::mainEvent:
      return Message("another tactile point would get the largest drop");
    case ShapeRule::onStroke:
      return Message("the operating or the reset point would leave its stroke");
    case ShapeRule::inOrder:
      return Message("the reset point would lie deeper than the operating point");
    case ShapeRule::releaseBelow:
      return Message("the release force would exceed the press force");
    case ShapeRule::tactile:
      return Message("a tactile point would become too weak to count");
    case ShapeRule::bottomOut:
      return Message("the bottom-out would begin elsewhere");
  }
  return {};
}

Message lossOf(Rule broken) {
  switch (broken) {
    case Rule::releaseAbovePress:
      return lossOf(ShapeRule::releaseBelow);
    case Rule::negativeForce:
      return lossOf(ShapeRule::noPull);
    case Rule::resetBeyondOperating:
      return lossOf(ShapeRule::inOrder);
    case Rule::strokesDoNotMeet:
      return Message("the release would not begin where the press ends");
    case Rule::statesDoNotMeet:
      return Message("the release would not end where the next state starts");
    case Rule::hiddenTactilePoint:
      return Message("a tactile point would lie inside a jump, where no finger feels it");
    case Rule::fallsAtStart:
      return Message("the press would begin with a falling force");
    case Rule::dampingOutsideTravel:
      return Message("a damping point would lie outside the travel");
    case Rule::speedsGiveEnergy:
      return Message("the release force at one speed would exceed the press force at another");
    case Rule::noRelease:
    case Rule::manyKnots:
    case Rule::lowConfidence:
      break;
  }
  return {};
}

std::vector<KeyFigure> figuresOf(const std::vector<FigureTarget>& targets) {
  std::vector<KeyFigure> figures;
  for (const FigureTarget& target : targets) figures.push_back(target.figure);
  return figures;
}

std::vector<Message> termsOf(const std::vector<FigureTarget>& targets) {
  std::vector<Message> terms;
  for (const FigureTarget& target : targets) terms.push_back(Message::of(termOf(target.figure), {}));
  return terms;
}

TargetConflict conflictOf(const std::vector<FigureTarget>& targets) {
  const std::vector<Message> terms = termsOf(targets);
  const std::vector<Message> rest(terms.begin() + 2, terms.end());
  Message problem =
      rest.empty() ? Message("%1 and %2 contradict each other", terms[0], terms[1])
                   : Message("these targets contradict each other: %1; %2; %3", terms[0], terms[1], rest);
  const Message remedy = rest.empty() ? Message("Remove or unlock one of the two, or give it another value")
                                      : Message("Remove or unlock one of them, or give it another value");
  return {figuresOf(targets), {}, refusal(std::move(problem), remedy)};
}

/// Conflict for targets that could not be decided within the limit.
TargetConflict undecided(const std::vector<FigureTarget>& targets) {
  return {
      figuresOf(targets),
      {},
      refusal(
          Message(
              "no curve was found that meets all these targets (%1); it is not known which of them conflict",
              termsOf(targets)),
          Message("Remove or unlock some of these, or give values nearer to the current ones")),
      true};
}

Message valueWithUnit(double value, FigureUnit unit) {
  switch (unit) {
    case FigureUnit::mm:
      return {"%1", millimetres(value)};
    case FigureUnit::N:
      return {"%1", newtons(value)};
    case FigureUnit::N_per_mm:
      return Message("%1 N/mm", value);
    case FigureUnit::mJ:
      return Message("%1 mJ", value);
    case FigureUnit::share:
      return {"%1", MessageValue(value, Measure::share)};
  }
  return {};
}

// A button and the targets for one of its states.
class Bending {
 public:
  Bending(const Button& button, std::size_t state, const TargetTolerance& tolerance,
          const SectionSettings& settings, Effort& effort)
      : button_(button),
        state_(state),
        tolerance_(tolerance),
        settings_(settings),
        effort_(effort),
        brokenBefore_(rulesBroken(button, settings)) {}

  std::optional<Button> solved(const std::vector<FigureTarget>& targets) const {
    std::optional<Button> whole;
    solve(targets, [&](const Button& next) {
      if (newlyBroken(next)) return false;
      whole = next;
      return true;
    });
    return whole;
  }

  /// Returns a minimal set of contradicting targets.
  std::vector<FigureTarget> fewest(std::vector<FigureTarget> targets) const {
    // A solve may reach fewer targets that it could not reach together with others; repeat until nothing
    // changes.
    for (bool gone = true; gone && !effort_.over();) {
      gone = false;
      for (std::size_t i = targets.size(); i-- > 0 && targets.size() > 1;) {
        std::vector<FigureTarget> without = targets;
        without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
        if (solved(without)) continue;
        if (effort_.over()) return targets;
        targets = std::move(without);
        gone = true;
      }
    }
    return targets;
  }

  /// For a figure that is impossible by itself: its limit and the blocking rule.
  TargetConflict limitOf(const FigureTarget& target, double now) const {
    const double reachable = nearest(target, now);
    const Message term = Message::of(termOf(target.figure), {});
    const FigureUnit unit = unitOf(target.figure);
    const double beyond = reachable + 2 * leastOfWay * (target.value - now);
    Message problem = Message("%1 cannot be %2; beyond %3, %4", term, valueWithUnit(target.value, unit),
                              valueWithUnit(reachable, unit), lossAt({target.figure, beyond}));
    return {{target.figure},
            reachable,
            refusal(std::move(problem), Message("Give a value nearer to the current one"))};
  }

 private:
  using Takes = std::function<bool(const Button&)>;
  using Failed = std::function<void(const Search&)>;

  /// Tries every kind of bending until `takes` accepts one; reports the others to `failed`.
  void solve(const std::vector<FigureTarget>& targets, const Takes& takes, const Failed& failed = {}) const {
    const ButtonState& state = button_.states()[state_];
    const bool contacts = state.operatingPoint_mm || state.resetPoint_mm;
    for (const auto others : {Others::held, Others::free})
      for (const auto way : {BendableState::Contacts::free, BendableState::Contacts::riding})
        for (const auto bulges : {BendableState::Bulges::atKnots, BendableState::Bulges::finer}) {
          if (effort_.over()) return;
          if (way == BendableState::Contacts::riding && !contacts) continue;
          Search search(BendableState(state, settings_, bulges, way), targets, tolerance_, settings_,
                        effort_);
          auto found = search.found(others);
          if (!found && failed && others == Others::free) failed(search);
          if (!found) continue;
          std::vector<ButtonState> states = button_.states();
          states[state_] = *std::move(found);
          const auto next = Button::fromStates(button_.name(), std::move(states), button_.provenance());
          if (next && takes(*next)) return;
        }
  }

  std::optional<Rule> newlyBroken(const Button& next) const {
    for (const Rule rule : rulesBroken(next, settings_))
      if (!brokenBefore_.contains(rule)) return rule;
    return {};
  }

  /// The last possible value on the way from `now` to the target.
  double nearest(const FigureTarget& target, double now) const {
    double reached = 0;
    for (double part = 0.5; part >= leastOfWay && !effort_.over(); part /= 2)
      if (solved({{target.figure, now + (reached + part) * (target.value - now)}})) reached += part;
    return now + reached * (target.value - now);
  }

  /// Describes what the button would lose with that target.
  Message lossAt(const FigureTarget& target) const {
    std::optional<Rule> broken;
    std::optional<ShapeRule> obstacle;
    solve(
        {target}, [&](const Button& next) { return (broken = newlyBroken(next)).has_value(); },
        [&](const Search& search) {
          if (!obstacle) obstacle = search.obstacle();
        });
    if (broken) return lossOf(*broken);
    if (obstacle) return lossOf(*obstacle);
    return Message("the curve would break several rules at once");
  }

  const Button& button_;
  std::size_t state_;
  TargetTolerance tolerance_;
  SectionSettings settings_;
  Effort& effort_;
  std::set<Rule> brokenBefore_;
};

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
                            const TargetTolerance& tolerance, const SectionSettings& settings,
                            const TargetPatience& patience) {
  DETENT_CHECK(state < button.states().size(), "a state of the button");
  const std::vector<FigureTarget> wanted = lastOfEach(targets);
  const KeyFigures now = keyFiguresOf(button.states()[state], settings);
  for (const FigureTarget& target : wanted) {
    if (!now[target.figure])
      return {{},
              TargetConflict{{target.figure},
                             {},
                             refusal(Message("the button has no key figure of this kind: %1",
                                             Message::of(termOf(target.figure), {})),
                                     Message("First add to the curve the part that this key figure measures, "
                                             "such as a release or a tactile point"))}};
    if (!std::isfinite(target.value))
      return {{},
              TargetConflict{{target.figure},
                             {},
                             refusal(Message("%1 cannot be infinite", Message::of(termOf(target.figure), {})),
                                     Message("Give a number"))}};
  }
  if (allMet(now, wanted)) return {button, {}};
  Effort effort(patience);
  const Bending bending(button, state, tolerance, settings, effort);
  auto next = bending.solved(wanted);
  if (effort.givenUp()) return {};
  if (next) return {*std::move(next), {}};
  const std::vector<FigureTarget> contradicting = bending.fewest(wanted);
  TargetConflict conflict = contradicting.size() > 1
                                ? conflictOf(contradicting)
                                : bending.limitOf(contradicting.front(), *now[contradicting.front().figure]);
  if (effort.givenUp()) return {};
  if (effort.spent()) conflict = undecided(contradicting);
  return {{}, std::move(conflict)};
}

}  // namespace detent
