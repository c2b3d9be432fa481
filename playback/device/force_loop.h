// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The thread between a force device and a force engine: one exchange and one step per period, on time,
// counted.

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
  /// false: as fast as the machine can, for devices whose time is their own (the simulated one).
  bool paced = true;
  std::int64_t steps = 0;  ///< 0: until stopped
  bool holdToRun = false;  ///< force only while `ForceLoop::hold` is said again and again
  /// Of a loop that is not paced: after so many steps it waits for the next program; 0: never.
  std::int64_t waitsAfter_steps = 0;
};

/// How long one `ForceLoop::hold` lasts: a key that is held down repeats three times in it.
inline constexpr double holdLasts_s = 0.15;

/// How punctual the loop was. A step is late by how long after its time it began.
struct DeadlineCounts {
  std::uint64_t steps = 0, within100us = 0, missed = 0;  ///< missed: late by a whole period
  double worst_s = 0, mean_s = 0;
  std::uint64_t computerLate = 0,
                deviceLate = 0;  ///< answers missed in steps that began late, and in steps on time
  bool realtime = false;         ///< the system granted real-time scheduling
};

/// A snapshot for displays.
struct ForceLoopStatus {
  ForceStep last;
  DeadlineCounts deadlines;
  ForceGuardCounts guard;
  ForceLinkCounts link;
  double lowestBalance_mJ = 0;
  std::uint64_t droppedRows = 0;  ///< steps that nobody fetched in time
  ForceDeviceState device = ForceDeviceState::ready;
  ForceHalt halt = ForceHalt::none;
  bool finished = false;
};

/// Owns the device while it lives. Its functions belong to one other thread.
class ForceLoop {
 public:
  ForceLoop(std::unique_ptr<ForceDevice> device, const ForceProgram& program,
            const ForceLoopSettings& settings);
  /// Lets the force fall to nothing, then lets the device go.
  ~ForceLoop();
  ForceLoop(const ForceLoop&) = delete;
  ForceLoop& operator=(const ForceLoop&) = delete;

  /// Exchanges the button; its force rises from nothing.
  void setProgram(const ForceProgram& program);
  ForceLoopStatus status() const;
  /// Appends the steps since the last call.
  void takeSteps(std::vector<ForceStep>& steps);
  /// No force within a few periods, and none until `rearm`. Any thread; waits for nothing.
  void emergencyStop() { emergency_ = true; }
  /// A person wants force again: it rises from nothing. Any thread.
  void rearm() { rearming_ = true; }
  /// Hold-to-run: there is force only while the last word was `true`, and that not longer ago than
  /// `holdLasts_s`. Any thread.
  void hold(bool held);
  /// Asks for the end; `status().finished` tells it has come.
  void stop() { stopping_ = true; }

 private:
  void run();
  void waitFor(double due_s);
  void keep(ForceStep step, bool wait);
  void publish(bool finished);
  void takeProgram();
  void awaitProgram();
  void takeOrders();
  void step(ForceReading reading);

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
  mutable std::mutex statusMutex_;  ///< the loop only tries it: a display never makes a step late
  ForceLoopStatus published_;
  std::thread thread_;
};

}  // namespace detent::playback
