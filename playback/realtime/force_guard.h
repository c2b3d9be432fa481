// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stands between a force law and a person: judges every reading and limits every force. On by default, counted.

#include <cstdint>

#include "playback/realtime/force_program.h"

namespace detent::playback {

/// What a device gave in one period.
enum class ReadingVerdict : std::uint8_t {
  good,
  missing,  ///< late: no answer, or the same answer again
  notFinite,
  frozen,  ///< stopped dead out of a swift movement, under force: the encoder counts no more
  absurd   ///< outside the device's range, or farther away than its speed limit allows
};

struct ForceGuardCounts {
  std::uint64_t readings = 0, missing = 0, notFinite = 0, frozen = 0, absurd = 0;
  std::uint64_t faded = 0;    ///< times the force fell to nothing because readings stayed bad
  std::uint64_t tooFast = 0;  ///< times it fell because the device moved too fast
  std::uint64_t forceLimited = 0, slewLimited = 0;  ///< steps
};

/// Bad readings are bridged for `heldReadings` steps with the last force, then it falls to nothing within `stopRamp_s`; after
/// as many good ones it rises again over `startRamp_s`, as at the start. One thread; no allocation, lock, clock or exception.
class ForceGuard {
 public:
  ForceGuard(const ForceLimits& limits, double period_s, double step_mm);

  /// Other limits from now on; what was let through and counted stays.
  void setLimits(const ForceLimits& limits, double period_s, double step_mm);

  /// `fresh`: the device answered in this period.
  ReadingVerdict judge(double position_mm, bool fresh);

  /// The force to send: faded, clamped, no faster than the slew limit. Anything not finite becomes 0.
  double limit(double force_N, double velocity_mm_per_s);
  /// 0..1: how much of the force is let through.
  double gain() const { return gain_; }

  /// From now on the force only falls; `silent` once nothing is left.
  void stop() { stopping_ = true; }
  bool silent() const { return gain_ == 0 && output_N_ == 0; }

  const ForceGuardCounts& counts() const { return counts_; }

 private:
  ReadingVerdict verdictOn(double position_mm, bool fresh) const;
  void count(ReadingVerdict verdict);
  bool frozenAt(double position_mm) const;
  void follow(double position_mm);
  bool mayRise() const;
  void moveGain();

  ForceLimits limits_;
  double period_s_, step_mm_;
  ForceGuardCounts counts_;
  double way_mm_ = 0;            ///< gone in the last milliseconds, up to the last change
  std::uint32_t unchanged_ = 0;  ///< readings since
  double last_mm_ = 0, output_N_ = 0, gain_ = 0;
  bool started_ = false, stopping_ = false, running_ = false, tooFast_ = false;
  std::uint32_t bad_ = 0, good_ = 0;
};

}  // namespace detent::playback
