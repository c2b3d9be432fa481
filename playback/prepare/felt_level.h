// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Felt strength of a vibration at a fingertip, in dB above its threshold: the Pacinian channel of
// docs/reference/predicted-confusion.md, best at 250 Hz, after the device's response.

#include <cstddef>

#include "playback/prepare/device_profile.h"
#include "playback/realtime/haptic_program.h"

namespace detent::playback {

/// Assumed level of a sine of full scale at 250 Hz on a device whose level was not measured: MPEG's haptics
/// reference model (ISO/IEC 23090-31).
inline constexpr double assumedFullScale_dB = 45;

inline double fullScale_dB(const DeviceProfile& device) {
  return device.fullScale_dB.value_or(assumedFullScale_dB);
}

/// Acceleration of the fingertip at 250 Hz that is just felt, peak: a displacement of 0.1 um (Verrillo 1963:
/// -20 dB re 1 um for a large contactor, +- 5 dB from one person to another).
inline constexpr double threshold_m_per_s2 = 0.25;

/// Threshold of the Pacinian channel at `frequency_Hz` (> 0) over that at 250 Hz: 12 dB per octave on both
/// flanks, 0 at best.
double pacinianWeight_dB(double frequency_Hz);

/// Gain at a frequency by the device's response, its equalizer and its gain setting.
double raisedBy_dB(const DeviceProfile& device, const HapticProgram& program, double frequency_Hz);

/// Level of a burst's strongest 10 ms, dB above threshold; -infinity if its amplitude is 0.
double feltLevel_dB(const Burst& burst, const DeviceProfile& device, const HapticProgram& program);
/// Level of grains that follow each other so closely that they are one tone.
double feltSlopeLevel_dB(const DeviceProfile& device, const HapticProgram& program);

}  // namespace detent::playback
