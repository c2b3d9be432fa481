// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Fits all peaking sections of a response together. The skirts of neighbouring peaks, the level between them
// and their heights influence every frequency, so no value can be read from a single peak.
// docs/develop/decisions/0916-fitting-resonances.md

#include <optional>
#include <vector>

#include "playback/prepare/device_profile.h"

namespace detent::playback {

/// Standard errors of a resonance.
struct ResonanceErrors {
  double frequency_Hz = 0, q = 0, gain_dB = 0;
};

struct JointSections {
  std::vector<Resonance> resonances;  ///< strongest first; gain above the level around them
  std::vector<ResonanceErrors>
      errors;         ///< one each, from the residuals; neighbouring residuals that agree count as one
  double rms_dB = 0;  ///< root mean square of the residuals
};

/// `frequency_Hz` increasing and > 0, `gain_dB` as many; `start`: first estimates of the peaks, at most 32.
/// Level and slope of the remaining response are fitted too. Empty if the response is no sum of such
/// sections: no start value, too few points, no minimum, a section that left its start value (by a tenth of
/// its frequency, or with a height below 0), or residuals of 3 dB. Deterministic; any thread.
std::optional<JointSections> fitSectionsTogether(const std::vector<double>& frequency_Hz,
                                                 const std::vector<double>& gain_dB,
                                                 const std::vector<Resonance>& start, double sampleRate_Hz);

}  // namespace detent::playback
