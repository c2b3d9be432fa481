// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measures how late this machine wakes a waiting program.

#include <atomic>
#include <thread>

namespace detent::editor {

/// A thread that asks to be woken every millisecond and measures the delay. The window system waits for input
/// in the same way before it stamps an event, so the largest delay is an estimate of how late a stamp may be.
class WakeWatch {
 public:
  WakeWatch();
  WakeWatch(const WakeWatch&) = delete;
  WakeWatch& operator=(const WakeWatch&) = delete;
  /// Waits up to a millisecond for the thread.
  ~WakeWatch();

  /// Largest delay so far, including that of a wake-up that is still due. Any thread.
  double latest_s() const;

 private:
  void run();

  std::atomic<double> latest_s_{0}, due_s_;
  std::atomic<bool> ending_{false};
  std::thread thread_;  // last member, because the thread uses the others
};

}  // namespace detent::editor
