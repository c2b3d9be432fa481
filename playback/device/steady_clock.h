// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The one clock of the device room: CLOCK_MONOTONIC_RAW, the clock JACK stamps with (CLOCK_MONOTONIC is
// slewed and may lie apart from it by a large constant).

namespace detent::playback {

/// Seconds; never steps back; cheap enough for the audio callback (no system call on common machines).
double now_s();

/// Sleeps until that time has come.
void sleepUntil(double time_s);

/// Asks the system to wake the calling thread when its time has come, not within the 50 µs after it that save power: for threads
/// whose work is due to 100 µs. Real-time threads are woken so anyway.
void requestPunctualWakeUp();

/// Real-time scheduling of the calling thread while it lives, where the machine grants it; then what it was before.
class RealtimeWhile {
 public:
  explicit RealtimeWhile(int priority);
  ~RealtimeWhile();
  RealtimeWhile(const RealtimeWhile&) = delete;
  RealtimeWhile& operator=(const RealtimeWhile&) = delete;

 private:
  int policyBefore_ = 0, priorityBefore_ = 0;
  bool granted_ = false;
};

/// Asks for real-time scheduling of the calling thread (FIFO). False where the machine refuses; the caller
/// goes on.
bool requestRealtime(int priority);

}  // namespace detent::playback
