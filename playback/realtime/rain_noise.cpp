// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/rain_noise.h"

#include <cmath>
#include <numbers>

namespace detent::playback {

namespace {

constexpr double fade_s = 1;
constexpr double rumble_Hz = 60;
constexpr double twoPi = 2 * std::numbers::pi;

// Three low-pass filtered noises and a little unfiltered noise add up to a spectrum that falls by about 3 dB
// per octave from 60 Hz to 10 kHz.
constexpr std::array<double, 3> corners_Hz{16, 265, 3950};
constexpr std::array<double, 3> shares{42, 8.0, 2.45};
constexpr double unfiltered = 0.18;

// Drops on leaves and stone, one to four octaves above the middle of the noise.
constexpr double drops_Hz = 150;
constexpr double lowest_Hz = 500, octaves = 3, shortest_s = 0.003, longest_s = 0.012;
constexpr double loudestDrop = 9;  // compared with a noise of about 4

}  // namespace

RainNoise::RainNoise(double level) : level_(level > 0 ? level : 0) { setSampleRate(rate_Hz_); }

void RainNoise::setSampleRate(double sampleRate_Hz) {
  rate_Hz_ = sampleRate_Hz;
  random_ = 0x9E3779B97F4A7C15ULL;
  rush_ = {};
  drops_ = {};
  untilDrop_ = 0;
  for (std::size_t i = 0; i < corners_Hz.size(); ++i) {
    keep_[i] = std::exp(-twoPi * corners_Hz[i] / rate_Hz_);
    take_[i] = shares[i] * (1 - keep_[i]);
  }
  rumble_.setCoefficients(highPass(rate_Hz_, rumble_Hz));
  rumble_.reset();
  if (!audible()) return;
  scale_ = level_ / rmsOf(2);
  fade_ = 0;
  fadeStep_ = 1 / (fade_s * rate_Hz_);
}

/// Level (rms) of the rain before it is scaled.
double RainNoise::rmsOf(double seconds) {
  const auto count = static_cast<std::size_t>(seconds * rate_Hz_);
  double squares = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = next();
    squares += x * x;
  }
  return std::sqrt(squares / static_cast<double>(count));
}

/// Uniform within [0, 1): xorshift64*.
double RainNoise::chance() {
  random_ ^= random_ >> 12;
  random_ ^= random_ << 25;
  random_ ^= random_ >> 27;
  return static_cast<double>((random_ * 0x2545F4914F6CDD1DULL) >> 11) * 0x1p-53;
}

void RainNoise::letFall() {
  Drop& drop = drops_[nextDrop_];
  nextDrop_ = (nextDrop_ + 1) % drops_.size();
  const double frequency_Hz = lowest_Hz * std::exp2(octaves * chance());
  const double decay_s = shortest_s + (longest_s - shortest_s) * chance();
  const double kept = std::exp(-1 / (decay_s * rate_Hz_)), turn = twoPi * frequency_Hz / rate_Hz_;
  const double share = chance();
  drop = {loudestDrop * share * share, 0, kept * std::cos(turn), kept * std::sin(turn)};
  untilDrop_ += -std::log(1 - chance()) / drops_Hz * rate_Hz_;
}

double RainNoise::next() {
  const double white = 2 * chance() - 1;
  double sum = unfiltered * white;
  for (std::size_t i = 0; i < rush_.size(); ++i) {
    rush_[i] = keep_[i] * rush_[i] + take_[i] * white;
    sum += rush_[i];
  }
  for (untilDrop_ -= 1; untilDrop_ <= 0;) letFall();
  for (Drop& d : drops_) {
    const double re = d.re * d.turnRe - d.im * d.turnIm;
    d.im = d.re * d.turnIm + d.im * d.turnRe;
    d.re = re;
    sum += d.im;
  }
  rumble_.process(&sum, 1);
  return sum;
}

void RainNoise::render(float* out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const double x = fade_ * scale_ * next();
    fade_ = fade_ < 1 ? fade_ + fadeStep_ : 1;
    out[i] = static_cast<float>(x < -1 ? -1 : x > 1 ? 1 : x);
  }
}

}  // namespace detent::playback
