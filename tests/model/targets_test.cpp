// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/targets/targets.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <random>
#include <set>
#include <thread>

#include <catch2/catch.hpp>

#include "model/file/button_file.h"
#include "model/templates.h"
#include "model/validation.h"

using namespace detent;

namespace {

constexpr double gramForce_N = 0.00980665;
constexpr double bar_N = 0.1 * gramForce_N, bar_mm = 0.001;

struct Sample {
  std::string name;
  Button button;
  std::size_t state;
};

// Every state of every sample; those without contacts get them, so that each figure is tried.
std::vector<Sample> samples() {
  std::vector<Sample> all;
  for (const char* name : {"A", "B", "C", "D", "E", "EF", "F", "push", "latch"}) {
    const auto button =
        readButtonFile(DETENT_SOURCE_DIR "/samples/buttons/" + std::string(name) + ".button.json");
    REQUIRE(button.ok());
    for (std::size_t state = 0; state < button->states().size(); ++state) {
      std::vector<ButtonState> states = button->states();
      const double travel_mm = states[state].graph.travel_mm();
      if (!states[state].operatingPoint_mm) states[state].operatingPoint_mm = 0.55 * travel_mm;
      const double back_mm = states[state].graph.curve(Stroke::release).start_mm();
      if (!states[state].resetPoint_mm)
        states[state].resetPoint_mm = back_mm + 0.8 * (*states[state].operatingPoint_mm - back_mm);
      const auto made = Button::fromStates(name, std::move(states));
      INFO(name << (made.ok() ? "" : made.failure().sentence()));
      REQUIRE(made.ok());
      all.push_back({name, *made, state});
    }
  }
  return all;
}

std::set<Rule> rulesBroken(const Button& button) {
  std::set<Rule> rules;
  for (const Warning& warning : validate(button)) rules.insert(warning.rule);
  return rules;
}

FigureUnit unitOf(KeyFigure figure) { return keyFigureNames()[static_cast<std::size_t>(figure)].unit; }

// Two to six figures, some kept as they are, others up to a fifth of their value away.
std::vector<FigureTarget> anyTargets(const KeyFigures& figures, std::mt19937& random) {
  std::vector<KeyFigure> there;
  for (const KeyFigureName& name : keyFigureNames())
    if (figures[name.figure]) there.push_back(name.figure);
  std::shuffle(there.begin(), there.end(), random);
  const std::size_t count = std::min<std::size_t>(there.size(), 2 + random() % 5);
  std::uniform_real_distribution<double> change(-0.2, 0.2);
  std::vector<FigureTarget> targets;
  for (std::size_t i = 0; i < count; ++i) {
    const double now = *figures[there[i]];
    targets.push_back({there[i], random() % 3 == 0 ? now : now * (1 + change(random))});
  }
  return targets;
}

// Distance of a figure from its target, in shares of the bar; of a figure that is no force and no length, of
// 0.1 %.
double missed(const KeyFigures& figures, const FigureTarget& target) {
  const auto& value = figures[target.figure];
  if (!value) return 1e9;
  const double off = std::abs(*value - target.value);
  if (unitOf(target.figure) == FigureUnit::N) return off / bar_N;
  if (unitOf(target.figure) == FigureUnit::mm) return off / bar_mm;
  return off / (1e-3 * std::max(std::abs(target.value), 0.01));
}

std::string textOf(const std::vector<FigureTarget>& targets, const KeyFigures& now) {
  std::string text;
  for (const FigureTarget& target : targets)
    text += std::string(keyFigureNames()[static_cast<std::size_t>(target.figure)].key) + " " +
            std::to_string(now[target.figure].value_or(0)) + " -> " + std::to_string(target.value) + "; ";
  return text;
}

// The limit of a figure that cannot be had even alone: between the present value and the request, met itself,
// and nothing farther on.
void checkLimit(const Sample& sample, const FigureTarget& wanted, double limit) {
  const double now = *keyFiguresOf(sample.button.states()[sample.state])[wanted.figure];
  CHECK(std::abs(limit - now) + std::abs(wanted.value - limit) <= 1.000001 * std::abs(wanted.value - now));
  const TargetOutcome there = bentToTargets(sample.button, sample.state, {{wanted.figure, limit}});
  REQUIRE(there.button);
  CHECK(missed(keyFiguresOf(there.button->states()[sample.state]), {wanted.figure, limit}) <= 1);
  CHECK(bentToTargets(sample.button, sample.state, {wanted}).conflict);
}

int setsToTry() {
  const char* sets = std::getenv("DETENT_TARGET_SETS");
  return sets ? std::atoi(sets) : 60;
}

}  // namespace

