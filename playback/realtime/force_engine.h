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
  std::array<double, 2> sideways_mm{};  ///< of three-axis devices; 0 on the axis
  bool fresh = true;                    ///< false: no new answer in this period
  double periods = 1;                   ///< since the reading before; more where the loop was late
  Zero zero = Zero::kept;
  bool stopped = false;    ///< somebody pressed the device's own emergency switch
  bool deadCount = false;  ///< the device stopped the law it runs: its encoder counted no step under force
};

/// Command to the device.
struct ForceCommand {
  double force_N = 0;                  ///< against pressing
  std::array<double, 2> sideways_N{};  ///< along growing `sideways_mm`
  bool halted = false;                 ///< there must be none, whatever law the device runs by itself
};

/// One row of a log.
struct ForceStep {
  std::int64_t index = 0;  ///< steps since the start; time is index * period
  double periods = 1;      ///< since the step before, by the clock of a loop that keeps time
  double time_s =
      0;  ///< of the reading, on that clock (playback/device/steady_clock.h); 0: the loop keeps none
  double requested_s = 0;  ///< when the reading was requested, with the last force, on that clock
  bool good = true;        ///< the reading was believed; else the position is the last that was
  bool proving =
      false;  ///< motor and encoder are being checked (direction_proof.h): the button's force has not begun
  double position_mm = 0, velocity_mm_per_s = 0, force_N = 0;
  double energy_mJ = 0;  ///< net work of the finger on the button since the start
  double balance_mJ =
      0;  ///< stored at full force, plus work since, plus what changes of state gave or took: below 0,
          ///< the button gave more than it held
  std::uint32_t state = 0;
  bool actuated = false;
};

/// Time from one step to the next, by the loop's clock. `periods` counts no interval as less than one, so
/// that a sum of them runs ahead where a busy computer wakes the loop early and late in turns.
inline double between_s(const ForceStep& before, const ForceStep& step, double period_s) {
  return before.requested_s > 0 && step.requested_s > 0 ? step.requested_s - before.requested_s
                                                        : step.periods * period_s;
}

class ForceEngine {
 public:
  /// The program must outlive the engine.
  explicit ForceEngine(const ForceProgram& program);

  /// Exchanges the button: the old force becomes the new one's over `startRamp_s`. The old program may go
  /// afterwards.
  void setProgram(const ForceProgram& program);

  /// One period. Bad readings and too much force never leave here (force_guard.h).
  ForceCommand step(const ForceReading& reading);
  /// Result of the last step.
  const ForceStep& last() const { return last_; }

  /// Lets the force fall to nothing within `stopRamp_s` of steps; `silent` once it has.
  void stop() { guard_.stop(); }
  bool silent() const { return guard_.silent(); }

  /// Removes the force, as in force_guard.h.
  void emergencyStop() { guard_.emergencyStop(); }
  void rearm();
  void setHeld(bool held) { guard_.setHeld(held); }
  ForceHalt halt() const { return guard_.halt(); }

  const ForceGuardCounts& counts() const { return guard_.counts(); }
  /// Lowest balance seen (mJ, <= 0): what a passivity observer reports.
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
  std::uint32_t missed_ = 0;        ///< periods without a good reading since the last one
  std::uint32_t sinceRestart_ = 0;  ///< readings the velocity rests on
  bool resuming_ = false;           ///< readings were bad until the force was gone: the velocity is not known
  std::array<double, 32> sent_N_{};  ///< the newest forces, a ring
  std::size_t newestSent_ = 0;
  double steady_mm_ =
      0;  ///< centre of a play of half an encoder step: a flicker between two steps does not move it
  double balanceOrigin_mJ_ = 0;  ///< balance less energy less state energy
  bool full_ = false;            ///< the force is let through whole: the balance counts
  double heldForce_N_ = 0;       ///< of the last good reading, before the limits
  bool exchanged_ = false;       ///< the first step of another button comes
  double exchange_N_ = 0;        ///< old force less new one at the exchange
  double exchangeLeft_ = 0;      ///< share of it, 1..0
  double lowestBalance_mJ_ = 0;
};

}  // namespace detent::playback
