// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Converts times of a steady clock to samples of the audio stream, so that an event can be placed at its
// time. Pure: the caller reads the clock.

#include <cstdint>

namespace detent::playback {

/// Follows the entries of callbacks. A callback is never early, only late, so the line through the earliest
/// entries gives the stream's true start times. A step of more than a block (xrun, device restart) starts a
/// new line.
class StreamClock {
 public:
  explicit StreamClock(double sampleRate_Hz) : sampleRate_Hz_(sampleRate_Hz) {}

  /// A callback for samples startFrame .. startFrame + frames was entered at `entry_s`.
  void onCallback(double entry_s, std::int64_t startFrame, std::int64_t frames) {
    const double predicted_s = base_s_ + static_cast<double>(startFrame - baseFrame_) / sampleRate_Hz_;
    const double late_s = entry_s - predicted_s;
    const double period_s = static_cast<double>(frames) / sampleRate_Hz_;
    const bool newLine = !running_ || late_s > period_s || late_s < -period_s;
    base_s_ = newLine || late_s < 0 ? entry_s : predicted_s + follow * late_s;
    baseFrame_ = startFrame;
    running_ = true;
  }

  /// The sample that corresponds to `time_s`; 0 before the first callback.
  double frameAt(double time_s) const {
    return running_ ? static_cast<double>(baseFrame_) + (time_s - base_s_) * sampleRate_Hz_ : 0;
  }

 private:
  static constexpr double follow =
      0.02;  // weight of a callback's lateness: follows clock drift, ignores single late wake-ups
  double sampleRate_Hz_;
  double base_s_ = 0;
  std::int64_t baseFrame_ = 0;
  bool running_ = false;
};

}  // namespace detent::playback
