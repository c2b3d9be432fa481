// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/sound_chain.h"

#include <cmath>

namespace detent::playback {

namespace {
constexpr double grainBehindLowPass =
    0.8;  // the factor 0.71 at the cutoff, where its carrier is, and the effect of restarts
}  // namespace

void SoundChain::use(const HapticProgram& program, double sampleRate_Hz) {
  stop();
  sampleRate_Hz_ = sampleRate_Hz;
  carrier_ = program.grainCarrier;
  lowPass_.setCoefficients(lowPass(sampleRate_Hz, program.lowPass.cutoff_Hz, program.lowPass.order));
  lowPassOnSlope_ = program.lowPass.placement == LowPassPlacement::slopeOnly;
  lowPassOnAll_ = program.lowPass.placement == LowPassPlacement::wholeChain;
  highPassOn_ = program.highPass_Hz > 0;
  highPass_.setCoefficients(highPass(sampleRate_Hz, program.highPass_Hz));
  equalizerCount_ = 0;
  raise_ = program.gain;
  grainShare_ = program.lowPass.placement == LowPassPlacement::none ? 1 : grainBehindLowPass;
  for (std::size_t i = 0; i < program.equalizerBandCount && i < maxEqualizerBands; ++i) {
    const EqualizerBand& band = program.equalizer[i];
    equalizer_[equalizerCount_++].setCoefficients(
        peaking(sampleRate_Hz, band.frequency_Hz, band.q, band.gain_dB));
    if (band.gain_dB > 0) raise_ *= std::pow(10, band.gain_dB / 20);
  }
  underJump_ = program.slopeUnderJump;
  slopeLevel_ = 1;
  slopeStep_ = 1 / (slopeTurn_s * sampleRate_Hz);
  stealFade_frames_ = static_cast<std::int64_t>(program.stealFade_s * sampleRate_Hz);
  gain_ = program.gain;
}

void SoundChain::stop() {
  grain_ = GrainVoice{};
  for (Voice& v : voices_) v.stop();
  lowPass_.reset();
  highPass_.reset();
  slopeLevel_ = 1;
  for (Biquad& section : equalizer_) section.reset();
}

void SoundChain::startGrain(const Burst& burst) { grain_.start(burst, carrier_, sampleRate_Hz_); }

bool SoundChain::startBurst(const Burst& burst) {
  if (!(burst.amplitude > 0) || !(burst.duration_s > 0)) return false;
  std::size_t playing = 0;
  Voice *oldest = nullptr, *free = nullptr, *mostFaded = nullptr;
  for (Voice& v : voices_) {
    if (!v.active()) {
      free = &v;
    } else if (v.fading()) {
      if (mostFaded == nullptr || v.fadeLevel() < mostFaded->fadeLevel()) mostFaded = &v;
    } else {
      ++playing;
      if (oldest == nullptr || v.age() > oldest->age()) oldest = &v;
    }
  }
  const bool steals = playing >= playingVoices;
  if (steals) oldest->fadeOut(stealFade_frames_);
  // If more voices were stolen within one fade than there are spare ones, no voice is free. The voice closest
  // to silence is then replaced.
  if (free == nullptr) free = mostFaded != nullptr ? mostFaded : oldest;
  free->start(burst, sampleRate_Hz_);
  return steals;
}

bool SoundChain::silent() const {
  if (grain_.active() || slopeLevel_ < 1) return false;
  if ((lowPassOnSlope_ || lowPassOnAll_) && !lowPass_.silent()) return false;
  if (highPassOn_ && !highPass_.silent()) return false;
  for (std::size_t i = 0; i < equalizerCount_; ++i) {
    if (!equalizer_[i].silent()) return false;
  }
  for (const Voice& v : voices_) {
    if (v.active()) return false;
  }
  return true;
}

double SoundChain::loudestWithin(double samples) const {
  double sum = grain_.active() ? grainShare_ * grain_.loudest() : 0;
  for (const Voice& v : voices_) {
    if (v.active()) sum += v.loudestWithin(samples);
  }
  return raise_ * sum;
}

void SoundChain::quietenSlope(double* bus, std::size_t count) {
  std::int64_t jumps = 0;  // samples until the last jump has ended
  for (const Voice& v : voices_) {
    if (v.active() && v.quietensSlope() && v.left() > jumps) jumps = v.left();
  }
  if (jumps == 0 && slopeLevel_ == 1) return;
  for (std::size_t i = 0; i < count; ++i) {
    if (static_cast<std::int64_t>(i) < jumps) {
      slopeLevel_ = slopeLevel_ - slopeStep_ > underJump_ ? slopeLevel_ - slopeStep_ : underJump_;
    } else {
      slopeLevel_ = slopeLevel_ + slopeStep_ < 1 ? slopeLevel_ + slopeStep_ : 1;
    }
    bus[i] *= slopeLevel_;
  }
}

void SoundChain::addTo(double* mix, double* bus, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bus[i] = 0;
  if (grain_.active()) grain_.addTo(bus, count);
  if (lowPassOnSlope_) lowPass_.process(bus, count);
  if (highPassOn_) highPass_.process(bus, count);
  if (underJump_ < 1) quietenSlope(bus, count);
  for (Voice& v : voices_) {
    if (v.active()) v.addTo(bus, count);
  }
  if (lowPassOnAll_) lowPass_.process(bus, count);
  for (std::size_t i = 0; i < equalizerCount_; ++i) equalizer_[i].process(bus, count);
  for (std::size_t i = 0; i < count; ++i) mix[i] += gain_ * bus[i];
}

}  // namespace detent::playback
