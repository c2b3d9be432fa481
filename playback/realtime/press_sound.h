// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The sound of a press, beside the vibration: a recording that begins with each click, or the vibration
// itself, delayed, on a channel of its own.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playback/realtime/haptic_engine.h"

namespace detent::playback {

/// Plain value.
struct PressSound {
  bool rendered = false;         ///< the vibration's samples
  std::vector<float> samples;    ///< else a recording, full scale is 1; none: nothing is heard
  double sampleRate_Hz = 48000;  ///< of the recording
  double level_dB = 0;           ///< added to it
  double delay_s = 0;            ///< behind the click, or the vibration; >= 0

  bool audible() const { return rendered || !samples.empty(); }
};

/// Plays it. A press clicks once: at its first jump, bottom-out or contact after the finger was up. Callback
/// thread, except where another is named; no allocation there.
class PressSounder {
 public:
  /// While no callback runs.
  void use(PressSound sound);
  void setSampleRate(double sampleRate_Hz);

  bool audible() const { return sound_.audible(); }
  /// An event of the engine, at its sample; in order.
  void take(const EngineEvent& event);
  /// Where the finger is after the events so far.
  void take(const HapticProgram* program, const StrokePosition& position);
  /// Adds the sound to the `count` samples before `end_frame` of the engine; `felt`: the vibration's. The sum
  /// is held within [-1, 1].
  void addTo(float* out, const float* felt, std::size_t count, std::int64_t end_frame);

 private:
  PressSound sound_;
  double rate_Hz_ = 48000, gain_ = 1;
  std::vector<float> late_;  ///< rendered: the vibration of the last delay
  std::size_t lateAt_ = 0;
  std::int64_t delay_frames_ = 0, from_ = -1;  ///< from_: where the recording began; -1: it does not play
  bool up_ = true;
};

}  // namespace detent::playback
