#include "playback/study/fourier.h"

#include <numbers>
#include <utility>

#include "model/check.h"

namespace detent::playback {

std::size_t powerOfTwo(std::size_t n) {
  std::size_t size = 1;
  while (size < n) size *= 2;
  return size;
}

void transform(std::vector<std::complex<double>>& data, Transform direction) {
  const std::size_t n = data.size();
  DETENT_CHECK(n > 0 && (n & (n - 1)) == 0, "length is a power of two");
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n / 2;
    for (; (j & bit) != 0; bit /= 2) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(data[i], data[j]);
  }
  const double sign = direction == Transform::forward ? -1 : 1;
  std::vector<std::complex<double>> roots(n / 2);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    roots[k] = std::polar(1.0, sign * 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n));
  }
  for (std::size_t length = 2; length <= n; length *= 2) {
    const std::size_t half = length / 2, stride = n / length;
    for (std::size_t start = 0; start < n; start += length) {
      for (std::size_t k = 0; k < half; ++k) {
        const std::complex<double> odd = data[start + k + half] * roots[k * stride];
        data[start + k + half] = data[start + k] - odd;
        data[start + k] += odd;
      }
    }
  }
  if (direction == Transform::forward) return;
  for (auto& v : data) v /= static_cast<double>(n);
}

}  // namespace detent::playback
