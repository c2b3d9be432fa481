// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Mathematical functions that use only additions, products, quotients and square roots, which IEEE 754 rounds
// equally on every machine. A forecast is therefore equal to the last bit whatever the compiler and its
// library. Any thread.

#include <cstdint>
#include <vector>

namespace detent::playback {

/// e^x; x in [-700, 700], to 1e-14 of its value.
double exponential(double x);

/// sin(x), x in [0, pi/2], and cos(x), to 1e-15.
struct SineCosine {
  double sine = 0, cosine = 1;
};
SineCosine sineAndCosine(double x);

/// erf(x), any x, to 1e-14.
double errorFunction(double x);

/// P(Z <= z) of a standard normal Z.
double normalShare(double z);

/// The z with normalShare(z) == share; share in (0, 1) (checked), within ±8.
double normalScore(double share);

/// `count` scores that divide the normal distribution into equal shares, ascending.
std::vector<double> normalScores(int count);

/// Pseudo-random numbers from a seed (splitmix64, Steele, Lea & Flood 2014): the same sequence on every
/// machine and in every version.
class FixedRandom {
 public:
  explicit FixedRandom(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// Uniform in [0, 1).
  double share();
  /// Standard normal, by the inverse of its distribution.
  double normal();

 private:
  std::uint64_t state_;
};

}  // namespace detent::playback
