// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/take_player.h"

namespace detent::playback {

namespace {
constexpr double takeFade_s = 0.005;
constexpr double takeGainRamp_s = 0.01;  // the same as the engine's
}  // namespace

void TakePlayer::setSampleRate(double sampleRate_Hz) {
  stop();
  fadeStep_ = 1 / (takeFade_s * sampleRate_Hz);
  gainStep_ = 1 / (takeGainRamp_s * sampleRate_Hz);
}

void TakePlayer::stop() {
  end(current_);
  end(fading_);
}

void TakePlayer::end(Playing& playing) {
  if (playing.take == nullptr) return;
  ended_[(endedHead_ + endedCount_) % mostEnded] = playing.take;
  if (endedCount_ < mostEnded) ++endedCount_;
  playing = {};
}

bool TakePlayer::nextEnded(const SoundTake*& take) {
  if (endedCount_ == 0) return false;
  take = ended_[endedHead_];
  endedHead_ = (endedHead_ + 1) % mostEnded;
  --endedCount_;
  return true;
}

void TakePlayer::play(const SoundTake* take) {
  end(fading_);
  fading_ = current_;
  fading_.fadeStep = fadeStep_;
  current_ = {};
  current_.take = take;
  if (fading_.take == nullptr) gain_ = gainTarget_;
}

double TakePlayer::nextOf(Playing& playing) const {
  const SoundTake& take = *playing.take;
  const double most = take.peak > 0 ? 1 / take.peak : 1;
  const double gain = gain_ < most ? gain_ : most;
  const double sample = gain * playing.fade * static_cast<double>(take.samples[playing.next++]);
  playing.fade -= playing.fadeStep;
  return sample;
}

float TakePlayer::addTo(float* out, std::size_t count) {
  float peak = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (current_.take == nullptr && fading_.take == nullptr) break;
    if (gain_ < gainTarget_) gain_ = gain_ + gainStep_ < gainTarget_ ? gain_ + gainStep_ : gainTarget_;
    if (gain_ > gainTarget_) gain_ = gain_ - gainStep_ > gainTarget_ ? gain_ - gainStep_ : gainTarget_;
    double sum = static_cast<double>(out[i]);
    for (Playing* playing : {&current_, &fading_}) {
      if (playing->take == nullptr) continue;
      if (playing->next < playing->take->count && playing->fade > 0) sum += nextOf(*playing);
      if (playing->next >= playing->take->count || playing->fade <= 0) end(*playing);
    }
    sum = sum > 1 ? 1 : sum < -1 ? -1 : sum;
    out[i] = static_cast<float>(sum);
    const float level = out[i] < 0 ? -out[i] : out[i];
    if (level > peak) peak = level;
  }
  return peak;
}

}  // namespace detent::playback
