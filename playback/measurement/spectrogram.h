// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Frequencies of a vibration over time: a short-time Fourier transform over the band that fingers feel, for
// displays.

#include <cstddef>
#include <vector>

namespace detent::playback {

struct SpectrogramSettings {
  /// Length of the Hann window; (0.001, 1]. Two tones closer than 4 / window_s merge, and so do events closer
  /// than about half the window. 32 ms separates 150, 200 and 390 Hz.
  double window_s = 0.032;
  double hop_s = 0.00125;    ///< requested distance of two columns; (0, window_s]
  double highest_Hz = 1000;  ///< K&L, Apparatus: responses up to 1000 Hz; (0, 0.45 of the sample rate]
};

/// Levels by time and frequency. Plain value.
struct Spectrogram {
  std::size_t columns = 0, rows = 0;
  /// column c is centred at c * hop_s; may differ from the requested distance by less than 25 %
  double hop_s = 0;
  double row_Hz = 0;  ///< row r is centred at r * row_Hz
  /// column by column, rows by increasing frequency; 0 dB is a sine at full scale
  std::vector<float> level_dB;

  float at(std::size_t column, std::size_t row) const { return level_dB[column * rows + row]; }
};

/// Level of silence.
inline constexpr float lowestLevel_dB = -120;

/// Frequencies above `highest_Hz` are filtered out (80 dB) before the sampling rate is reduced. The first and
/// last windows extend beyond the samples, into silence. Any thread; about 5 ms for a second at 48 kHz.
Spectrogram spectrogramOf(const std::vector<float>& samples, double sampleRate_Hz,
                          const SpectrogramSettings& settings = {});

}  // namespace detent::playback
