// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/fourier.h"

#include <numbers>
#include <utility>

#include "model/check.h"

namespace detent::playback {

namespace {

/// Complex product without the standard operator's handling of infinities, which takes most of a transform's
/// time.
std::complex<double> product(std::complex<double> a, std::complex<double> b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

std::size_t powerOfTwo(std::size_t n) {
  std::size_t size = 1;
  while (size < n) size *= 2;
  return size;
}

Fourier::Fourier(std::size_t length) : length_(length), roots_(length / 2) {
  DETENT_CHECK(length > 0 && (length & (length - 1)) == 0, "length is a power of two");
  const double step = -2 * std::numbers::pi / static_cast<double>(length);
  for (std::size_t k = 0; k < roots_.size(); ++k) roots_[k] = std::polar(1.0, step * static_cast<double>(k));
}

void Fourier::transform(std::vector<std::complex<double>>& data, Transform direction) const {
  DETENT_CHECK(data.size() == length_, "as many values as the transform is long");
  for (std::size_t i = 1, j = 0; i < length_; ++i) {
    std::size_t bit = length_ / 2;
    for (; (j & bit) != 0; bit /= 2) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(data[i], data[j]);
  }
  const bool forward = direction == Transform::forward;
  for (std::size_t span = 2; span <= length_; span *= 2) {
    const std::size_t half = span / 2, stride = length_ / span;
    for (std::size_t start = 0; start < length_; start += span) {
      for (std::size_t k = 0; k < half; ++k) {
        const std::complex<double>& root = roots_[k * stride];
        const std::complex<double> odd = product(data[start + k + half], forward ? root : std::conj(root));
        data[start + k + half] = data[start + k] - odd;
        data[start + k] += odd;
      }
    }
  }
  if (forward) return;
  for (auto& v : data) v /= static_cast<double>(length_);
}

void transform(std::vector<std::complex<double>>& data, Transform direction) {
  Fourier(data.size()).transform(data, direction);
}

}  // namespace detent::playback
