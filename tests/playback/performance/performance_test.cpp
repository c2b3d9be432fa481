// SPDX-License-Identifier: GPL-3.0-or-later
// The forecast of a press: its plant keeps the books of energy, its closed forms agree with chance, and what
// cannot be forecast is said.
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

#include "model/templates.h"
#include "playback/performance/elementary.h"
#include "playback/performance/forecast.h"
#include "playback/performance/timed_press.h"

namespace detent::test {

using namespace detent::playback;

namespace {

Button made(const Result<Button>& button) {
  if (!button) throw std::runtime_error(button.failure().sentence());
  return *button;
}

/// A linear key whose forces are so many times the template's.
Button scaled(double factor) {
  LinearTemplate values;
  values.startForce_N *= factor;
  values.endForce_N *= factor;
  values.hysteresis_N *= factor;
  return made(linearButton(values));
}

bool refusedFor(const PressForecast& forecast, PressFigure figure, NoForecast why) {
  return forecast[figure].empty() && forecast.why[static_cast<std::size_t>(figure)] == why;
}

}  // namespace

TEST_CASE("press forecast: own functions agree with the mathematics library") {
  for (const double x : {-20.0, -1.0, -1e-6, 0.0, 0.3, 5.0, 80.0})
    CHECK(exponential(x) == Approx(std::exp(x)).epsilon(1e-13));
  for (const double x : {0.0, 0.1, 0.8, 1.5}) {
    CHECK(sineAndCosine(x).sine == Approx(std::sin(x)).margin(1e-15));
    CHECK(sineAndCosine(x).cosine == Approx(std::cos(x)).margin(1e-15));
  }
  for (const double x : {-3.0, -0.2, 0.0, 0.7, 2.5, 5.5})
    CHECK(errorFunction(x) == Approx(std::erf(x)).margin(1e-14));
  CHECK(normalScore(0.975) == Approx(1.959963984540054).epsilon(1e-12));
}

TEST_CASE(
    "press plant: works and energies agree to 1e-6 for every finger, and nothing is given by what takes") {
  const Button button = made(clickyButton());
  const KeyTables key(button.states().front());
  for (const Finger& finger : allFingers()) {
    for (const double amplitude_N : {1.0, 4.0, 12.0}) {
      PressEnergy energy;
      (void)simulatePress(key, {0.0019, 0.0011}, finger, {amplitude_N, 0.08, 0}, &energy);
      const double left_J = energy.muscle_J - energy.taken_J - energy.stored_J;
      CHECK(std::abs(left_J) <= 1e-6 * energy.moved_J);
      CHECK(energy.taken_J >= 0);
    }
  }
}

TEST_CASE("press plant: two presses at once are each to the last bit what it is alone") {
  for (const Button& button : {made(clickyButton()), scaled(1), scaled(20)}) {
    const KeyTables key(button.states().front());
    const ContactPoints contact{0.0019, 0.0011};
    for (const Finger& finger : allFingers()) {
      for (const double amplitude_N : {0.3, 1.5, 7.0}) {
        const std::array<PressCommand, 2> commands = {
            {{amplitude_N, 0.08, 0}, {1.7 * amplitude_N, 0.065, -0.02}}};
        const std::array<PressOutcome, 2> outcomes = simulatePresses(key, contact, finger, commands);
        for (const std::size_t i : {0U, 1U}) {
          const PressOutcome alone = simulatePress(key, contact, finger, commands[i]);
          CHECK(outcomes[i].touch_s == alone.touch_s);
          CHECK(outcomes[i].activation_s == alone.activation_s);
          CHECK(outcomes[i].opening_s == alone.opening_s);
          CHECK(outcomes[i].rapidOpening_s == alone.rapidOpening_s);
          CHECK(outcomes[i].closings == alone.closings);
          CHECK(outcomes[i].peak_N == alone.peak_N);
          CHECK(outcomes[i].impulse_Ns == alone.impulse_Ns);
          CHECK(outcomes[i].deepest_m == alone.deepest_m);
          CHECK(outcomes[i].end_s == alone.end_s);
        }
      }
    }
  }
}

TEST_CASE("press plant: what stops at the contact says what the whole press does") {
  const Button button = made(clickyButton());
  const KeyTables key(button.states().front());
  for (const Finger& finger : allFingers())
    for (double amplitude_N = 0.2; amplitude_N < 8; amplitude_N *= 1.15)
      for (const double lift_s : {-0.02, 0.02}) {
        const PressCommand command{amplitude_N, 0.08, lift_s};
        CHECK(closesContact(key, {0.0019, 0.0011}, finger, command) ==
              simulatePress(key, {0.0019, 0.0011}, finger, command).activation_s.has_value());
      }
}

TEST_CASE("press forecast: a timed press in closed form is that of 20,000 chances") {
  FixedRandom random(7);
  for (const double button_s : {0.0, 0.02}) {
    constexpr int presses = 20000;
    int missed = 0;
    for (int i = 0; i < presses; ++i) {
      const double at_s = 0.185 * 0.1 + 0.045 * random.normal() + button_s * random.normal();
      missed += at_s < 0 || at_s > 0.1 ? 1 : 0;
    }
    const double share = timedPressError(0.1, 0.5, button_s);
    const double error = std::sqrt(share * (1 - share) / presses);
    CHECK(std::abs(static_cast<double>(missed) / presses - share) <= 3 * error);
  }
}

TEST_CASE("press forecast: a timed press is never missed less than never") {
  for (const double window_s : {0.2, 0.25, 0.3, 0.5, 2.0})
    CHECK(timedPressError(window_s, 0.4, 0, {0.5, 0.04}) >= 0);
}

TEST_CASE("press forecast: the same for any number of threads, and a stiffer key takes more force") {
  ForecastSettings one, three;
  one.threads = 1;
  three.threads = 3;
  const std::optional<PressForecast> light = forecastPress(scaled(1), one),
                                     again = forecastPress(scaled(1), three);
  const std::optional<PressForecast> heavy = forecastPress(scaled(3));
  REQUIRE(light);
  REQUIRE(again);
  REQUIRE(heavy);
  CHECK(light->ofFingers == again->ofFingers);
  CHECK(differenceOf(*light, *heavy, PressFigure::peakForce).claim == Claim::higher);
  CHECK(differenceOf(*light, *light, PressFigure::peakForce).claim == Claim::noDifference);
}

TEST_CASE("press forecast: what cannot be forecast is said") {
  LinearTemplate pointless;
  pointless.operatingPoint_mm.reset();
  pointless.resetPoint_mm.reset();
  const std::optional<PressForecast> none = forecastPress(made(linearButton(pointless)));
  CHECK(refusedFor(*none, PressFigure::peakForce, NoForecast::noOperatingPoint));
  CHECK(refusedFor(*forecastPress(scaled(1e-6)), PressFigure::misses, NoForecast::tooLight));
  CHECK(refusedFor(*forecastPress(scaled(200)), PressFigure::peakForce, NoForecast::tooHeavy));
  ForecastSettings deep;
  deep.operateAt_mm = 9;
  CHECK(refusedFor(*forecastPress(scaled(1), deep), PressFigure::misses, NoForecast::operatingPointOutside));
}

}  // namespace detent::test
