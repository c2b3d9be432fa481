// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Public interface of this folder: a button in; the results of 64 simulated fingers, and differences between
// two buttons, out. Reading order: elementary.h, fingers.h, key_tables.h, press_plant.h, press_response.h,
// press_policy.h, forecast.h, timed_press.h, limits.h. Model, parameters and known errors:
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
  bool ofThousand;   ///< a rate per 1,000 presses; compared after adding 1
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
  operatingPointOutside,  ///< the operating point is not within the travel
  tooLight,               ///< lighter than a finger can feel
  tooHeavy,               ///< some finger cannot close the contact
  noRelease,              ///< the button has no release curve
  /// a self-locking button: one press locks and the next unlocks, so rates and doubles have no meaning
  selfLocking
};
/// "the button has no operating point; give one with --operate-at".
const char* reasonOf(NoForecast reason);

/// Figures of one button: for each finger, in the order of allFingers(), and their band.
struct PressForecast {
  std::string name;
  std::optional<double> operatingPoint_mm, resetPoint_mm;
  bool jumpIsFelt = false;
  std::array<std::vector<double>, pressFigureCount> ofFingers;  ///< empty: no forecast, see `why`
  std::array<NoForecast, pressFigureCount> why{};
  std::vector<FingerPlan> plans;  ///< plan of each finger; empty if none was forecast

  const std::vector<double>& operator[](PressFigure f) const {
    return ofFingers[static_cast<std::size_t>(f)];
  }
};

struct ForecastSettings {
  /// operating point to use instead; the reset point keeps its distance from it
  std::optional<double> operateAt_mm;
  std::optional<double> period_s;  ///< paced task; > 0
  unsigned threads = 0;            ///< 0: one per core; the result does not depend on it
};

/// Simulates all fingers. Empty after `cancelled` returned true.
std::optional<PressForecast> forecastPress(const Button& button, const ForecastSettings& settings = {},
                                           const std::function<bool()>& cancelled = {});

/// A smaller median difference supports no claim.
inline constexpr double claimedFrom = 0.15;

enum class Claim { notForecast, noDifference, higher, lower, notDecided };

/// Ratio of the second button to the first, finger by finger.
struct PressDifference {
  Claim claim = Claim::notForecast;
  Band ratio;  ///< second : first
};
PressDifference differenceOf(const PressForecast& first, const PressForecast& second, PressFigure figure);

/// The claim that a band of ratios supports.
Claim claimOf(const Band& ratio);

}  // namespace detent::playback
