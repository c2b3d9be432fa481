// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Plays samples that another program made, unchanged, in addition to what the engine plays.

#include <array>
#include <cstddef>

namespace detent::playback {

/// Samples at the stream's rate. Plain value; the samples must live until it is returned.
struct SoundTake {
  const float* samples = nullptr;
  std::size_t count = 0;
  double peak = 0;  ///< largest |sample|
};

/// One take at a time; one that is stopped or replaced fades out. Callback thread; no allocation.
class TakePlayer {
 public:
  /// Restarts at another rate. Playing takes stop without a fade; `nextEnded` returns them.
  void setSampleRate(double sampleRate_Hz);
  /// Plays `take` from the next sample on (nullptr: nothing) and fades out the one before over 5 ms.
  void play(const SoundTake* take);
  /// >= 0, changed in a ramp of 10 ms. A take is never raised beyond full scale.
  void setGain(double gain) { gainTarget_ = gain; }
  /// Adds `count` samples to `out`; the sum is limited to [-1, 1]. Returns the largest |sum|, 0 if nothing
  /// plays.
  float addTo(float* out, std::size_t count);
  /// Stops without a fade.
  void stop();
  /// A take that is no longer read; returns false if there is none.
  bool nextEnded(const SoundTake*& take);

 private:
  struct Playing {
    const SoundTake* take = nullptr;
    std::size_t next = 0;
    double fade = 1, fadeStep = 0;  ///< present level, and decrease per sample
  };
  void end(Playing& playing);
  double nextOf(Playing& playing) const;

  double gain_ = 1, gainTarget_ = 1, gainStep_ = 1, fadeStep_ = 1;
  Playing current_, fading_;
  static constexpr std::size_t mostEnded =
      64;  // a power of two; more than the commands that can wait in a lane within one block
  std::array<const SoundTake*, mostEnded> ended_{};
  std::size_t endedHead_ = 0, endedCount_ = 0;
};

}  // namespace detent::playback
