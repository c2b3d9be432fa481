// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Protects a person from a force law: judges every reading and limits every force. On by default, counted.

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
  absurd,    ///< outside the device's range, or where no movement from the last good place leads
  displaced  ///< any after the place was lost, until it is known again
};

/// Why there is no force until a person says so. Of several the first one here.
enum class ForceHalt : std::uint8_t {
  none,
  stopped,    ///< emergency stop
  reversed,   ///< the handle moves against the force: motor or encoder are connected the wrong way round
  unmoved,    ///< the handle did not follow the push at arming: blocked, or the encoder does not count
  deadCount,  ///< the encoder did not count one step under force, nor when the force was taken away
  runaway,    ///< the handle ran on against the whole force: motor reversed, or pressed harder than the limit
  dropOuts,   ///< readings failed again and again
  displaced,  ///< the position jumped, the device was away or reset, or a pause ended with the handle far
              ///< beyond the travel: where the handle is, is not known
  notHeld     ///< hold-to-run, and nobody holds
};

struct ForceGuardCounts {
  std::uint64_t readings = 0, missing = 0, notFinite = 0, absurd = 0;
  /// Readings of a handle that stopped dead out of a movement, under force: the encoder counts no more. They
  /// take the force away until it counts.
  std::uint64_t frozen = 0;
  std::uint64_t displaced = 0;  ///< times the place was lost
  std::uint64_t stopped = 0;    ///< emergency stops
  std::uint64_t faded = 0;      ///< times the force fell to nothing because readings stayed bad
  std::uint64_t tooFast = 0;    ///< times it fell because the device moved too fast
  std::uint64_t forceLimited = 0, slewLimited = 0;  ///< steps
  std::uint64_t stalled = 0;  ///< times the loop paused so long that the force began anew
  std::uint64_t probed = 0;   ///< times the force was lowered to see whether a resting encoder still counts
};

/// More drop-outs than this within a second are a halt.
inline constexpr std::size_t mostDropOuts = 3;

/// Bad readings are bridged for `heldReadings` steps with the last force, then it falls to nothing within
/// `stopRamp_s`; after as many good ones it rises again over `startRamp_s`, as at the start. A place that
/// jumped is never believed again by itself: `rearm` (a person) or `home` (the device found its zero) has to
/// come first. One thread; no allocation, lock, clock or exception.
class ForceGuard {
 public:
  ForceGuard(const ForceLimits& limits, double period_s, double step_mm);

  /// Changes the limits; the present force and the counts stay.
  void setLimits(const ForceLimits& limits, double period_s, double step_mm);

  /// `fresh`: the device answered in this period. `periods` >= 0: since the call before, 1 where the loop is
  /// on time.
  ReadingVerdict judge(double position_mm, bool fresh, double periods = 1);

  /// The force to send: clamped, then faded, no faster than the slew limit; never more than `gain()` times
  /// the force limit. Anything not finite becomes 0. Without a velocity an over-speed goes on as it was, and
  /// no force begins to rise.
  double limit(double force_N, std::optional<double> velocity_mm_per_s);
  /// 0..1: how much of the force is let through.
  double gain() const { return gain_; }

  /// From now on the force only falls; `silent` once nothing is left.
  void stop() { stopping_ = true; }
  bool silent() const { return gain_ == 0 && output_N_ == 0; }

  /// Emergency: down within `emergencyRamp_s`, and nothing until `rearm`.
  void emergencyStop();
  /// The device does not know its place any more: as after a jump.
  void displace();
  /// No force from now on, for this reason, until `rearm`. The first reason stays.
  void latch(ForceHalt reason);
  /// The force begins at nothing again and rises over `startRamp_s`.
  void riseAnew();
  /// The device has found its zero anew: ends that, not an emergency stop.
  void home();
  /// A person's word: the stop is over and the place is what the next reading says. The force rises from
  /// nothing.
  void rearm();
  /// Hold-to-run: false takes the force away as an emergency stop does, true lets it rise again.
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
  void moveGain();
  double watchedCount(double force_N);
  void watchRunaway(std::optional<double> velocity_mm_per_s);
  void countDropOut();
  bool droppedOutLately() const;

  ForceLimits limits_;
  double period_s_, step_mm_;
  ForceGuardCounts counts_;
  std::array<double, 3> paces_mm_{};  ///< gone per period in the last movements without a rest, newest first
  std::uint32_t unchanged_ = 0;       ///< readings since
  double last_mm_ = 0, output_N_ = 0, gain_ = 0;
  bool started_ = false, stopping_ = false, running_ = false, tooFast_ = false;
  std::uint32_t bad_ = 0, good_ = 0;
  double pace_mm_ = 0;                 ///< gone per period at the last good reading
  double since_ = 0;                   ///< periods since the last good reading, this one included
  double unseen_ = 0;                  ///< of them, those without information
  double jumps_ = 0;                   ///< absurd readings lately
  std::optional<double> jumpedTo_mm_;  ///< the last absurd reading
  std::uint32_t settled_ = 0;          ///< good readings since the place was taken on trust
  bool stopped_ = false, displaced_ = false, held_ = true, speedKnown_ = false;
  bool paused_ = false;  ///< the loop stood still, and no reading has been believed since
  ForceHalt latched_ = ForceHalt::none;
  double time_s_ = 0;                              ///< since the start
  std::array<double, mostDropOuts> dropOuts_s_{};  ///< the newest, a ring
  double elapsed_s_ = 0;                           ///< between the last two judgements
  double uncounted_s_ = 0;                         ///< without one step of the encoder under force
  double believed_ = 1;     ///< 1..0: share of the force that a count without movement is given
  double moved_mm_ = 0;     ///< between the last two good readings
  bool resisting_ = false;  ///< the handle is where only the whole force or the end holds it
  double resisted_mJ_ = 0;  ///< work that force has taken there
  double entered_mJ_ = 0;   ///< kinetic energy with which the handle came there
  double fastest_mm_per_s_ = 0, beyond_s_ = 0, pinned_s_ = 0;
};

}  // namespace detent::playback
