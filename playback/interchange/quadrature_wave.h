// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Represents any samples as two sines of one frequency, a quarter turn apart, with amplitudes that are linear
// between points. Formats of vectorial waves can thus carry filtered grains without loss.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace detent::playback {

/// Amplitudes at one sample.
struct QuadraturePoint {
  std::int64_t frame = 0;
  double sine = 0, cosine = 0;
};

/// One piece; linear between its points, including the sample of the last point.
using QuadraturePiece = std::vector<QuadraturePoint>;

/// Pieces whose sum sine(t) sin(2 pi f t) + cosine(t) cos(2 pi f t) differs from `samples` by at most
/// `tolerance` at every sample (t counted from sample 0), with as few points as equal steps within each piece
/// allow (least squares). Where the samples are within the tolerance of silence, there is no piece.
std::vector<QuadraturePiece> quadraturePieces(const std::vector<double>& samples, double sampleRate_Hz,
                                              double frequency_Hz, double tolerance);

}  // namespace detent::playback
