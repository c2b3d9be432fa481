// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Samples that another program made, played as they are beside what the engine plays.

#include <array>
#include <cstddef>

namespace detent::playback {

/// Samples at the stream's rate. Plain value; what it names must live until it comes back.
struct SoundTake {
  const float* samples = nullptr;
  std::size_t count = 0;
  double peak = 0;  ///< largest |sample|
};

/// One take at a time; one that is stopped or replaced fades out. Callback thread; no allocation.
class TakePlayer {
 public:
  /// Starts over at another rate. Takes that play stop without a fade; `nextEnded` returns them.
  void setSampleRate(double sampleRate_Hz);
  /// Plays `take` from the next sample on (nullptr: nothing) and fades out the one before over 5 ms.
  void play(const SoundTake* take);
  /// >= 0, in a ramp of 10 ms. A take is never raised beyond full scale.
  void setGain(double gain) { gainTarget_ = gain; }
  /// Adds `count` samples to `out`; the sum is held within [-1, 1]. Gives the largest |sum|, 0 where nothing
  /// plays.
  float addTo(float* out, std::size_t count);
  /// Drops what plays.
  void stop();
  /// A take that is no longer read; false when there is none.
  bool nextEnded(const SoundTake*& take);

 private:
  struct Playing {
    const SoundTake* take = nullptr;
    std::size_t next = 0;
    double fade = 1, fadeStep = 0;  ///< level now, lost per sample
  };
  void end(Playing& playing);
  double nextOf(Playing& playing) const;

  double gain_ = 1, gainTarget_ = 1, gainStep_ = 1, fadeStep_ = 1;
  Playing current_, fading_;
  static constexpr std::size_t mostEnded =
      64;  // a power of two; more than commands that wait in a lane in one block
  std::array<const SoundTake*, mostEnded> ended_{};
  std::size_t endedHead_ = 0, endedCount_ = 0;
};

}  // namespace detent::playback
