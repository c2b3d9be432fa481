// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/magnetic/simulate_key.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "playback/performance/elementary.h"
#include "playback/performance/key_tables.h"

namespace detent::playback {

namespace {

constexpr double metre_mm = 1000;
constexpr double held_s = 60, shallow_mm = 0.1;
// Tremor of a held finger: 2 % of its force at 9 Hz, divided by the slope at that point.
constexpr double tremorShare = 0.02, tremor_Hz = 9, flattest_N_per_mm = 0.05;
constexpr std::uint64_t seed = 20;
constexpr int noiseScores = 1024;

/// The sensor as the firmware sees it: whole counts with noise, converted back to displacements.
class Readings {
 public:
  explicit Readings(const MagneticSensor& sensor) : sensor_(sensor), random_(seed) {
    noise_ = normalScores(noiseScores);
    for (double& score : noise_) score *= sensor.noise();
  }
  double sensed_mm(double displacement_mm) {
    return sensor_.displacement_mm(
        std::round(sensor_.reading(displacement_mm) + noise_[random_.next() % noise_.size()]));
  }

 private:
  const MagneticSensor& sensor_;
  FixedRandom random_;
  std::vector<double> noise_;  // quantiles of the noise in counts, equally likely
};

int eventsOf(const std::vector<double>& press_mm, Readings& readings, const MagneticKeySettings& settings) {
  MagneticKey key(settings);
  int events = 0;
  const double stepsPerScan = settings.scan_s / plantStep_s;
  for (double step = 0; step < static_cast<double>(press_mm.size()); step += stepsPerScan)
    events += key.follow(readings.sensed_mm(press_mm[static_cast<std::size_t>(step)]));
  return events;
}

double trembles_mm(const StrokeCurve& press, double depth_mm) {
  constexpr double beside_mm = 0.05;
  const double low_mm = std::max(press.start_mm(), depth_mm - beside_mm),
               high_mm = std::min(press.end_mm(), depth_mm + beside_mm);
  const double rise =
      high_mm > low_mm ? (press.force_N(high_mm) - press.forceBefore_N(low_mm)) / (high_mm - low_mm) : 0;
  return tremorShare * std::abs(press.force_N(depth_mm)) / std::max(std::abs(rise), flattest_N_per_mm);
}

/// Number of openings per minute of a key held at one depth.
double letsGo(const StrokeCurve& press, double depth_mm, Readings& readings,
              const MagneticKeySettings& settings) {
  const double amplitude_mm = trembles_mm(press, depth_mm);
  MagneticKey key(settings);
  key.follow(press.start_mm());
  key.follow(depth_mm);
  if (!key.closed()) return 0;
  int times = 0;
  for (double at_s = 0; at_s < held_s; at_s += settings.scan_s) {
    const double place_mm =
        std::min(depth_mm + amplitude_mm * std::sin(2 * std::numbers::pi * tremor_Hz * at_s), press.end_mm());
    const bool before = key.closed();
    key.follow(readings.sensed_mm(place_mm));
    times += before && !key.closed();
  }
  return times;
}

std::vector<double> inMillimetres(std::vector<double> depths_m) {
  for (double& depth : depths_m) depth *= metre_mm;
  return depths_m;
}

}  // namespace

std::optional<Result<PressedDepths>> PressedDepths::of(const Button& button, double actuate_mm,
                                                       const std::function<bool()>& cancelled) {
  ForecastSettings settings;
  settings.operateAt_mm = actuate_mm;
  const std::optional<PressForecast> forecast = forecastPress(button, settings, cancelled);
  if (!forecast) return {};
  const auto figure = static_cast<std::size_t>(PressFigure::rapidDoubles);
  if (forecast->ofFingers[figure].empty())
    return Failure{FailureCode::wrongUsage, button.name(), "",
                   "has no forecast of presses: " + std::string(reasonOf(forecast->why[figure])),
                   "Give a button with an operating point and a release curve"};
  const KeyTables key(button.states().front());
  const ContactPoints contact{*forecast->operatingPoint_mm / metre_mm, *forecast->resetPoint_mm / metre_mm};
  const std::vector<Finger> fingers = allFingers();
  const std::vector<double> scores = normalScores(pressesOfFinger);
  PressedDepths pressed;
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    PressCommand command = forecast->plans[i].command;
    const double planned_N = command.amplitude_N;
    const double spread_N = amplitudeSpread_N(fingers[i], planned_N);
    for (const double score : scores) {
      command.amplitude_N = std::max(1e-3, planned_N + score * spread_N);
      pressed.presses_mm_.push_back(inMillimetres(depthsOfPress(key, contact, fingers[i], command)));
    }
  }
  return pressed;
}

MagneticKeyForecast forecastKey(const PressedDepths& presses, const Button& button,
                                const MagneticSensor& sensor, const MagneticKeySettings& settings) {
  constexpr double thousand = 1000;
  Readings readings(sensor);
  MagneticKeyForecast forecast;
  forecast.settings = settings;
  for (const std::vector<double>& press_mm : presses.presses_mm()) {
    const int events = eventsOf(press_mm, readings, settings);
    forecast.lost_per_1000 += events == 0;
    forecast.doubled_per_1000 += events > 1;
  }
  const double perPress = thousand / static_cast<double>(presses.presses_mm().size());
  forecast.lost_per_1000 *= perPress;
  forecast.doubled_per_1000 *= perPress;
  const StrokeCurve& press = button.states().front().graph.press();
  forecast.letsGo_per_minute = letsGo(press, press.end_mm(), readings, settings);
  forecast.letsGoShallow_per_minute =
      letsGo(press, std::min(press.end_mm(), settings.actuate_mm + shallow_mm), readings, settings);
  return forecast;
}

}  // namespace detent::playback
