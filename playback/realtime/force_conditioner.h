// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Between a sensor and the engine: what cannot be a reading is rejected and counted, so that the tracker only
// ever sees finite, ordered, plausible values. Same code for live sensors and recorded traces.

#include <cstdint>

namespace detent::playback {

/// What a reading may look like. Forces in N for a force sensor, mm for a displacement trace.
struct ConditionerSettings {
  double lowest = -2;   ///< below: out of range (an offset drift of an unloaded sensor still passes)
  double highest = 30;  ///< above: out of range; the mockup's sensor ends at 12 N
  double fastest_per_s =
      5000;                   ///< a step beyond this is believed only when the next reading confirms it; > 0
  double confirmBand = 0.25;  ///< a confirming reading lies within this share of the step
  double silentAfter_s = 0.25;  ///< no reading for longer: the sensor is silent
  double stuckAfter_s = 10;     ///< the same reading above `stuckAbove` for longer: the sensor is stuck
  double stuckAbove = 0.05;
};

/// Limits for a button whose strongest force is `strongest_N`: the defaults, widened for heavy buttons.
ConditionerSettings limitsFor(double strongest_N);

/// What was rejected so far.
struct ConditionerCounts {
  std::uint64_t accepted = 0;
  std::uint64_t notFinite = 0;
  std::uint64_t outOfRange = 0;
  std::uint64_t outOfOrder = 0;  ///< time not after the reading before
  std::uint64_t glitches = 0;    ///< single readings no finger can make
  std::uint64_t gaps = 0;        ///< silences that ended
};

enum class ConditionerVerdict : std::uint8_t {
  reject,  ///< drop it
  accept,  ///< pass it on
  resume   ///< pass it on as a new start: the readings before it are too old to connect to
};

/// Judges readings one by one. Pure function of its inputs; one owner, any thread; no allocation.
class ForceConditioner {
 public:
  explicit ForceConditioner(const ConditionerSettings& settings = {}) : settings_(settings) {}

  /// Keeps counts and history.
  void setSettings(const ConditionerSettings& settings) { settings_ = settings; }

  /// `time_s` on any steady clock, the same for all readings.
  ConditionerVerdict judge(double time_s, double value);

  const ConditionerCounts& counts() const { return counts_; }
  /// No accepted reading within the limit before `now_s` (or none at all).
  bool silent(double now_s) const;
  bool stuck() const { return stuck_; }

 private:
  ConditionerVerdict accept(double time_s, double value, bool resumed);

  ConditionerSettings settings_;
  ConditionerCounts counts_;
  double lastTime_s_ = 0, lastValue_ = 0;
  double sameSince_s_ = 0;
  double suspect_ = 0;
  bool any_ = false, suspected_ = false, stuck_ = false;
};

}  // namespace detent::playback
