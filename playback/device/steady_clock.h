// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The clock of all devices: CLOCK_MONOTONIC_RAW, which JACK uses for its time stamps. CLOCK_MONOTONIC is
// adjusted in speed and may differ from it by a large constant.

namespace detent::playback {

/// Seconds; never steps back; cheap enough for the audio callback (no system call on common machines).
double now_s();

/// Sleeps until the clock reaches `time_s`.
void sleepUntil(double time_s);

/// Requests that the system wakes the calling thread exactly on time instead of up to 50 µs later, which
/// saves power. For threads whose work is due to within 100 µs. Real-time threads are always woken on time.
void requestPunctualWakeUp();

/// Real-time scheduling of the calling thread during the object's lifetime, if the machine grants it; the
/// previous scheduling is restored after.
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

/// Requests real-time scheduling (FIFO) for the calling thread. Returns false if the machine refuses; the
/// caller may continue.
bool requestRealtime(int priority);

}  // namespace detent::playback
