// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Second-order filter sections of the engine: slope low-pass and device equalizer. Double precision,
// transposed direct form II (which is numerically stable for 150 Hz at 192 kHz).

#include <cstddef>

namespace detent::playback {

/// y = b0 x + b1 x' + b2 x'' - a1 y' - a2 y''; identity by default.
struct BiquadCoefficients {
  double b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
};

/// Butterworth low-pass of order 1 or 2, -3 dB at the cutoff (bilinear, pre-warped). A cutoff at or above
/// 0.45 of the sample rate gives the identity.
BiquadCoefficients lowPass(double sampleRate_Hz, double cutoff_Hz, unsigned order);

/// First-order high-pass, -3 dB at the cutoff, which blocks constant signals (Pd's hip~). A cutoff of 0, or
/// out of band, gives the identity.
BiquadCoefficients highPass(double sampleRate_Hz, double cutoff_Hz);

/// Peaking section after R. Bristow-Johnson's audio EQ cookbook. A frequency at or above 0.45 of the sample
/// rate gives the identity: the device's resonance lies outside what this rate can play.
BiquadCoefficients peaking(double sampleRate_Hz, double frequency_Hz, double q, double gain_dB);

/// Band-pass of gain 1 at its centre, from the same cookbook. A centre at or above 0.45 of the sample rate
/// gives the identity.
BiquadCoefficients bandPass(double sampleRate_Hz, double centre_Hz, double q);

/// |H| at a frequency; for plots and tests, not for the callback.
double magnitude(const BiquadCoefficients& c, double sampleRate_Hz, double frequency_Hz);

/// One running section. After silence its state becomes exactly zero, so that an idle engine can be
/// recognised and no denormal numbers slow down the callback.
class Biquad {
 public:
  void setCoefficients(const BiquadCoefficients& c) { c_ = c; }
  const BiquadCoefficients& coefficients() const { return c_; }
  void reset() { s1_ = s2_ = 0; }
  bool silent() const { return s1_ == 0 && s2_ == 0; }

  void process(double* samples, std::size_t count) {
    double s1 = s1_, s2 = s2_;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = samples[i];
      const double y = c_.b0 * x + s1;
      s1 = c_.b1 * x - c_.a1 * y + s2;
      s2 = c_.b2 * x - c_.a2 * y;
      if (x == 0 && s1 < inaudible && s1 > -inaudible && s2 < inaudible && s2 > -inaudible) s1 = s2 = 0;
      samples[i] = y;
    }
    s1_ = s1;
    s2_ = s2;
  }

 private:
  static constexpr double inaudible = 1e-9;  // -180 dB: 36 dB below the last bit of 24
  BiquadCoefficients c_;
  double s1_ = 0, s2_ = 0;
};

}  // namespace detent::playback
