// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The last stage: it keeps the output within full scale, whatever voices, equalizer and gain do.

#include <cstddef>

namespace detent::playback {

/// Limiter without latency. For a peak that `expect` announces, the gain falls linearly before it, so that an
/// attack keeps its form; for any other peak it falls at once. The gain recovers linearly and is exactly 1
/// again after `release`. Below the ceiling the signal passes unchanged. Samples that are not finite become
/// silence.
class Limiter {
 public:
  /// ceiling in (0, 1]; release in samples, >= 1.
  void configure(double ceiling, double release_samples) {
    ceiling_ = ceiling;
    recovery_ = 1 / (release_samples > 1 ? release_samples : 1);
  }
  void reset() {
    gain_ = highest_ = 1;
    fall_ = 0;
  }
  bool idle() const { return gain_ == 1 && highest_ == 1; }
  double gain() const { return gain_; }
  double ceiling() const { return ceiling_; }

  /// Announces that coming samples need a gain of at most `highest` (0..1], reached `within` samples from
  /// now.
  void expect(double highest, std::size_t within) {
    highest_ = highest;
    fall_ = gain_ > highest ? (gain_ - highest) / static_cast<double>(within + 1) : 0;
  }

  void process(const double* in, float* out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      double x = in[i];
      if (!(x - x == 0)) x = 0;  // infinite or not a number
      const double level = x < 0 ? -x : x;
      if (gain_ > highest_) {
        gain_ -= fall_;
        if (gain_ < highest_) gain_ = highest_;
      } else {
        gain_ += recovery_;
        if (gain_ > highest_) gain_ = highest_;
      }
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
  double highest_ = 1, fall_ = 0;
};

}  // namespace detent::playback
