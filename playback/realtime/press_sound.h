// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The sound of a press, beside the vibration: a recording that starts with each click, or the vibration
// itself, delayed, on a separate channel.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playback/realtime/haptic_engine.h"

namespace detent::playback {

/// Plain value.
struct PressSound {
  bool rendered = false;         ///< the vibration's samples
  std::vector<float> samples;    ///< if not `rendered`, a recording with full scale 1; empty: no sound
  double sampleRate_Hz = 48000;  ///< sample rate of the recording
  double level_dB = 0;           ///< gain of the sound
  double delay_s = 0;            ///< delay after the click, or of the vibration; >= 0

  bool audible() const { return rendered || !samples.empty(); }
};

/// Plays the sound. A press clicks once: at its first jump, bottom-out or contact after the finger was up.
/// Callback thread, unless stated otherwise, without allocation there.
class PressSounder {
 public:
  /// While no callback runs.
  void use(PressSound sound);
  void setSampleRate(double sampleRate_Hz);

  bool audible() const { return sound_.audible(); }
  /// Takes an event of the engine, at its sample; in order.
  void take(const EngineEvent& event);
  /// Takes the position of the finger after the events so far.
  void take(const HapticProgram* program, const StrokePosition& position);
  /// Adds the sound to the `count` samples before `end_frame` of the engine; `felt`: the samples of the
  /// vibration. The sum is limited to [-1, 1].
  void addTo(float* out, const float* felt, std::size_t count, std::int64_t end_frame);

 private:
  PressSound sound_;
  double rate_Hz_ = 48000, gain_ = 1;
  std::vector<float> late_;  ///< rendered: the vibration during the last delay
  std::size_t lateAt_ = 0;
  /// from_: frame at which the recording began; -1: it is not playing
  std::int64_t delay_frames_ = 0, from_ = -1;
  bool up_ = true;
};

}  // namespace detent::playback
