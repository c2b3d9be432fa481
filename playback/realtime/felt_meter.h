// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Felt strength of the output at a fingertip, in dB above its threshold: the samples after the device's
// response and the weight of the Pacinian channel (docs/reference/predicted-confusion.md).

#include <array>
#include <cstddef>

#include "playback/realtime/biquad.h"
#include "playback/realtime/haptic_program.h"

namespace detent::playback {

/// The Pacinian channel: two band-passes in series, 12 dB per octave on both flanks.
inline constexpr double pacinianBest_Hz = 250, pacinianQ = 0.9;
inline constexpr std::size_t pacinianSections = 2;

/// One owner, any thread; no allocation.
class FeltMeter {
 public:
  /// Measures for this program's device from now on; keeps nothing else of the program.
  void use(const HapticProgram& program, double sampleRate_Hz);
  void add(const float* samples, std::size_t count);
  /// Level of the strongest 10 ms since the last call, dB above threshold; -infinity: silence.
  double take_dB();

 private:
  static constexpr std::size_t slots = 4;  // overlapping windows of 10 ms, so that no burst falls between two
  static constexpr std::size_t span = 256;

  void addSpan(const float* samples, std::size_t count);
  void endSlot();
  bool silent() const;

  std::array<Biquad, maxEqualizerBands + pacinianSections> sections_;
  std::size_t sectionCount_ = 0;
  double fullScale_dB_ = 0;
  std::size_t slotLength_ = 0, inSlot_ = 0, slot_ = 0;
  std::array<double, slots> sums_{};
  double strongest_ = 0;  // mean square
  std::array<double, span> samples_{};
};

}  // namespace detent::playback
