// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/page/button_numbers.h"

#include <cmath>
#include <limits>
#include <utility>

namespace detent::playback {

namespace {

constexpr std::size_t numbersPerKnot = 4;

void append(const std::vector<Knot>& knots, std::vector<double>& numbers) {
  for (const Knot& k : knots)
    numbers.insert(numbers.end(),
                   {k.displacement_mm, k.force_N, k.slopeBefore_N_per_mm, k.slopeAfter_N_per_mm});
}

double orNone(const std::optional<double>& place_mm) {
  return place_mm.value_or(std::numeric_limits<double>::quiet_NaN());
}

Failure notAButton() {
  return {FailureCode::unreadableInput, "button numbers", "", "are not what numbersOf writes",
          "Write the page anew"};
}

/// Reads a row of numbers from the front, and records whether it ran out.
class NumberReader {
 public:
  explicit NumberReader(const std::vector<double>& numbers) : numbers_(numbers) {}

  double next() {
    if (at_ < numbers_.size()) return numbers_[at_++];
    complete_ = false;
    return 0;
  }
  std::size_t count(std::size_t most) {
    const double value = next();
    if (value >= 0 && value <= static_cast<double>(most) && value == std::floor(value))
      return static_cast<std::size_t>(value);
    complete_ = false;
    return 0;
  }
  std::optional<double> place_mm() {
    const double value = next();
    return std::isnan(value) ? std::nullopt : std::optional(value);
  }
  std::vector<Knot> knots(std::size_t count) {
    if (count > (numbers_.size() - at_) / numbersPerKnot) {
      complete_ = false;
      return {};
    }
    std::vector<Knot> knots(count);
    for (Knot& k : knots) {
      k.displacement_mm = next();
      k.force_N = next();
      k.slopeBefore_N_per_mm = next();
      k.slopeAfter_N_per_mm = next();
    }
    return knots;
  }
  bool complete() const { return complete_; }
  bool atEnd() const { return at_ == numbers_.size(); }

 private:
  const std::vector<double>& numbers_;
  std::size_t at_ = 0;
  bool complete_ = true;
};

Result<ForceGraph> graphFrom(NumberReader& reader) {
  const std::size_t pressCount = reader.count(StrokeCurve::maxKnots),
                    releaseCount = reader.count(StrokeCurve::maxKnots);
  const std::vector<Knot> pressKnots = reader.knots(pressCount), releaseKnots = reader.knots(releaseCount);
  if (!reader.complete()) return notAButton();
  Result<StrokeCurve> press = StrokeCurve::fromKnots(pressKnots);
  if (!press) return press.failure();
  std::optional<StrokeCurve> release;
  if (!releaseKnots.empty()) {
    Result<StrokeCurve> curve = StrokeCurve::fromKnots(releaseKnots);
    if (!curve) return curve.failure();
    release = std::move(*curve);
  }
  return ForceGraph::fromCurves(std::move(*press), std::move(release));
}

Result<ButtonState> stateFrom(NumberReader& reader, std::string name) {
  const auto operating_mm = reader.place_mm(), reset_mm = reader.place_mm();
  Result<ForceGraph> graph = graphFrom(reader);
  if (!graph) return graph.failure();
  return ButtonState{std::move(name), std::move(*graph), operating_mm, reset_mm, {}};
}

Result<Done> addSpeeds(NumberReader& reader, std::vector<ButtonState>& states) {
  const std::size_t others = reader.count(Button::mostSpeeds - 1);
  const double own_mm_per_s = reader.next();
  for (ButtonState& state : states) {
    state.speed_mm_per_s = own_mm_per_s;
    for (std::size_t i = 0; i < others; ++i) {
      const double speed_mm_per_s = reader.next();
      Result<ForceGraph> graph = graphFrom(reader);
      if (!graph) return graph.failure();
      state.otherSpeeds.push_back({speed_mm_per_s, std::move(*graph)});
    }
  }
  return Done{};
}

void append(const ForceGraph& graph, std::vector<double>& numbers) {
  const std::optional<StrokeCurve>& release = graph.release();
  numbers.insert(numbers.end(), {static_cast<double>(graph.press().knots().size()),
                                 release ? static_cast<double>(release->knots().size()) : 0.0});
  append(graph.press().knots(), numbers);
  if (release) append(release->knots(), numbers);
}

}  // namespace

std::vector<double> numbersOf(const Button& button) {
  std::vector<double> numbers{static_cast<double>(button.states().size())};
  for (const ButtonState& state : button.states()) {
    numbers.insert(numbers.end(), {orNone(state.operatingPoint_mm), orNone(state.resetPoint_mm)});
    append(state.graph, numbers);
  }
  const ButtonState& first = button.states().front();
  if (!first.speed_mm_per_s) return numbers;
  numbers.insert(numbers.end(), {static_cast<double>(first.otherSpeeds.size()), *first.speed_mm_per_s});
  for (const ButtonState& state : button.states())
    for (const SpeedGraph& other : state.otherSpeeds) {
      numbers.push_back(other.speed_mm_per_s);
      append(other.graph, numbers);
    }
  return numbers;
}

Result<Button> buttonFrom(const std::vector<double>& numbers) {
  constexpr std::size_t mostStates = 2;
  NumberReader reader(numbers);
  std::vector<ButtonState> states;
  const std::size_t count = reader.count(mostStates);
  for (std::size_t i = 0; i < count; ++i) {
    Result<ButtonState> state = stateFrom(reader, count == 1 ? "" : i == 0 ? "unlocked" : "locked");
    if (!state) return state.failure();
    states.push_back(std::move(*state));
  }
  if (states.empty() || !reader.complete()) return notAButton();
  if (!reader.atEnd())
    if (Result<Done> added = addSpeeds(reader, states); !added) return added.failure();
  if (!reader.complete() || !reader.atEnd()) return notAButton();
  return Button::fromStates("", std::move(states));
}

}  // namespace detent::playback
