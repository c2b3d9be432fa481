// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What players of other makers are taken to do: Apple's, on which every format of phones leans (intensity is
// the root of an amplitude), and motors that choose their frequency themselves.

#include <algorithm>

namespace detent::playback {

/// What sharpness 0 and 1 stand for.
inline constexpr double lowestSharpness_Hz = 80, highestSharpness_Hz = 230;

/// Within 0..1.
inline double sharpnessOf(double frequency_Hz) {
  return std::clamp((frequency_Hz - lowestSharpness_Hz) / (highestSharpness_Hz - lowestSharpness_Hz), 0.0,
                    1.0);
}
inline double frequencyOf(double sharpness) {
  return lowestSharpness_Hz + (highestSharpness_Hz - lowestSharpness_Hz) * sharpness;
}

/// How long players let a transient sound: two cycles of 90 Hz.
inline constexpr double transient_s = 0.022;

/// An LRA plays at its own resonance whatever is asked; 205 Hz is the DA7280's default and common.
inline constexpr double assumedResonance_Hz = 205;

}  // namespace detent::playback
