// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One step of the force loop: a reading in, a force out. Same rules as the audio callback: no allocation,
// lock, clock, file or exception. Reading order: velocity_estimator.h, play_operator.h, force_law.h,
// force_guard.h, this file.

#include <array>
#include <cstdint>
#include <optional>

#include "playback/realtime/direction_proof.h"
#include "playback/realtime/force_guard.h"
#include "playback/realtime/force_law.h"
#include "playback/realtime/force_program.h"
#include "playback/realtime/test_forces.h"
#include "playback/realtime/velocity_estimator.h"

namespace detent::playback {

/// A device's measurement in one period.
struct ForceReading {
  /// State of the position's zero.
  enum class Zero : std::uint8_t {
    kept,
    lost,  ///< the device was away or reset
    found  ///< homed anew with this reading
  };
  double position_mm = 0;               ///< along the button's axis, 0 at rest, grows with pressing
  std::array<double, 2> sideways_mm{};  ///< sideways position on three-axis devices; 0 on the axis
  bool fresh = true;                    ///< false: no new answer in this period
  double periods = 1;                   ///< since the previous reading; more than 1 if the loop was late
  Zero zero = Zero::kept;
  bool stopped = false;  ///< a person pressed the device's own emergency switch
  bool deadCount =
      false;  ///< the device stopped the law that it runs: its encoder counted no step under force
};

/// Command to the device.
struct ForceCommand {
  double force_N = 0;                  ///< against pressing
  std::array<double, 2> sideways_N{};  ///< along growing `sideways_mm`
  bool halted = false;                 ///< there must be no force, whatever law the device runs itself
};

/// One row of a log.
struct ForceStep {
  std::int64_t index = 0;  ///< steps since the start; time is index * period
  double periods = 1;      ///< since the previous step, by the clock of a paced loop
  double time_s =
      0;  ///< time of the reading on that clock (playback/device/steady_clock.h); 0: the loop is not paced
  /// time of the request for the reading, which also sent the last force, on that clock
  double requested_s = 0;
  bool good = true;  ///< the reading was accepted; otherwise the position is that of the last accepted one
  /// motor and encoder are being checked (direction_proof.h), so the button's force has not begun
  bool proving = false;
  double position_mm = 0, velocity_mm_per_s = 0, force_N = 0;
  double energy_mJ = 0;  ///< net work of the finger on the button since the start
  /// energy stored at full force, plus work since, plus energy of state changes; below 0 the button gave
  /// more than it had stored
  double balance_mJ = 0;
  std::uint32_t state = 0;
  bool actuated = false;
};

/// Time from one step to the next, by the loop's clock. `periods` counts no interval as less than one, so its
/// sum runs ahead if a busy computer wakes the loop alternately early and late.
inline double between_s(const ForceStep& before, const ForceStep& step, double period_s) {
  return before.requested_s > 0 && step.requested_s > 0 ? step.requested_s - before.requested_s
                                                        : step.periods * period_s;
}

class ForceEngine {
 public:
  /// The program must outlive the engine.
  explicit ForceEngine(const ForceProgram& program);

  /// Exchanges the button: the force changes from the old one to the new one over `startRamp_s`. The old
  /// program may be destroyed afterwards.
  void setProgram(const ForceProgram& program);

  /// Runs one period. Bad readings and excessive forces are intercepted (force_guard.h).
  ForceCommand step(const ForceReading& reading);
  /// Result of the last step.
  const ForceStep& last() const { return last_; }

  /// Lets the force fall to zero within `stopRamp_s` of steps; `silent` reports when it has.
  void stop() { guard_.stop(); }
  bool silent() const { return guard_.silent(); }

  /// Removes the force, as in force_guard.h.
  void emergencyStop() { guard_.emergencyStop(); }
  void rearm();
  void setHeld(bool held) { guard_.setHeld(held); }
  ForceHalt halt() const { return guard_.halt(); }

  const ForceGuardCounts& counts() const { return guard_.counts(); }
  /// Lowest energy balance so far (mJ, <= 0), as a passivity observer reports it.
  double lowestBalance_mJ() const { return lowestBalance_mJ_; }

 private:
  double steadied_mm(double position_mm) const;
  void restartAt(const ForceReading& reading);
  void observe(double position_mm);
  double actingForce_N() const;
  std::optional<double> knownVelocity() const;
  ForceCommand send(double force_N, std::array<double, 2> sideways_N);
  double exchanging_N(double force_N);
  double requested_N(double position_mm);
  double proving_N(double position_mm);
  double controlled_N(double force_N, double velocity_mm_per_s) const;
  std::array<double, 2> guide(const std::array<double, 2>& sideways_mm);

  const ForceProgram* program_;
  ForceLaw law_;
  TestForces test_;
  DirectionProof proof_;
  bool proving_;
  ForceGuard guard_;
  VelocityEstimator velocity_;
  std::array<VelocityEstimator, 2> sidewaysVelocity_;
  ForceStep last_;
  bool running_ = false;
  std::uint32_t missed_ = 0;        ///< periods without a good reading since the last good one
  std::uint32_t sinceRestart_ = 0;  ///< readings since the restart, on which the velocity is based
  bool resuming_ = false;  ///< readings were bad until the force was gone, so the velocity is unknown
  std::array<double, 32> sent_N_{};  ///< the most recent forces, as a ring buffer
  std::size_t newestSent_ = 0;
  double steady_mm_ =
      0;  ///< centre of a play of half an encoder step, so that flicker between two steps does not move it
  double balanceOrigin_mJ_ = 0;  ///< balance less energy less state energy
  bool full_ = false;            ///< the full force acts, so the balance counts
  double heldForce_N_ = 0;       ///< force at the last good reading, before the limits
  bool exchanged_ = false;       ///< the next step is the first of another button
  double exchange_N_ = 0;        ///< old force minus new one at the exchange
  double exchangeLeft_ = 0;      ///< remaining share of the difference, 1..0
  double lowestBalance_mJ_ = 0;
};

}  // namespace detent::playback
