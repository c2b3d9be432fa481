// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Front of the room: a button in, what 64 simulated fingers make of it out, and how two buttons differ.
// Reading order: elementary.h, fingers.h, key_tables.h, press_plant.h, press_response.h, press_policy.h,
// forecast.h, timed_press.h, limits.h. Model, parameters and where the forecast was wrong:
// docs/reference/press-forecast.md.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/button.h"
#include "playback/performance/press_policy.h"

namespace detent::playback {

/// The forecast figures, in the order of the table.
enum class PressFigure {
  peakForce,
  impulse,
  activation,
  activationSpread,
  misses,
  doubles,
  accidental,
  highestRate,
  timePerPress,
  timedMisses,
  held,
  rapidHeld,
  rapidDoubles
};
inline constexpr std::size_t pressFigureCount = static_cast<std::size_t>(PressFigure::rapidDoubles) + 1;

/// Name of a figure. Strings have static lifetime.
struct PressFigureName {
  const char* key;   ///< "peak_force_N": for programs; ends in the unit
  const char* term;  ///< "peak force, N"
  bool ofThousand;   ///< a rate per 1,000 presses: compared with 1 added
};
const std::array<PressFigureName, pressFigureCount>& pressFigureNames();

/// Median and 5 to 95 % of the fingers.
struct Band {
  double median = 0, low = 0, high = 0;
};
Band bandOf(std::vector<double> values);  ///< not empty (checked)

/// A window of a timed press in the forecast: 100 ms, cued half a second ahead.
inline constexpr double timedWindow_s = 0.1, timedInterval_s = 0.5;

/// The reason why a figure is not forecast.
enum class NoForecast {
  none,
  noOperatingPoint,
  operatingPointOutside,  ///< not within the travel
  tooLight,               ///< below what a finger feels
  tooHeavy,               ///< some finger cannot close the contact
  noRelease,              ///< nothing says what the way up is like
  selfLocking             ///< one press in two locks: no rate, no doubles
};
/// "the button has no operating point; give one with --operate-at".
const char* reasonOf(NoForecast reason);

/// Figures of one button: of each finger, in the order of allFingers(), and their band.
struct PressForecast {
  std::string name;
  std::optional<double> operatingPoint_mm, resetPoint_mm;
  bool jumpIsFelt = false;
  std::array<std::vector<double>, pressFigureCount> ofFingers;  ///< empty: not forecast, see `why`
  std::array<NoForecast, pressFigureCount> why{};
  std::vector<PressPlan> plans;  ///< of each finger; empty where none was forecast

  const std::vector<double>& operator[](PressFigure f) const {
    return ofFingers[static_cast<std::size_t>(f)];
  }
};

struct ForecastSettings {
  std::optional<double> operateAt_mm;  ///< act here instead; the reset point keeps its distance
  std::optional<double> period_s;      ///< paced task; > 0
  unsigned threads = 0;  ///< 0: as many as there are cores; the result is the same for any number
};

/// Asks all fingers. Empty where `cancelled` said so.
std::optional<PressForecast> forecastPress(const Button& button, const ForecastSettings& settings = {},
                                           const std::function<bool()>& cancelled = {});

/// Below this in the median nothing is claimed.
inline constexpr double claimedFrom = 0.15;

enum class Claim { notForecast, noDifference, higher, lower, notDecided };

/// Ratio of the second button to the first, finger by finger.
struct PressDifference {
  Claim claim = Claim::notForecast;
  Band ratio;  ///< second : first
};
PressDifference differenceOf(const PressForecast& first, const PressForecast& second, PressFigure figure);

/// The claim a band of ratios supports.
Claim claimOf(const Band& ratio);

}  // namespace detent::playback
