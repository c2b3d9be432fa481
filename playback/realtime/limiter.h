// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The last stage: whatever the voices, the equalizer and the gain did, the output never exceeds full scale.

#include <cstddef>

namespace detent::playback {

/// Zero-latency limiter: the gain falls at once to what the sample needs and recovers in a straight line, so
/// it is exactly 1 again after `release`. Below the ceiling the signal passes bit for bit. Not finite samples
/// become silence.
class Limiter {
 public:
  /// ceiling in (0, 1]; release in samples, >= 1.
  void configure(double ceiling, double release_samples) {
    ceiling_ = ceiling;
    recovery_ = 1 / (release_samples > 1 ? release_samples : 1);
  }
  void reset() { gain_ = 1; }
  bool idle() const { return gain_ == 1; }
  double gain() const { return gain_; }

  void process(const double* in, float* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      double x = in[i];
      if (!(x - x == 0)) x = 0;  // infinite or not a number
      const double level = x < 0 ? -x : x;
      gain_ += recovery_;
      if (gain_ > 1) gain_ = 1;
      if (level * gain_ > ceiling_) gain_ = ceiling_ / level;
      double y = x * gain_;
      if (y > ceiling_) y = ceiling_;
      if (y < -ceiling_) y = -ceiling_;
      out[i] = static_cast<float>(y);
    }
  }

 private:
  double ceiling_ = 1;
  double recovery_ = 1;
  double gain_ = 1;
};

}  // namespace detent::playback
