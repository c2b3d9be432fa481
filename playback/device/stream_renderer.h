// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Fills the buffer of a sound callback, for every sound library: renders the session, adds rain and the sound
// of presses, copies to all channels and counts.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>

#include "playback/realtime/live_session.h"
#include "playback/realtime/rain_noise.h"

namespace detent::playback {

/// Hooks of the callback, for tests that count events inside it. Null: none.
struct CallbackHooks {
  void (*enter)() = nullptr;
  void (*leave)() = nullptr;
};

/// Contents of a stream's channels, in this order.
struct OutputChannels {
  int signal = 2;  ///< channels with the vibration, the same on each
  int rain = 0;  ///< channels for the ears, the same on each: masking noise (rain_noise.h), sound of presses

  int all() const { return signal + rain; }
  bool isSignal(int channel) const { return channel < signal; }
};

/// Audio thread only, except for `lastEntry_s`, `noteXrun`, and functions that state otherwise.
class StreamRenderer {
 public:
  StreamRenderer(LiveSession& session, CallbackHooks hooks, double rainLevel)
      : session_(session), hooks_(hooks), rain_(rainLevel) {}

  /// `put(first, signal, rain, count)` stores a run of samples; called one or more times, in order.
  template <class Put>
  void render(std::size_t frames, double entry_s, double (*clock)(), Put put) {
    if (hooks_.enter != nullptr) hooks_.enter();
    lastEntry_s_.store(entry_s, std::memory_order_relaxed);
    for (std::size_t done = 0; done < frames;) {
      const std::size_t left = frames - done, count = left < largestRun ? left : largestRun;
      session_.process(mono_.data(), count, entry_s + static_cast<double>(done) / session_.sampleRate_Hz());
      if (rain_.audible()) rain_.render(drops_.data(), count);
      if (session_.pressSounds()) {
        if (!rain_.audible()) std::fill_n(drops_.begin(), count, 0.0F);
        session_.addPressSound(drops_.data(), mono_.data(), count);
      }
      put(done, mono_.data(), drops_.data(), count);
      done += count;
    }
    session_.account(clock() - entry_s, frames, xrun_.exchange(false, std::memory_order_relaxed));
    if (hooks_.leave != nullptr) hooks_.leave();
  }

  /// Sets the rate of the next stream. Only while no callback runs.
  void setSampleRate(double sampleRate_Hz) {
    if (sampleRate_Hz != session_.sampleRate_Hz()) session_.setSampleRate(sampleRate_Hz);
    rain_.setSampleRate(sampleRate_Hz);
  }
  /// Empties the session's queues while there is no stream.
  void takeWhileAway() { session_.takeWhileAway(); }

  double lastEntry_s() const { return lastEntry_s_.load(std::memory_order_relaxed); }
  void touch(double now_s) { lastEntry_s_.store(now_s, std::memory_order_relaxed); }
  void noteXrun() { xrun_.store(true, std::memory_order_relaxed); }

 private:
  static constexpr std::size_t largestRun = 8192;
  LiveSession& session_;
  CallbackHooks hooks_;
  RainNoise rain_;
  std::array<float, largestRun> mono_{}, drops_{};
  std::atomic<double> lastEntry_s_{0};
  std::atomic<bool> xrun_{false};
};

}  // namespace detent::playback
