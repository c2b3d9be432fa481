// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Discrete Fourier transform of a power-of-two length.

#include <complex>
#include <vector>

namespace detent::playback {

enum class Transform { forward, inverse };

/// Transforms of one length, for repeated use: the roots of unity are computed once. Any thread.
class Fourier {
 public:
  explicit Fourier(std::size_t length);  ///< a power of two
  std::size_t length() const { return length_; }

  /// In place; the inverse divides by the length. data.size() == length().
  void transform(std::vector<std::complex<double>>& data, Transform direction) const;

 private:
  std::size_t length_;
  std::vector<std::complex<double>> roots_;  // exp(-2 pi i k / length), k below half the length
};

/// One transform. data.size() is a power of two.
void transform(std::vector<std::complex<double>>& data, Transform direction);

/// Smallest power of two >= n.
std::size_t powerOfTwo(std::size_t n);

}  // namespace detent::playback
