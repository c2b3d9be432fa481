// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/magnetic/magnetic_key.h"

#include <algorithm>
#include <cmath>

#include "model/number_table.h"

namespace detent::playback {

namespace {

MessageValue length(double mm) { return {mm, Measure::displacement_mm}; }

std::optional<Failure> distanceTrouble(Subject distance, double distance_mm, double travel_mm) {
  if (!(distance_mm > 0))
    return Failure{FailureCode::wrongUsage, std::move(distance), "",
                   Message("%1 is not greater than 0", length(distance_mm)),
                   Message("Set a distance, or turn rapid trigger off")};
  if (!(distance_mm <= travel_mm))
    return Failure{FailureCode::wrongUsage, std::move(distance), "",
                   Message("%1 is longer than the travel, %2", length(distance_mm), length(travel_mm)),
                   Message("Set at most %1", length(travel_mm))};
  return {};
}

}  // namespace

std::string textOf(const std::optional<RapidTrigger>& rapid) {
  if (!rapid) return "off";
  std::string text = shortestText(rapid->press_mm);
  if (rapid->release_mm != rapid->press_mm) text += "/" + shortestText(rapid->release_mm);
  return text + " mm";
}

MagneticKeySettings settingsFor(const ButtonState& state, double actuate_mm) {
  constexpr double usualDifferential_mm = 0.1;
  MagneticKeySettings settings;
  settings.actuate_mm = actuate_mm;
  const double measured_mm = state.operatingPoint_mm && state.resetPoint_mm
                                 ? *state.operatingPoint_mm - *state.resetPoint_mm
                                 : usualDifferential_mm;
  // A contact may open where it closes; rapid trigger needs two points.
  const double differential_mm = measured_mm > 0 ? measured_mm : usualDifferential_mm;
  settings.reset_mm = std::max(0.0, actuate_mm - differential_mm);
  settings.travel_mm = state.graph.travel_mm();
  return settings;
}

Result<Done> checked(const MagneticKeySettings& s) {
  if (!(s.actuate_mm <= s.travel_mm))
    return Failure{FailureCode::wrongUsage, "actuation point", "",
                   Message("%1 lies beyond the travel, %2", length(s.actuate_mm), length(s.travel_mm)),
                   Message("Set at most %1", length(s.travel_mm))};
  if (!(s.reset_mm >= 0 && s.reset_mm < s.actuate_mm))
    return Failure{FailureCode::wrongUsage, "release point", "",
                   Message("%1 does not lie between rest and the actuation point, %2", length(s.reset_mm),
                           length(s.actuate_mm)),
                   Message("Set less than %1", length(s.actuate_mm))};
  if (s.rapid) {
    if (auto trouble = distanceTrouble("press distance", s.rapid->press_mm, s.travel_mm)) return *trouble;
    if (auto trouble = distanceTrouble("release distance", s.rapid->release_mm, s.travel_mm)) return *trouble;
  }
  if (!(s.topDeadZone_mm >= 0 && s.topDeadZone_mm <= s.reset_mm))
    return Failure{FailureCode::wrongUsage, "top dead zone", "",
                   Message("the top dead zone of %1 is not between 0 and the release point, which is at %2",
                           length(s.topDeadZone_mm), length(s.reset_mm)),
                   Message("Set at most %1, or move the release point down", length(s.reset_mm))};
  const double longestBottom_mm = s.travel_mm - s.actuate_mm;
  if (!(s.bottomDeadZone_mm >= 0 && s.bottomDeadZone_mm <= longestBottom_mm))
    return Failure{
        FailureCode::wrongUsage, "bottom dead zone", "",
        Message("the bottom dead zone of %1 is not between 0 and %2, the distance from the actuation "
                "point to the end of the travel",
                length(s.bottomDeadZone_mm), length(longestBottom_mm)),
        Message("Set at most %1, or move the actuation point up", length(longestBottom_mm))};
  return Done{};
}

/// Displacement at and above which the key is open and rapid trigger ends.
double MagneticKey::rapidEnds_mm() const {
  return rapidActive_ && settings_.rapid->continuous ? settings_.topDeadZone_mm : settings_.reset_mm;
}

bool MagneticKey::shouldClose(double displacement_mm) const {
  if (!rapidActive_) return displacement_mm >= settings_.actuate_mm;
  return displacement_mm >= turn_mm_ + settings_.rapid->press_mm &&
         (settings_.rapid->continuous || displacement_mm >= settings_.actuate_mm);
}

bool MagneticKey::shouldOpen(double displacement_mm) const {
  return displacement_mm <= rapidEnds_mm() ||
         (rapidActive_ && displacement_mm <= turn_mm_ - settings_.rapid->release_mm);
}

bool MagneticKey::follow(double displacement_mm) {
  turn_mm_ = closed_ ? std::max(turn_mm_, displacement_mm) : std::min(turn_mm_, displacement_mm);
  const bool atBottom =
      settings_.bottomDeadZone_mm > 0 && displacement_mm >= settings_.travel_mm - settings_.bottomDeadZone_mm;
  const bool changes =
      closed_ ? !atBottom && shouldOpen(displacement_mm) : atBottom || shouldClose(displacement_mm);
  if (displacement_mm <= rapidEnds_mm()) rapidActive_ = false;
  if (!changes) return false;
  closed_ = !closed_;
  if (closed_) rapidActive_ = settings_.rapid.has_value();
  turn_mm_ = displacement_mm;
  return closed_;
}

std::vector<KeyEvent> eventsAlong(const std::vector<double>& turns_mm, const MagneticKeySettings& settings) {
  constexpr double step_mm = 0.001;
  std::vector<KeyEvent> events;
  MagneticKey key(settings);
  double path_mm = 0;
  for (std::size_t i = 1; i < turns_mm.size(); ++i) {
    const double leg_mm = turns_mm[i] - turns_mm[i - 1];
    const double steps = std::min(std::ceil(std::abs(leg_mm) / step_mm), double{largestLeg_steps});
    for (double step = 0; step <= steps && steps > 0; ++step) {
      const double place_mm = std::lerp(turns_mm[i - 1], turns_mm[i], step / steps);
      const bool before = key.closed();
      key.follow(place_mm);
      if (key.closed() != before)
        events.push_back({path_mm + std::abs(place_mm - turns_mm[i - 1]), place_mm, key.closed()});
    }
    path_mm += std::abs(leg_mm);
  }
  return events;
}

}  // namespace detent::playback