// DETENT_TARGET_SETS=1000 tries as many, and prints what became of them.
TEST_CASE("random sets of targets are met, or those that contradict are named") {
  const std::vector<Sample> all = samples();
  std::mt19937 random(20131008);
  int met = 0, refused = 0, single = 0;
  double slowest_ms = 0, worst = 0;
  for (int i = 0; i < setsToTry(); ++i) {
    const Sample& sample = all[random() % all.size()];
    const KeyFigures now = keyFiguresOf(sample.button.states()[sample.state]);
    const std::vector<FigureTarget> targets = anyTargets(now, random);
    INFO(i << " " << sample.name << " state " << sample.state << ": " << textOf(targets, now));
    const auto begun = std::chrono::steady_clock::now();
    const TargetOutcome outcome = bentToTargets(sample.button, sample.state, targets);
    const double took_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    slowest_ms = std::max(slowest_ms, took_ms);
    REQUIRE(outcome.button.has_value() != outcome.conflict.has_value());
    if (outcome.button) {
      ++met;
      const KeyFigures then = keyFiguresOf(outcome.button->states()[sample.state]);
      for (const FigureTarget& target : targets) {
        CHECK(missed(then, target) <= 1);
        worst = std::max(worst, missed(then, target));
      }
      const std::set<Rule> before = rulesBroken(sample.button), after = rulesBroken(*outcome.button);
      CHECK(std::includes(before.begin(), before.end(), after.begin(), after.end()));
      continue;
    }
    ++refused;
    const std::vector<KeyFigure>& named = outcome.conflict->figures;
    REQUIRE(!named.empty());
    single += named.size() == 1;
    if (std::getenv("DETENT_TARGET_SETS"))
      std::cout << i << " " << sample.name << " " << outcome.conflict->failure.sentence() << " <- "
                << textOf(targets, now) << " " << took_ms << " ms\n";
    CHECK(outcome.conflict->reachable.has_value() == (named.size() == 1));
    CHECK(!outcome.conflict->undecided);
    CHECK_THAT(outcome.conflict->failure.sentence(), !Catch::Contains("several rules"));
    if (named.size() == 1) {
      const auto wanted = std::find_if(targets.begin(), targets.end(),
                                       [&](const FigureTarget& target) { return target.figure == named[0]; });
      checkLimit(sample, *wanted, *outcome.conflict->reachable);
    }
    // The named figures do contradict: all of them are requested, and without any one of them the rest can be
    // met.
    std::vector<FigureTarget> those;
    for (const FigureTarget& target : targets)
      if (std::count(named.begin(), named.end(), target.figure) > 0) those.push_back(target);
    CHECK(those.size() == named.size());
    for (std::size_t k = 0; k < those.size() && those.size() > 1; ++k) {
      std::vector<FigureTarget> without = those;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
      CHECK(bentToTargets(sample.button, sample.state, without).button.has_value());
    }
  }
  if (std::getenv("DETENT_TARGET_SETS"))
    std::cout << met << " met, " << refused << " refused (" << single << " for one figure alone), worst "
              << worst << " of the bar, slowest " << slowest_ms << " ms\n";
  CHECK(met > refused);
}

