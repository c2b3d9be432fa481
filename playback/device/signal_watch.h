// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ctrl-C and its like, heard on a thread of its own: at any moment, once or twice, the program is told, and if
// it has not ended soon after (a library that waits, a terminal that is read), it is ended.

#include <functional>
#include <memory>

namespace detent::playback {

/// One per program, made on the main thread before any other thread (they inherit that SIGINT, SIGTERM and
/// SIGHUP are not theirs). A second signal changes nothing: the program ends already.
class SignalWatch {
 public:
  /// `grace_s`: from the first signal to the end by force, with the terminal as it was and exit code 128 + the
  /// signal's number. `lastDeed` is done just before (files that are being written have to go); called on the listening thread.
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

/// What SIGUSR1 does while a SignalWatch lives, and a signal that ends the program does first; called on the listening thread. Without one
/// SIGUSR1 ends the program like the others. An empty one takes it away.
void setEmergencyDeed(std::function<void()> deed);

}  // namespace detent::playback
