// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/biquad.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace detent::playback {

namespace {
bool outOfBand(double sampleRate_Hz, double frequency_Hz) {
  return !(frequency_Hz > 0) || frequency_Hz >= 0.45 * sampleRate_Hz;
}
}  // namespace

BiquadCoefficients lowPass(double sampleRate_Hz, double cutoff_Hz, unsigned order) {
  BiquadCoefficients c;
  if (outOfBand(sampleRate_Hz, cutoff_Hz)) return c;
  const double k = std::tan(std::numbers::pi * cutoff_Hz / sampleRate_Hz);
  if (order < 2) {
    c.b0 = c.b1 = k / (1 + k);
    c.a1 = (k - 1) / (k + 1);
    return c;
  }
  const double norm = 1 / (1 + std::numbers::sqrt2 * k + k * k);
  c.b0 = c.b2 = k * k * norm;
  c.b1 = 2 * c.b0;
  c.a1 = 2 * (k * k - 1) * norm;
  c.a2 = (1 - std::numbers::sqrt2 * k + k * k) * norm;
  return c;
}

BiquadCoefficients highPass(double sampleRate_Hz, double cutoff_Hz) {
  BiquadCoefficients c;
  if (outOfBand(sampleRate_Hz, cutoff_Hz)) return c;
  const double k = std::tan(std::numbers::pi * cutoff_Hz / sampleRate_Hz);
  c.b0 = 1 / (1 + k);
  c.b1 = -c.b0;
  c.a1 = (k - 1) / (k + 1);
  return c;
}

BiquadCoefficients peaking(double sampleRate_Hz, double frequency_Hz, double q, double gain_dB) {
  BiquadCoefficients c;
  if (outOfBand(sampleRate_Hz, frequency_Hz) || !(q > 0)) return c;
  const double a = std::pow(10.0, gain_dB / 40);
  const double w = 2 * std::numbers::pi * frequency_Hz / sampleRate_Hz;
  const double alpha = std::sin(w) / (2 * q);
  const double a0 = 1 + alpha / a;
  c.b0 = (1 + alpha * a) / a0;
  c.b1 = -2 * std::cos(w) / a0;
  c.b2 = (1 - alpha * a) / a0;
  c.a1 = c.b1;
  c.a2 = (1 - alpha / a) / a0;
  return c;
}

BiquadCoefficients bandPass(double sampleRate_Hz, double centre_Hz, double q) {
  if (outOfBand(sampleRate_Hz, centre_Hz)) return {};
  const double w = 2 * std::numbers::pi * centre_Hz / sampleRate_Hz, alpha = std::sin(w) / (2 * q);
  const double a0 = 1 + alpha;
  return {alpha / a0, 0, -alpha / a0, -2 * std::cos(w) / a0, (1 - alpha) / a0};
}

double magnitude(const BiquadCoefficients& c, double sampleRate_Hz, double frequency_Hz) {
  const std::complex<double> z1 = std::polar(1.0, -2 * std::numbers::pi * frequency_Hz / sampleRate_Hz);
  return std::abs((c.b0 + z1 * (c.b1 + z1 * c.b2)) / (1.0 + z1 * (c.a1 + z1 * c.a2)));
}

}  // namespace detent::playback