TEST_CASE("a search that is given up gives nothing, and soon") {
  const std::vector<Sample> all = samples();
  int wanted = 0;
  const TargetOutcome outcome =
      bentToTargets(all[3].button, 0, {{KeyFigure::peakForce, 0.1}, {KeyFigure::drop, 0.5}}, {}, {},
                    {[&] { return ++wanted > 3; }});
  CHECK(!outcome.button);
  CHECK(!outcome.conflict);
  CHECK(wanted < 20);
}

TEST_CASE("a search that may do no more says so, and of what") {
  const std::vector<Sample> all = samples();
  const std::vector<FigureTarget> wanted = {{KeyFigure::peakForce, 0.1}, {KeyFigure::drop, 0.5}};
  const TargetOutcome outcome = bentToTargets(all[3].button, 0, wanted, {}, {}, {{}, 1});
  CHECK(!outcome.button);
  REQUIRE(outcome.conflict);
  CHECK(outcome.conflict->undecided);
  CHECK(outcome.conflict->figures == std::vector{KeyFigure::peakForce, KeyFigure::drop});
  CHECK_THAT(outcome.conflict->failure.sentence(), Catch::Contains("Peak force; Tactile drop"));
  CHECK(!bentToTargets(all[3].button, 0, wanted).conflict->undecided);
}

// The bound is counted: a slower machine, here by a pause at every call, gives the same answer.
TEST_CASE("how far a search goes is the same on every machine") {
  const std::vector<Sample> all = samples();
  const std::vector<FigureTarget> wanted = {
      {KeyFigure::peakForce, 0.1}, {KeyFigure::drop, 0.5}, {KeyFigure::totalTravel, 3.5}};
  std::set<std::string> sentences;
  std::set<bool> decided;
  for (const std::size_t mostKnots : {100UL, 1'000UL, 4'000UL, 16'000UL, 64'000UL, 1'000'000UL}) {
    const auto slowly = [] {
      std::this_thread::sleep_for(std::chrono::microseconds(300));
      return false;
    };
    const TargetOutcome quick = bentToTargets(all[3].button, 0, wanted, {}, {}, {{}, mostKnots}),
                        slow = bentToTargets(all[3].button, 0, wanted, {}, {}, {slowly, mostKnots});
    INFO(mostKnots);
    REQUIRE(quick.conflict);
    REQUIRE(slow.conflict);
    CHECK(quick.conflict->failure.sentence() == slow.conflict->failure.sentence());
    CHECK(quick.conflict->figures == slow.conflict->figures);
    sentences.insert(quick.conflict->failure.sentence());
    decided.insert(!quick.conflict->undecided);
  }
  CHECK(sentences.size() > 1);  // the allowed effort did change results
  CHECK(decided.size() == 2);
}

// Before D's travel becomes so short, its bottom-out begins at another knot: the figure jumps, and no small
// step leads across.
TEST_CASE(
    "a start of the bottom-out that would jump is reported as a bottom-out that would begin elsewhere") {
  const Sample sample = samples()[3];
  REQUIRE(sample.name == "D");
  const TargetOutcome outcome = bentToTargets(sample.button, 0, {{KeyFigure::bottomOutTravel, 2.9133868}});
  REQUIRE(outcome.conflict);
  CHECK_THAT(outcome.conflict->failure.sentence(), Catch::Contains("bottom-out would begin elsewhere"));
}

// These values hit a case where 5 mm times the growth of the travel is a rounding error more than the
// travel.
TEST_CASE("damping ends with the travel, whatever that is rounded to") {
  const std::vector<Sample> all = samples();
  const auto push = std::ranges::find_if(all, [](const Sample& each) { return each.name == "push"; });
  REQUIRE(push != all.end());
  REQUIRE(push->button.states()[0].damping.back().displacement_mm == 5);
  for (int i = 0; i < 25; ++i) {
    const double slope = 0.5086155 + 4e-8 * i;
    CAPTURE(slope);
    CHECK(bentToTargets(push->button, 0, {{KeyFigure::slopeToBottomOut, slope}}).button);
  }
}

