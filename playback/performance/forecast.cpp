// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/forecast.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "model/check.h"
#include "model/sections.h"
#include "playback/performance/timed_press.h"

namespace detent::playback {

namespace {

constexpr double metre_mm = 1000;
// distance from operating point to reset point if the button has none
constexpr double usualDifferential_mm = 0.1;
// least force of a key: with less, only the finger's own weight would press
constexpr double leastForce_N = 0.02;
constexpr double feltDrop = 0.07;  // share of the peak force: Weber fraction of force for a finger
constexpr double feltDrop_N = 0.02;

bool jumpIsFelt(const StrokeCurve& press, double close_mm) {
  for (const TactilePoint& peak : tactilePoints(press, Stroke::press)) {
    if (peak.displacement_mm <= close_mm &&
        peak.prominence_N >= std::max(feltDrop_N, feltDrop * peak.force_N))
      return true;
  }
  return false;
}

void refuse(PressForecast& forecast, NoForecast why) { forecast.why.fill(why); }

void refuse(PressForecast& forecast, NoForecast why, std::initializer_list<PressFigure> figures) {
  for (const PressFigure figure : figures) {
    forecast.ofFingers[static_cast<std::size_t>(figure)].clear();
    forecast.why[static_cast<std::size_t>(figure)] = why;
  }
}

/// Sets operating and reset point; returns the reason if a forecast is impossible without them.
NoForecast placeContact(const ButtonState& state, const ForecastSettings& settings, PressForecast& forecast) {
  const std::optional<double> close_mm =
      settings.operateAt_mm ? settings.operateAt_mm : state.operatingPoint_mm;
  if (!close_mm) return NoForecast::noOperatingPoint;
  if (*close_mm <= state.graph.press().start_mm() || *close_mm > state.graph.travel_mm())
    return NoForecast::operatingPointOutside;
  double differential_mm = usualDifferential_mm;
  if (state.operatingPoint_mm && state.resetPoint_mm)
    differential_mm = std::max(0.0, *state.operatingPoint_mm - *state.resetPoint_mm);
  forecast.operatingPoint_mm = close_mm;
  forecast.resetPoint_mm = std::max(0.0, *close_mm - differential_mm);
  double most_N = 0;
  for (const Knot& knot : state.graph.press().knots()) most_N = std::max(most_N, knot.force_N);
  return most_N < leastForce_N ? NoForecast::tooLight : NoForecast::none;
}

double valueOf(const FingerPlan& plan, PressFigure figure) {
  constexpr double thousand = 1000;
  const PressStatistics& s = plan.result;
  switch (figure) {
    case PressFigure::peakForce:
      return s.peak_N;
    case PressFigure::impulse:
      return s.impulse_Ns;
    case PressFigure::activation:
      return s.activation_s;
    case PressFigure::activationSpread:
      return s.activationSpread_s;
    case PressFigure::misses:
      return thousand * s.missed;
    case PressFigure::doubles:
      return thousand * s.doubled;
    case PressFigure::accidental:
      return thousand * plan.accidental;
    case PressFigure::highestRate:
      return plan.highestRate_per_s;
    case PressFigure::timePerPress:
      return plan.timePerCorrectPress_s;
    case PressFigure::timedMisses:
      return thousand * timedPressError(timedWindow_s, timedInterval_s, s.activationSpread_s);
    case PressFigure::held:
      return s.held_s;
    case PressFigure::rapidHeld:
      return s.rapidHeld_s;
    case PressFigure::rapidDoubles:
      return thousand * s.rapidDoubled;
  }
  DETENT_CHECK(false, "a figure of the enum");
  return 0;
}

using Plans = std::vector<std::optional<FingerPlan>>;

/// Fingers are planned independently, so the number of threads changes only the time.
Plans planAll(const KeyTables& key, const PressTask& task, unsigned threads,
              const std::function<bool()>& cancelled) {
  const std::vector<Finger> fingers = allFingers();
  Plans plans(fingers.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stop = false;
  const auto work = [&](bool asks) {
    for (std::size_t i = next++; i < fingers.size() && !stop; i = next++) {
      plans[i] = planPress(key, fingers[i], task);
      if (asks && cancelled && cancelled()) stop = true;
    }
  };
  std::vector<std::jthread> others;
  const unsigned wanted = threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
  for (unsigned i = 1; i < std::min<unsigned>(wanted, fingerCount); ++i) others.emplace_back(work, false);
  work(true);
  others.clear();
  if (stop) plans.clear();
  return plans;
}

void fillIn(PressForecast& forecast) {
  for (std::size_t f = 0; f < pressFigureCount; ++f)
    for (const FingerPlan& plan : forecast.plans)
      forecast.ofFingers[f].push_back(valueOf(plan, static_cast<PressFigure>(f)));
}

}  // namespace

const std::array<PressFigureName, pressFigureCount>& pressFigureNames() {
  static const std::array<PressFigureName, pressFigureCount> names = {{
      {"peak_force_N", "peak force, N", false},
      {"impulse_Ns", "impulse, N s", false},
      {"activation_s", "touch to activation, s", false},
      {"activation_sd_s", "its spread, s", false},
      {"misses_per_1000", "misses per 1,000", true},
      {"doubles_per_1000", "doubles per 1,000", true},
      {"accidental_per_1000", "accidental per 1,000 rests", true},
      {"highest_rate_per_s", "highest rate, presses/s", false},
      {"time_per_press_s", "time per correct press, s", false},
      {"timed_misses_per_1000", "misses of a 100 ms window per 1,000", true},
      {"held_s", "contact closed, s", false},
      {"rapid_trigger_held_s", "the same, rapid trigger, s", false},
      {"rapid_trigger_doubles_per_1000", "doubles per 1,000, rapid trigger", true},
  }};
  return names;
}

const char* reasonOf(NoForecast reason) {
  switch (reason) {
    case NoForecast::none:
      return "";
    case NoForecast::noOperatingPoint:
      return "the button has no operating point; give one with --operate-at MM";
    case NoForecast::operatingPointOutside:
      return "the operating point is not within the travel; give one that is";
    case NoForecast::tooLight:
      return "its force stays below 0.02 N: the finger's own weight is all there is";
    case NoForecast::tooHeavy:
      return "30 N of muscle do not close its contact for every finger";
    case NoForecast::noRelease:
      return "it has no release curve: nothing says what the way up is like";
    case NoForecast::selfLocking:
      return "it locks: one cycle takes two presses, and only the first is forecast";
  }
  return "";
}

Band bandOf(std::vector<double> values) {
  DETENT_CHECK(!values.empty(), "a band of at least one value");
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), values.size() - 1);
    const std::size_t j = std::min(i + 1, values.size() - 1);
    return values[i] + (place - static_cast<double>(i)) * (values[j] - values[i]);
  };
  return {at(0.5), at(0.05), at(0.95)};
}

