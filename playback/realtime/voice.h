// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One sounding burst: a pure function of the sample index since its start, with an optional fade-out when it
// is stolen.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "playback/realtime/haptic_program.h"
#include "playback/realtime/sine.h"

namespace detent::playback {

class Voice {
 public:
  bool active() const { return position_ < length_; }
  bool fading() const { return fadeLength_ > 0; }
  bool quietensSlope() const { return quietensSlope_; }
  std::int64_t left() const { return length_ - position_; }
  std::int64_t age() const { return position_; }
  /// Highest value of its envelope in the next `samples`, without the effect of a fade-out.
  double loudestWithin(double samples) const {
    const double now = static_cast<double>(position_) * perLength_, then = now + samples * perLength_;
    return amplitude_ * (envelope_ == Envelope::falling ? 1 - now : then < 1 ? then : 1);
  }
  /// Remaining level of a fading voice; 1 if it is not fading.
  double fadeLevel() const {
    return fading() ? 1.0 - static_cast<double>(fadePosition_) / static_cast<double>(fadeLength_) : 1.0;
  }

  void start(const Burst& burst, double sampleRate_Hz) {
    cyclesPerSample_ = cyclesPerSample(burst.frequency_Hz, sampleRate_Hz);
    amplitude_ = burst.amplitude;
    envelope_ = burst.envelope;
    quietensSlope_ = burst.quietensSlope;
    const double exactLength = samplesIn(burst.duration_s, sampleRate_Hz);
    perLength_ = exactLength > 0 ? 1 / exactLength : 0;
    length_ = exactLength > 0 ? static_cast<std::int64_t>(std::ceil(exactLength - 1e-9)) : 0;
    position_ = 0;
    fadeLength_ = fadePosition_ = 0;
  }

  void fadeOut(std::int64_t samples) {
    if (fading()) return;
    fadeLength_ = samples > 1 ? samples : 1;
    fadePosition_ = 0;
    if (length_ > position_ + fadeLength_) length_ = position_ + fadeLength_;
  }

  void stop() { position_ = length_ = 0; }

  /// Adds up to `count` samples to `bus`.
  void addTo(double* bus, std::size_t count) {
    const std::int64_t left = length_ - position_;
    const auto n = static_cast<std::int64_t>(count) < left ? static_cast<std::int64_t>(count) : left;
    for (std::int64_t i = 0; i < n; ++i) bus[i] += nextSample();
  }

 private:
  double nextSample() {
    const auto t = static_cast<double>(position_++);
    const double cycles = t * cyclesPerSample_;
    const double ramp = t * perLength_;
    double level = amplitude_ * (envelope_ == Envelope::falling ? 1 - ramp : ramp);
    if (fadeLength_ > 0) {
      level *= 1.0 - static_cast<double>(fadePosition_++) / static_cast<double>(fadeLength_);
    }
    return level * sineOfCycles(cycles - static_cast<double>(static_cast<std::int64_t>(cycles)));
  }

  double cyclesPerSample_ = 0;
  double amplitude_ = 0;
  double perLength_ = 0;
  std::int64_t length_ = 0, position_ = 0;
  std::int64_t fadeLength_ = 0, fadePosition_ = 0;
  Envelope envelope_ = Envelope::falling;
  bool quietensSlope_ = false;
};

}  // namespace detent::playback
