#pragma once
// Discrete Fourier transform of a power-of-two length.

#include <complex>
#include <vector>

namespace detent::playback {

enum class Transform { forward, inverse };

/// In place; the inverse divides by the length. data.size() is a power of two.
void transform(std::vector<std::complex<double>>& data, Transform direction);

/// Smallest power of two >= n.
std::size_t powerOfTwo(std::size_t n);

}  // namespace detent::playback
