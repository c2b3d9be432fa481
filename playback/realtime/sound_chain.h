// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Everything of one program that sounds: its voices and their filters. The engine has a few chains, so that
// sounds of a program end as intended after another program took over: no filter or gain changes under a
// sounding voice.

#include <array>
#include <cstddef>
#include <cstdint>

#include "playback/realtime/biquad.h"
#include "playback/realtime/grain_voice.h"
#include "playback/realtime/haptic_program.h"
#include "playback/realtime/voice.h"

namespace detent::playback {

/// Time for lowering the slope to nothing under a jump, and for raising it again, without a click.
inline constexpr double slopeTurn_s = 0.004;

/// Callback thread; no allocation. A large fixed-size object.
class SoundChain {
 public:
  static constexpr std::size_t playingVoices = 12;
  static constexpr std::size_t voiceCount = 24;  // voices that may play; the rest fade out

  /// Silences the chain and sets it up for a program.
  void use(const HapticProgram& program, double sampleRate_Hz);
  /// Silences the chain at once.
  void stop();

  void startGrain(const Burst& burst);
  /// Plays a burst in addition to the others. Returns true if the oldest one had to be stopped.
  bool startBurst(const Burst& burst);

  /// Returns true if nothing sounds and no filter is ringing.
  bool silent() const;
  bool grainSounds() const { return grain_.active(); }
  double grainLoudness() const { return grain_.active() ? grain_.loudest() : 0; }
  /// Approximate upper bound of the sum of its voices in the next `samples`: their envelopes, with gain and
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
         slopeStep_ = 1;  // level of the grains while a jump sounds: now, and change per sample
  double gain_ = 1;
  double raise_ = 1;       // factor by gain and equalizer
  double grainShare_ = 1;  // share of a grain's amplitude after the low-pass
};

}  // namespace detent::playback
