// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What every sound callback does, whichever library calls it: let the session render, copy to all channels,
// account.

#include <array>
#include <atomic>
#include <cstddef>

#include "playback/realtime/live_session.h"

namespace detent::playback {

/// The callback's own hooks, for tests that count what happens inside it. Null: none.
struct CallbackHooks {
  void (*enter)() = nullptr;
  void (*leave)() = nullptr;
};

/// Audio thread only, but for `lastEntry_s` and `noteXrun`.
class StreamRenderer {
 public:
  StreamRenderer(LiveSession& session, CallbackHooks hooks) : session_(session), hooks_(hooks) {}

  /// `put(first, samples, count)` stores a run of samples; called one or more times, in order.
  template <class Put>
  void render(std::size_t frames, double entry_s, double (*clock)(), Put put) {
    if (hooks_.enter != nullptr) hooks_.enter();
    lastEntry_s_.store(entry_s, std::memory_order_relaxed);
    for (std::size_t done = 0; done < frames;) {
      const std::size_t left = frames - done, count = left < largestRun ? left : largestRun;
      session_.process(mono_.data(), count, entry_s + static_cast<double>(done) / session_.sampleRate_Hz());
      put(done, mono_.data(), count);
      done += count;
    }
    session_.account(clock() - entry_s, frames, xrun_.exchange(false, std::memory_order_relaxed));
    if (hooks_.leave != nullptr) hooks_.leave();
  }

  double lastEntry_s() const { return lastEntry_s_.load(std::memory_order_relaxed); }
  void touch(double now_s) { lastEntry_s_.store(now_s, std::memory_order_relaxed); }
  void noteXrun() { xrun_.store(true, std::memory_order_relaxed); }

 private:
  static constexpr std::size_t largestRun = 8192;
  LiveSession& session_;
  CallbackHooks hooks_;
  std::array<float, largestRun> mono_{};
  std::atomic<double> lastEntry_s_{0};
  std::atomic<bool> xrun_{false};
};

}  // namespace detent::playback
