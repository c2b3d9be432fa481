// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All peaking sections of a response at one common minimum: skirts of neighbours, the level they stand on and
// the heights themselves share every frequency, so none is read off a peak alone.
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
  std::vector<Resonance> resonances;  ///< strongest first; gain above the level beside them
  std::vector<ResonanceErrors>
      errors;  ///< one each: from what the sections leave over, neighbours taken as one where they agree
  double rms_dB = 0;  ///< left over
};

/// `frequency_Hz` rising and > 0, `gain_dB` as many; `start`: what stands out, at most 32. Level and slope of
/// the rest are found along with it. Empty where the response is no sum of such sections: none was given, too
/// few points, no minimum, one that left its place (a tenth of its frequency, a height below 0), or 3 dB left
/// over. Deterministic; any thread.
std::optional<JointSections> fitSectionsTogether(const std::vector<double>& frequency_Hz,
                                                 const std::vector<double>& gain_dB,
                                                 const std::vector<Resonance>& start, double sampleRate_Hz);

}  // namespace detent::playback
