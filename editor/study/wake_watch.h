// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measures the lateness with which this machine wakes a waiting program.

#include <atomic>
#include <thread>

namespace detent::editor {

/// Asks to be woken every millisecond, on a thread of its own. What stamps an event waits for it in the same
/// way: this is as late as a stamp may be, as far as a program can know.
class WakeWatch {
 public:
  WakeWatch();
  WakeWatch(const WakeWatch&) = delete;
  WakeWatch& operator=(const WakeWatch&) = delete;
  /// Waits for the thread: a millisecond.
  ~WakeWatch();

  /// The latest so far, also while a waking is still due. Any thread.
  double latest_s() const;

 private:
  void run();

  std::atomic<double> latest_s_{0}, due_s_;
  std::atomic<bool> ending_{false};
  std::thread thread_;  // last member, because the thread uses the others
};

}  // namespace detent::editor
