// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The single voice of the slope: grains follow each other on it, and a new one may begin before the last has
// ended.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "playback/realtime/haptic_program.h"
#include "playback/realtime/sine.h"

namespace detent::playback {

/// Kim & Lee: "If a new grain signal comes during playing the previous signal, the new one is played
/// immediately." On a running carrier the new grain restarts the envelope while the sine continues (an
/// oscillator times an envelope, as in a Pure Data patch). Retriggered, the sine restarts too; if grains come
/// faster than half waves, no half wave is ever completed. A grain after silence begins at phase 0 in both
/// modes, so a single grain is the closed form of Burst.
class GrainVoice {
 public:
  bool active() const { return envelopeAge_ < envelopeLength_; }
  /// A new grain may restart the envelope at any time, so this is always its full amplitude.
  double loudest() const { return amplitude_; }

  void start(const Burst& burst, GrainCarrier carrier, double sampleRate_Hz) {
    const bool runsOn = carrier == GrainCarrier::running && active();
    if (!runsOn) {
      carrierAge_ = 0;
      firstPhase_ = 0;
    } else if (cyclesPerSample_ != cyclesPerSample(burst.frequency_Hz, sampleRate_Hz)) {
      firstPhase_ = phase();
      carrierAge_ = 0;
    }
    cyclesPerSample_ = cyclesPerSample(burst.frequency_Hz, sampleRate_Hz);
    amplitude_ = burst.amplitude;
    envelope_ = burst.envelope;
    const double exactLength = samplesIn(burst.duration_s, sampleRate_Hz);
    perLength_ = exactLength > 0 ? 1 / exactLength : 0;
    envelopeLength_ = exactLength > 0 ? static_cast<std::int64_t>(std::ceil(exactLength - 1e-9)) : 0;
    envelopeAge_ = 0;
  }

  /// Adds up to `count` samples to `bus`.
  void addTo(double* bus, std::size_t count) {
    const std::int64_t left = envelopeLength_ - envelopeAge_;
    const auto n = static_cast<std::int64_t>(count) < left ? static_cast<std::int64_t>(count) : left;
    for (std::int64_t i = 0; i < n; ++i) {
      const double ramp = static_cast<double>(envelopeAge_++) * perLength_;
      const double level = amplitude_ * (envelope_ == Envelope::falling ? 1 - ramp : ramp);
      bus[i] += level * sineOfCycles(phase());
      ++carrierAge_;
    }
  }

 private:
  /// Phase of the next sample, in cycles within [0, 1). Computed from the whole number of samples, so that
  /// errors do not accumulate.
  double phase() const {
    const double cycles = firstPhase_ + static_cast<double>(carrierAge_) * cyclesPerSample_;
    return cycles - static_cast<double>(static_cast<std::int64_t>(cycles));
  }

  double cyclesPerSample_ = 0, firstPhase_ = 0;
  double amplitude_ = 0;
  double perLength_ = 0;
  std::int64_t carrierAge_ = 0;
  std::int64_t envelopeAge_ = 0, envelopeLength_ = 0;
  Envelope envelope_ = Envelope::falling;
};

}  // namespace detent::playback
