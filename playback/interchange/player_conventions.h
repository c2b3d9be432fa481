// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Conventions of players by other makers: Apple's, which all phone formats follow (intensity is the square
// root of an amplitude), and motors that vibrate at a fixed frequency of their own.

#include <algorithm>

namespace detent::playback {

/// Frequencies that correspond to sharpness 0 and 1.
inline constexpr double lowestSharpness_Hz = 80, highestSharpness_Hz = 230;

/// Sharpness of a frequency, limited to 0..1.
inline double sharpnessOf(double frequency_Hz) {
  return std::clamp((frequency_Hz - lowestSharpness_Hz) / (highestSharpness_Hz - lowestSharpness_Hz), 0.0,
                    1.0);
}
inline double frequencyOf(double sharpness) {
  return lowestSharpness_Hz + (highestSharpness_Hz - lowestSharpness_Hz) * sharpness;
}

/// Duration of a transient in players: two cycles of 90 Hz.
inline constexpr double transient_s = 0.022;

/// An LRA vibrates at its own resonance, whatever frequency is requested. 205 Hz is common, and the default
/// of the DA7280.
inline constexpr double assumedResonance_Hz = 205;

}  // namespace detent::playback
