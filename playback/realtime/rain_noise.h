// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sound of rain for the ears, so that the vibration is felt and not heard (K&L, Experiment 1: the noisy group
// wore headphones "playing an ambient raining sound").

#include <array>
#include <cstddef>
#include <cstdint>

#include "playback/realtime/biquad.h"

namespace detent::playback {

/// Falling rain: pink noise with drops, without frequencies below 60 Hz. The same in every run. Callback
/// thread, except for the constructor and `setSampleRate`; no allocation.
class RainNoise {
 public:
  /// `level`: rms, share of full scale, 0 (none) to 0.3, where the first samples are clipped.
  explicit RainNoise(double level);

  /// While no callback runs.
  void setSampleRate(double sampleRate_Hz);
  bool audible() const { return level_ > 0; }
  /// Writes `count` samples within [-1, 1]; the level rises within a second.
  void render(float* out, std::size_t count);

 private:
  struct Drop {
    double re = 0, im = 0;  // a damped rotation; its sine component is the sound
    double turnRe = 0, turnIm = 0;
  };
  double chance();
  double next();
  void letFall();
  double rmsOf(double seconds);

  double level_, rate_Hz_ = 48000, scale_ = 1;
  double fade_ = 0, fadeStep_ = 0;
  std::uint64_t random_ = 0;
  std::array<double, 3> rush_{}, keep_{}, take_{};
  std::array<Drop, 16> drops_{};
  std::size_t nextDrop_ = 0;
  double untilDrop_ = 0;
  Biquad rumble_;
};

}  // namespace detent::playback
