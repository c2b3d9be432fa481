// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Handles Ctrl-C and other ending signals on a separate thread, at any moment, even repeatedly: the program
// is notified, and if it has not ended soon after (a library waits, a terminal is being read), it is ended.

#include <functional>
#include <memory>

namespace detent::playback {

/// One per program, made on the main thread before any other thread, so that all threads inherit that SIGINT,
/// SIGTERM and SIGHUP are blocked. A second signal changes nothing, because the program is ending already.
class SignalWatch {
 public:
  /// `grace_s`: time from the first signal to the forced end, with the terminal restored and exit code 128 +
  /// the signal's number. `lastDeed` runs just before (it removes files that are being written), on the
  /// listening thread.
  SignalWatch(double grace_s, void (*lastDeed)());
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// Any thread.
  bool seen() const;

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

/// Sets the function that SIGUSR1 calls while a SignalWatch exists, and that a signal which ends the program
/// calls first; on the listening thread. Without one, SIGUSR1 ends the program like the others. An empty
/// function removes it.
void setEmergencyDeed(std::function<void()> deed);

}  // namespace detent::playback
