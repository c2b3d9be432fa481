// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Any samples as two sines of one frequency a quarter turn apart whose amplitudes run straight between
// points: how a format of vectorial waves carries filtered grains without loss.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace detent::playback {

/// Amplitudes at one sample.
struct QuadraturePoint {
  std::int64_t frame = 0;
  double sine = 0, cosine = 0;
};

/// One piece; linear between its points, the last point's sample included.
using QuadraturePiece = std::vector<QuadraturePoint>;

/// Pieces whose sum sine(t) sin(2 pi f t) + cosine(t) cos(2 pi f t) differs from `samples` by at most
/// `tolerance` at every sample (t counted from sample 0), with as few points as steps of one length per piece
/// allow (least squares). Where the samples stay within the tolerance of silence there is no piece.
std::vector<QuadraturePiece> quadraturePieces(const std::vector<double>& samples, double sampleRate_Hz,
                                              double frequency_Hz, double tolerance);

}  // namespace detent::playback
