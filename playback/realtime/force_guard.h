// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Protects a person from faults of a force law or device: judges every reading and limits every force. Always
// on; counted.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "playback/realtime/force_program.h"

namespace detent::playback {

/// Verdict on a device's reading of one period.
enum class ReadingVerdict : std::uint8_t {
  good,
  missing,  ///< late: no answer, or the same answer again
  notFinite,
  absurd,    ///< outside the device's range, or unreachable from the last good position
  displaced  ///< any reading after the position was lost, until it is known again
};

/// Reason why there is no force until a person arms. If there are several, the first in this list.
enum class ForceHalt : std::uint8_t {
  none,
  stopped,    ///< emergency stop
  reversed,   ///< the handle moves against the force: motor or encoder are connected the wrong way round
  unmoved,    ///< the handle did not follow the push at arming: blocked, or the encoder does not count
  deadCount,  ///< the encoder did not count a step under force, nor when the force was removed
  /// the handle kept moving against the full force: the motor is reversed, or a finger presses harder than
  /// the limit
  runaway,
  dropOuts,  ///< readings failed repeatedly, or once while the handle was thrown far beyond its travel
  /// the position jumped, the device was absent or reset, or a pause ended with the handle far beyond the
  /// travel, so the position of the handle is unknown
  displaced,
  notHeld  ///< hold-to-run, and nobody holds
};

struct ForceGuardCounts {
  std::uint64_t readings = 0, missing = 0, notFinite = 0, absurd = 0;
  /// Times that a moving handle stopped instantly under force, which suggests that the encoder no longer
  /// counts. The force is removed until it counts again.
  std::uint64_t frozen = 0;
  std::uint64_t displaced = 0;  ///< times the position was lost
  std::uint64_t stopped = 0;    ///< emergency stops
  std::uint64_t faded = 0;      ///< times the force faded out because readings stayed bad
  std::uint64_t tooFast = 0;    ///< times the force faded because the device moved too fast
  std::uint64_t forceLimited = 0, slewLimited = 0;  ///< steps
  std::uint64_t stalled = 0;  ///< times the loop paused so long that the force had to start again
  std::uint64_t probed = 0;   ///< times the force was lowered to check whether a resting encoder still counts
};

/// Drop-outs within a second above which the force is halted.
inline constexpr std::size_t mostDropOuts = 3;

/// Bad readings are bridged for `heldReadings` steps with the last force, which then falls to zero within
/// `stopRamp_s`. After equally many good ones it increases again over `startRamp_s`, as at the start. A
/// position that jumped is never accepted again automatically: `rearm` (by a person) or `home` (the device
/// found its zero) must come first. One thread; no allocation, lock, clock or exception.
class ForceGuard {
 public:
  ForceGuard(const ForceLimits& limits, double period_s, double step_mm);

  /// Changes the limits; the present force and the counts are kept.
  void setLimits(const ForceLimits& limits, double period_s, double step_mm);

  /// `fresh`: the device answered in this period. `periods` >= 0: since the previous call, 1 if the loop is
  /// on time.
  ReadingVerdict judge(double position_mm, bool fresh, double periods = 1);

  /// The force to send: clamped, faded, with limited slew rate; never more than `gain()` times the force
  /// limit. A value that is not finite becomes 0. Without a velocity, the state of excess speed is kept, and
  /// no force starts to increase.
  double limit(double force_N, std::optional<double> velocity_mm_per_s);
  /// 0..1: factor applied to the force.
  double gain() const { return gain_; }

  /// From now on the force only decreases; `silent` reports when it is zero.
  void stop() { stopping_ = true; }
  bool silent() const { return gain_ == 0 && output_N_ == 0; }

  /// Emergency stop: zero force within `emergencyRamp_s`, until `rearm`.
  void emergencyStop();
  /// The device has lost its position; handled like a jump.
  void displace();
  /// Removes the force for this reason until `rearm`. The first reason is kept.
  void latch(ForceHalt reason);
  /// Restarts the force from zero; it increases over `startRamp_s`.
  void riseAnew();
  /// The device has found its zero again: ends a lost position, but not an emergency stop.
  void home();
  /// A person arms: ends a stop, and takes the next reading as the position. The force increases from zero.
  void rearm();
  /// Hold-to-run: false removes the force like an emergency stop; true lets it increase again.
  void setHeld(bool held) { held_ = held; }
  ForceHalt halt() const;

  const ForceGuardCounts& counts() const { return counts_; }

 private:
  ReadingVerdict verdictOn(double position_mm, bool fresh) const;
  bool reachable(double position_mm) const;
  bool settling() const { return !running_ && gain_ == 0 && settled_ <= limits_.heldReadings; }
  void followJumps(ReadingVerdict verdict, double position_mm, double periods);
  std::uint32_t held() const;
  void forgetPlace();
  void count(ReadingVerdict verdict);
  bool frozen(double force_N) const;
  void follow(double position_mm);
  bool mayRise() const;
  void haltThrown();
  void moveGain();
  double watchedCount(double force_N);
  void watchRunaway(std::optional<double> velocity_mm_per_s);
  void countDropOut();
  bool droppedOutLately() const;
  bool pausedLately() const;

  ForceLimits limits_;
  double period_s_, step_mm_;
  ForceGuardCounts counts_;
  /// distance per period in the last movements without a rest, newest first
  std::array<double, 3> paces_mm_{};
  std::uint32_t unchanged_ = 0;  ///< readings without change since then
  double last_mm_ = 0, output_N_ = 0, gain_ = 0;
  bool started_ = false, stopping_ = false, running_ = false, tooFast_ = false;
  std::uint32_t bad_ = 0, good_ = 0;
  double pace_mm_ = 0;  ///< distance per period at the last good reading
  double since_ = 0;    ///< periods since the last good reading, including this one
  double unseen_ = 0;   ///< periods since the last good reading without information from the encoder
  double jumps_ = 0;    ///< recent absurd readings
  std::optional<double> jumpedTo_mm_;  ///< the last absurd reading
  std::uint32_t settled_ = 0;          ///< good readings since the position was accepted without proof
  bool stopped_ = false, displaced_ = false, held_ = true, speedKnown_ = false;
  bool interrupted_ = false;  ///< the force ended because readings failed or the loop stood still
  ForceHalt latched_ = ForceHalt::none;
  double time_s_ = 0;                              ///< since the start
  std::array<double, mostDropOuts> dropOuts_s_{};  ///< times of the most recent drop-outs, as a ring buffer
  double stalledAt_s_;                             ///< end of the most recent pause of the loop
  double elapsed_s_ = 0;                           ///< time between the last two judgements
  double uncounted_s_ = 0;                         ///< time under force without a step of the encoder
  double believed_ = 1;     ///< 1..0: share of the force while the encoder does not count
  double moved_mm_ = 0;     ///< distance between the last two good readings
  bool resisting_ = false;  ///< the handle is where only the full force or the end of travel could hold it
  double resisted_mJ_ = 0;  ///< work against the force since then
  double entered_mJ_ = 0;   ///< kinetic energy of the handle when the resistance began
  double fastest_mm_per_s_ = 0, beyond_s_ = 0, pinned_s_ = 0;
};

}  // namespace detent::playback
