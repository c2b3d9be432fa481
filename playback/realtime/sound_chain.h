// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Everything of one program that sounds: its voices and the filters they go through. The engine holds a few,
// so that what a program began ends as that program meant it after another one took over: no filter or gain
// changes under a sounding voice.

#include <array>
#include <cstddef>
#include <cstdint>

#include "playback/realtime/biquad.h"
#include "playback/realtime/grain_voice.h"
#include "playback/realtime/haptic_program.h"
#include "playback/realtime/voice.h"

namespace detent::playback {

/// Time to lower the slope to nothing under a jump, and back, without a click.
inline constexpr double slopeTurn_s = 0.004;

/// Callback thread; no allocation. A large fixed-size object.
class SoundChain {
 public:
  static constexpr std::size_t playingVoices = 12;
  static constexpr std::size_t voiceCount = 24;  // the rest fade out

  /// Silent, and set up for a program.
  void use(const HapticProgram& program, double sampleRate_Hz);
  /// Silent at once.
  void stop();

  void startGrain(const Burst& burst);
  /// Plays a burst beside the others. True if the oldest one had to give way.
  bool startBurst(const Burst& burst);

  /// Returns true if nothing sounds and no filter rings.
  bool silent() const;
  bool grainSounds() const { return grain_.active(); }
  double grainLoudness() const { return grain_.active() ? grain_.loudest() : 0; }
  /// Approximate bound of the sum of its voices in the next `samples`: their envelopes, raised by gain and
  /// equalizer.
  double loudestWithin(double samples) const;

  /// Adds `count` samples to `mix`; `bus` is working space of that length.
  void addTo(double* mix, double* bus, std::size_t count);

 private:
  void quietenSlope(double* bus, std::size_t count);

  double sampleRate_Hz_ = 48000;
  GrainCarrier carrier_ = GrainCarrier::running;
  GrainVoice grain_;
  std::array<Voice, voiceCount> voices_;
  Biquad lowPass_, highPass_;
  bool lowPassOnSlope_ = false, lowPassOnAll_ = false, highPassOn_ = false;
  std::array<Biquad, maxEqualizerBands> equalizer_;
  std::size_t equalizerCount_ = 0;
  std::int64_t stealFade_frames_ = 1;
  double underJump_ = 1, slopeLevel_ = 1,
         slopeStep_ = 1;  // of the grains while a jump sounds, now, per sample
  double gain_ = 1;
  double raise_ = 1;       // by gain and equalizer
  double grainShare_ = 1;  // of a grain's amplitude that is left behind the low-pass
};

}  // namespace detent::playback
