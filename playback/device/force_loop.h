// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The thread that connects a force device and a force engine: one exchange and one step per period, on time,
// with statistics.

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <readerwriterqueue/readerwriterqueue.h>

#include "playback/device/force_device.h"
#include "playback/realtime/force_engine.h"

namespace detent::playback {

struct ForceLoopSettings {
  /// false: runs as fast as the machine can, for devices with a time of their own (the simulated one).
  bool paced = true;
  std::int64_t steps = 0;  ///< number of steps; 0: until stopped
  bool holdToRun = false;  ///< there is force only while `ForceLoop::hold` is called repeatedly
  /// For a loop that is not paced: after this many steps it waits for the next program; 0: never.
  std::int64_t waitsAfter_steps = 0;
};

/// Duration of one `ForceLoop::hold`: a key that is held down repeats three times within it.
inline constexpr double holdLasts_s = 0.15;

/// Punctuality of the loop. The delay of a step is the time from its scheduled to its actual beginning.
struct DeadlineCounts {
  std::uint64_t steps = 0, within100us = 0, missed = 0;  ///< missed: delayed by a whole period or more
  double worst_s = 0, mean_s = 0;
  std::uint64_t computerLate = 0,
                deviceLate = 0;  ///< missing answers, of steps that began late and of steps on time
  bool realtime = false;         ///< the system granted real-time scheduling
};

/// A snapshot for displays.
struct ForceLoopStatus {
  ForceStep last;
  DeadlineCounts deadlines;
  ForceGuardCounts guard;
  ForceLinkCounts link;
  double lowestBalance_mJ = 0;
  std::uint64_t droppedRows = 0;  ///< steps that were dropped because nobody took them in time
  ForceDeviceState device = ForceDeviceState::ready;
  ForceHalt halt = ForceHalt::none;
  bool finished = false;
};

/// Owns the device while it exists. Its functions may be called from one other thread.
class ForceLoop {
 public:
  ForceLoop(std::unique_ptr<ForceDevice> device, const ForceProgram& program,
            const ForceLoopSettings& settings);
  /// Lets the force fall to zero, then releases the device.
  ~ForceLoop();
  ForceLoop(const ForceLoop&) = delete;
  ForceLoop& operator=(const ForceLoop&) = delete;

  /// Exchanges the button; its force increases from zero.
  void setProgram(const ForceProgram& program);
  ForceLoopStatus status() const;
  /// Appends the steps since the last call to `steps`.
  void takeSteps(std::vector<ForceStep>& steps);
  /// Removes the force within a few periods, until `rearm`. Any thread; returns at once.
  void emergencyStop() { emergency_ = true; }
  /// Called when a person wants force again: it increases from zero. Any thread.
  void rearm() { rearming_ = true; }
  /// Hold-to-run: there is force only while the last call had `true`, and no longer than `holdLasts_s` after
  /// it. Any thread.
  void hold(bool held);
  /// Requests the end; `status().finished` reports when it has come.
  void stop() { stopping_ = true; }

 private:
  void run();
  void waitFor(double due_s);
  void keep(ForceStep step, bool wait);
  void publish(bool finished);
  void takeProgram();
  void awaitProgram();
  void takeOrders();
  bool isStall(double pause_s) const;
  void step();

  ForceLoopSettings settings_;
  std::unique_ptr<ForceDevice> device_;
  std::unique_ptr<ForceProgram> program_;
  ForceEngine engine_;
  ForceCommand command_;
  DeadlineCounts deadlines_;
  std::uint64_t dropped_ = 0;
  std::atomic<bool> stopping_{false}, abandoned_{false}, emergency_{false}, rearming_{false};
  std::atomic<double> heldUntil_s_{0};
  double requested_s_ = 0, exchanged_s_ = 0, late_s_ = 0;
  moodycamel::ReaderWriterQueue<ForceStep> rows_;
  moodycamel::ReaderWriterQueue<std::unique_ptr<ForceProgram>> programs_, retired_;
  mutable std::mutex statusMutex_;  ///< the loop only tries to lock it, so that a display never delays a step
  ForceLoopStatus published_;
  std::thread thread_;
};

}  // namespace detent::playback