// Press and release of samples/plots/white-vector.pdf. The release lies 0.01 N below the valley of the press.
Button datasheetButton() {
  const auto press = StrokeCurve::fromKnots({{0, 0.35, 0.56, 0.56},
                                             {1.6, 0.65, 0, 0},
                                             {2, 0.5, 0, 0},
                                             {2.5, 0.56, 0.107, 0.107},
                                             {4, 0.72, 0.107, 0},
                                             {4, 0.98, 0, 0}});
  const auto release = StrokeCurve::fromKnots({{0, 0.22, 0.61, 0.61},
                                               {0.85, 0.42, 0, 0},
                                               {1.35, 0.24, 0, 0},
                                               {2.13, 0.5, 0.105, 0.105},
                                               {4, 0.7, 0.105, 0},
                                               {4, 0.98, 0, 0}});
  REQUIRE(press.ok());
  REQUIRE(release.ok());
  auto graph = ForceGraph::fromCurves(*press, *release);
  REQUIRE(graph.ok());
  auto button = Button::fromStates("datasheet", {{"", *std::move(graph), {}, {}, {}}});
  REQUIRE(button.ok());
  return *std::move(button);
}

TEST_CASE("a target moves what its figure is measured at, and nothing else") {
  const Button button = datasheetButton();
  const KeyFigures now = keyFiguresOf(button.states()[0]);
  const TargetOutcome outcome = bentToTargets(button, 0, {{KeyFigure::drop, 0.2}});
  REQUIRE(outcome.button);
  const ButtonState& bent = outcome.button->states()[0];
  const KeyFigures then = keyFiguresOf(bent);
  CHECK(*then[KeyFigure::drop] == Approx(0.2).margin(1e-5));
  CHECK(*then[KeyFigure::peakForce] > *now[KeyFigure::peakForce]);
  CHECK(*then[KeyFigure::valleyForce] < *now[KeyFigure::valleyForce]);
  for (const KeyFigure figure : {KeyFigure::peakTravel, KeyFigure::valleyTravel, KeyFigure::bottomOutForce,
                                 KeyFigure::bottomOutTravel, KeyFigure::totalTravel, KeyFigure::endForce})
    CHECK(*then[figure] == *now[figure]);
  const StrokeCurve &release = *button.states()[0].graph.release(), &after = *bent.graph.release();
  for (int i = 0; i <= 400; ++i)
    CHECK(after.force_N(0.01 * i) == Approx(release.force_N(0.01 * i)).margin(1e-12));
}

// The valley would lie below the release, which therefore moves; the stop stays all the same.
TEST_CASE("the stop stays where a target of another figure moves the release") {
  const Button button = datasheetButton();
  const KeyFigures now = keyFiguresOf(button.states()[0]);
  for (const FigureTarget target : {FigureTarget{KeyFigure::valleyForce, 0.45},
                                    {KeyFigure::hysteresis, 0.6},
                                    {KeyFigure::pressWork, 2.6},
                                    {KeyFigure::slopeToPeak, 0.25}}) {
    const TargetOutcome outcome = bentToTargets(button, 0, {target});
    REQUIRE(outcome.button);
    const KeyFigures then = keyFiguresOf(outcome.button->states()[0]);
    CHECK(missed(then, target) <= 1);
    for (const KeyFigure figure :
         {KeyFigure::bottomOutForce, KeyFigure::bottomOutTravel, KeyFigure::totalTravel, KeyFigure::endForce})
      CHECK(*then[figure] == *now[figure]);
  }
  CHECK(bentToTargets(button, 0, {{KeyFigure::totalTravel, 3.8}}).button);
  CHECK(bentToTargets(button, 0, {{KeyFigure::slopeToBottomOut, 0.15}}).button);
}
