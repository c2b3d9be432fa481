// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Between a sensor and the engine: impossible readings are rejected and counted, so that the tracker only
// receives finite, ordered, plausible values. The same code is used for live sensors and recorded traces.

#include <cstdint>

#include "playback/realtime/force_steadier.h"
#include "playback/realtime/haptic_program.h"
#include "playback/realtime/rest_band.h"

namespace detent::playback {

/// Limits of valid readings. Forces in N for a force sensor, mm for a displacement trace.
struct ConditionerSettings {
  double lowest = -2;           ///< below: out of range (the offset drift of an unloaded sensor still passes)
  double highest = 30;          ///< above: out of range; the mockup's sensor ends at 12 N
  double fastest_per_s = 5000;  ///< a faster step is accepted only if the next reading confirms it; > 0
  double confirmBand = 0.25;    ///< a confirming reading lies within this share of the step
  double silentAfter_s = 0.25;  ///< no reading for longer: the sensor is silent
  double stuckAfter_s = 10;     ///< the same reading above `stuckAbove` for longer: the sensor is stuck
  double stuckAbove = 0.05;
  double knownNoise = 0;  ///< SD of the sensor at rest; 0: unknown, so it is measured as readings arrive
  double mostNoise = 0;   ///< a larger SD, or swing, counts as movement; 0: readings are passed on unchanged
};

/// Limits for forces on this program's button: the defaults, widened for heavy buttons, with its sensor's
/// noise.
ConditionerSettings limitsFor(const HapticProgram& program);

/// Rejected readings so far.
struct ConditionerCounts {
  std::uint64_t accepted = 0;
  std::uint64_t notFinite = 0;
  std::uint64_t outOfRange = 0;
  std::uint64_t outOfOrder = 0;  ///< time not after the reading before
  std::uint64_t wrongTimes = 0;  ///< times far ahead that later readings proved wrong
  std::uint64_t glitches = 0;    ///< single readings that no finger can cause
  std::uint64_t gaps = 0;        ///< silences that ended

  std::uint64_t rejected() const { return notFinite + outOfRange + outOfOrder + wrongTimes + glitches; }
};

enum class ConditionerVerdict : std::uint8_t {
  reject,  ///< drop it
  accept,  ///< pass it on
  resume   ///< pass it on as a new start, because earlier readings are too old to connect to
};

/// Judges readings one by one, and removes noise and the tremor of a resting hand from accepted ones
/// (force_steadier.h, rest_band.h). Pure function of its inputs; one owner, any thread; no allocation.
class ForceConditioner {
 public:
  explicit ForceConditioner(const ConditionerSettings& settings = {}) { setSettings(settings); }

  /// Keeps counts and history.
  void setSettings(const ConditionerSettings& settings);

  /// Evaluates only the noise of a reading in a recording that will be judged from its start.
  void learn(double value);

  /// `time_s` on any steady clock, the same for all readings.
  ConditionerVerdict judge(double time_s, double value);
  /// Steady value after the last accepted reading.
  double value() const { return steadyValue_; }
  /// SD of the readings, as far as it is known; 0: negligible.
  double noise() const { return steadier_.noise(); }

  const ConditionerCounts& counts() const { return counts_; }
  /// Returns true if no reading was accepted within the limit before `now_s` (or none at all).
  bool silent(double now_s) const;
  bool stuck() const { return stuck_; }

 private:
  ConditionerVerdict accept(double time_s, double value, bool resumed);
  ConditionerVerdict judgeEarly(double time_s, double value);

  ConditionerSettings settings_;
  ForceSteadier steadier_;
  RestBand rest_;
  double steadyValue_ = 0;
  ConditionerCounts counts_;
  double lastTime_s_ = 0, lastValue_ = 0;
  double sameSince_s_ = 0;
  double suspect_ = 0;
  double earlySuspect_s_ =
      0;  ///< a time before lastTime_s_: the first of a series that would prove lastTime_s_ wrong
  std::uint32_t earlyInRow_ = 0;
  bool any_ = false, suspected_ = false, stuck_ = false;
};

}  // namespace detent::playback
