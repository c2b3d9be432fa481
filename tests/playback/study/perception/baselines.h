// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measures of others for how alike two vibrations are, to stand beside the forecast: ST-SIM and SPQI of the
// vibrotactile codec literature, and a plain spectral distance. docs/reference/predicted-confusion.md has the
// formulas. All are distances here: larger is more different. Any thread.

#include "playback/study/perception/felt_button.h"

namespace detent::playback {

/// 1 - ST-SIM: blocks of 512 samples at 8 kHz, support of the spectrum by threshold, temporal^(2/3) *
/// spectral^(1/3). [0, 1].
double stSimDistance(const std::vector<float>& a, const std::vector<float>& b);

/// 1 - SPQI of the perceptual spectra. [0, 1].
double spqiDistance(const std::vector<float>& a, const std::vector<float>& b);

/// Root mean square difference of the magnitude spectra in dB, floor 60 dB below the larger's peak.
double spectralDistance_dB(const std::vector<float>& a, const std::vector<float>& b);

/// A measure of two buttons: mean over presses, strokes and states.
using VibrationDistance = double (*)(const std::vector<float>&, const std::vector<float>&);
double distanceBetween(const FeltButton& a, const FeltButton& b, VibrationDistance distance);

}  // namespace detent::playback
