// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The frequency response of a vibrating device (K&L, Figure 5: 10 Hz to 1000 Hz) from one logarithmic sweep,
// after A. Farina, "Simultaneous measurement of impulse response and distortion with a swept-sine technique",
// AES 2000: deconvolution puts the distortion before the impulse response, where it is cut away.

#include <string>
#include <vector>

#include "model/result.h"
#include "playback/measurement/joint_sections.h"
#include "playback/prepare/device_profile.h"

namespace detent::playback {

struct SweepSettings {
  double sampleRate_Hz = 48000;
  double from_Hz = 10, to_Hz = 1000;  ///< K&L, Apparatus; 0 < from < to < sampleRate / 2
  double duration_s = 10;             ///< (0.5, 120]
  /// silence after the sweep, for the ringing of the device and the delay of the sound path
  double silence_s = 1;
  double level = 0.5;                 ///< share of full scale; (0, 1]
  double resonanceProminence_dB = 3;  ///< height of a peak above its valleys from which it counts
  double highestCut_dB = 12;          ///< equalizer bands attenuate at most this much
};

/// The samples to play.
std::vector<float> sweepSignal(const SweepSettings& settings);

struct FrequencyResponse {
  std::vector<double> frequency_Hz;   ///< 1/24-octave steps, from_Hz to to_Hz
  std::vector<double> gain_dB;        ///< ratio of recorded to played
  std::vector<Resonance> resonances;  ///< strongest first
  std::vector<ResonanceErrors>
      /// one for each resonance; empty if the response is no sum of peaking sections, so each peak was
      /// measured alone
      errors;
  double delay_s = 0;  ///< delay of the sound path
  std::vector<double>
      dropouts_s;  ///< times at which the recording differs from the expected response: sound was lost
};

/// `recorded` has the length of `played`. Failure notCertain: the recording does not contain the sweep.
Result<FrequencyResponse> analyseSweep(const std::vector<float>& played, const std::vector<float>& recorded,
                                       const SweepSettings& settings);

/// Returns true if two sweeps of one device gave the same result: equally many resonances, each within 3 %
/// and 2 dB, and gains with a median difference below 1 dB. Dropouts, or a machine too busy to play, cause
/// differences.
bool agree(const FrequencyResponse& a, const FrequencyResponse& b);

/// Level in dB above threshold (felt_level.h) of a sine of full scale at 250 Hz, without the resonances.
/// `inputFullScale_m_per_s2` (> 0): acceleration at the recorder's full scale.
double fullScaleLevel_dB(const FrequencyResponse& response, const SweepSettings& settings,
                         double inputFullScale_m_per_s2);

/// Adds the resonances, and an equalizer that flattens them, to a profile.
void applyResponse(const FrequencyResponse& response, const SweepSettings& settings, DeviceProfile& profile);

std::string responseCsv(const FrequencyResponse& response);

}  // namespace detent::playback
