// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The signal that a player makes of an exported file: sines whose amplitude and frequency are linear between
// points. Every format is reduced to this, and its loss is computed from this signal.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace detent::playback {

/// One point of a sine's envelope.
struct WavePoint {
  double time_s = 0;
  double amplitude = 0;  ///< share of full scale; negative: the opposite phase
  double frequency_Hz = 0;
};

/// One cycle, from phase 0 to 1.
enum class WaveShape : std::uint8_t {
  sine,
  square,        ///< 1, then -1
  triangle,      ///< 0, 1, 0, -1
  sawtoothUp,    ///< 0 to 1, -1 to 0
  sawtoothDown,  ///< 0 to -1, 1 to 0
  constant       ///< 1: the amplitudes themselves are the samples
};

/// amplitude(t) * shape(phase + integral of the frequency since the first point) from the first point to the
/// last; silent outside. Two points at one time are a step.
struct PlayedWave {
  std::vector<WavePoint> points;  ///< by time, never falling
  double phase_cycles = 0;
  WaveShape shape = WaveShape::sine;
};

/// Adds the waves to `samples`; sample i lies at i / sampleRate_Hz.
void addTo(std::vector<double>& samples, const std::vector<PlayedWave>& waves, double sampleRate_Hz);

}  // namespace detent::playback