std::optional<PressForecast> forecastPress(const Button& button, const ForecastSettings& settings,
                                           const std::function<bool()>& cancelled) {
  const ButtonState& state = button.states().front();
  PressForecast forecast;
  forecast.name = button.name();
  if (const NoForecast why = placeContact(state, settings, forecast); why != NoForecast::none) {
    refuse(forecast, why);
    return forecast;
  }
  forecast.jumpIsFelt = jumpIsFelt(state.graph.press(), *forecast.operatingPoint_mm);
  const KeyTables key(state);
  const PressTask task{{*forecast.operatingPoint_mm / metre_mm, *forecast.resetPoint_mm / metre_mm},
                       forecast.jumpIsFelt,
                       settings.period_s};
  const Plans plans = planAll(key, task, settings.threads, cancelled);
  if (plans.empty()) return {};
  for (const std::optional<FingerPlan>& plan : plans) {
    if (plan) forecast.plans.push_back(*plan);
  }
  if (forecast.plans.size() !=
      plans.size()) {  // a band over only some of the fingers would describe another population
    forecast.plans.clear();
    refuse(forecast, NoForecast::tooHeavy);
    return forecast;
  }
  fillIn(forecast);
  const std::initializer_list<PressFigure> ofTheWayUp = {
      PressFigure::doubles, PressFigure::highestRate, PressFigure::timePerPress,
      PressFigure::held,    PressFigure::rapidHeld,   PressFigure::rapidDoubles};
  if (!state.graph.release()) refuse(forecast, NoForecast::noRelease, ofTheWayUp);
  if (button.selfLocking()) refuse(forecast, NoForecast::selfLocking, ofTheWayUp);
  return forecast;
}

Claim claimOf(const Band& ratio) {
  const double high = 1 + claimedFrom, low = 1 - claimedFrom;
  if (ratio.low >= high) return Claim::higher;
  if (ratio.high <= low) return Claim::lower;
  return ratio.median > low && ratio.median < high ? Claim::noDifference : Claim::notDecided;
}

PressDifference differenceOf(const PressForecast& first, const PressForecast& second, PressFigure figure) {
  const std::vector<double>&a = first[figure], &b = second[figure];
  if (a.empty() || b.empty()) return {};
  const double added = pressFigureNames()[static_cast<std::size_t>(figure)].ofThousand ? 1 : 0;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] + added <= 0) return {};
    ratios.push_back((b[i] + added) / (a[i] + added));
  }
  const Band ratio = bandOf(std::move(ratios));
  return {claimOf(ratio), ratio};
}

}  // namespace detent::playback
