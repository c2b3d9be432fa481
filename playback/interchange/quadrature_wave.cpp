// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/quadrature_wave.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace detent::playback {

namespace {

constexpr std::int64_t pieceFrames = 960;
constexpr std::array<std::int64_t, 9> stepsTried{480, 240, 120, 60, 30, 15, 8, 4, 2};
// half width of the band, because each sample depends on two points with two amplitudes each
constexpr std::size_t half = 3;

/// Symmetric, positive definite, banded system; solved in place by Cholesky.
class BandSystem {
 public:
  explicit BandSystem(std::size_t size) : rows_(size), right_(size, 0) {}

  void add(std::size_t i, std::size_t j, double value) {
    if (j <= i) rows_[i][i - j] += value;
  }
  void addRight(std::size_t i, double value) { right_[i] += value; }

  std::vector<double> solved() {
    const std::size_t n = rows_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t back = std::min(half, i) + 1; back-- > 0;) {
        const std::size_t j = i - back;
        double sum = rows_[i][back];
        for (std::size_t k = i > half ? i - half : 0; k < j; ++k)
          if (j - k <= half) sum -= rows_[i][i - k] * rows_[j][j - k];
        rows_[i][back] = back == 0 ? std::sqrt(sum) : sum / rows_[j][0];
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t back = 1; back <= std::min(half, i); ++back)
        right_[i] -= rows_[i][back] * right_[i - back];
      right_[i] /= rows_[i][0];
    }
    for (std::size_t i = n; i-- > 0;) {
      right_[i] /= rows_[i][0];
      for (std::size_t back = 1; back <= std::min(half, i); ++back)
        right_[i - back] -= rows_[i][back] * right_[i];
    }
    return right_;
  }

 private:
  std::vector<std::array<double, half + 1>> rows_;  // [i][d]: column i - d
  std::vector<double> right_;
};

struct Signal {
  const std::vector<double>& samples;
  double cyclesPerFrame;
  double tolerance;

  double sine(std::int64_t frame) const {
    return std::sin(2 * std::numbers::pi * std::fmod(cyclesPerFrame * static_cast<double>(frame), 1));
  }
  double cosine(std::int64_t frame) const {
    return std::cos(2 * std::numbers::pi * std::fmod(cyclesPerFrame * static_cast<double>(frame), 1));
  }
  double at(std::int64_t frame) const { return samples[static_cast<std::size_t>(frame)]; }
  bool silent(std::int64_t frame) const { return std::fabs(at(frame)) <= tolerance; }
};

struct Grid {
  std::int64_t from, to, step;  // points at from, from + step, ..., and at `to`, the last sample
  std::size_t points() const { return static_cast<std::size_t>((to - from + step - 1) / step) + 1; }
  std::int64_t frame(std::size_t i) const { return std::min(to, from + static_cast<std::int64_t>(i) * step); }
};

QuadraturePiece fitted(const Signal& signal, const Grid& grid) {
  const std::size_t points = grid.points();
  BandSystem system(2 * points);
  // If points are closer than half waves, many pairs of amplitudes give the same samples; the smallest are
  // chosen.
  for (std::size_t i = 0; i < 2 * points; ++i) system.add(i, i, 1e-9);
  for (std::size_t i = 0; i + 1 < points || i == 0; ++i) {
    const std::int64_t low = grid.frame(i), high = grid.frame(std::min(i + 1, points - 1));
    const std::int64_t end = i + 2 >= points ? high + 1 : high;
    for (std::int64_t frame = low; frame < end; ++frame) {
      const double w = high > low ? static_cast<double>(frame - low) / static_cast<double>(high - low) : 0;
      const double s = signal.sine(frame), c = signal.cosine(frame);
      const std::array<double, 4> basis{(1 - w) * s, (1 - w) * c, w * s, w * c};
      const std::size_t used = points > 1 ? 4 : 2;
      for (std::size_t a = 0; a < used; ++a) {
        for (std::size_t b = 0; b <= a; ++b) system.add(2 * i + a, 2 * i + b, basis[a] * basis[b]);
        system.addRight(2 * i + a, basis[a] * signal.at(frame));
      }
    }
  }
  const std::vector<double> amplitudes = system.solved();
  QuadraturePiece piece;
  for (std::size_t i = 0; i < points; ++i)
    piece.push_back({grid.frame(i), amplitudes[2 * i], amplitudes[2 * i + 1]});
  return piece;
}

double worstError(const Signal& signal, const QuadraturePiece& piece) {
  double worst = 0;
  for (std::size_t i = 0; i + 1 < piece.size(); ++i) {
    const QuadraturePoint& a = piece[i];
    const QuadraturePoint& b = piece[i + 1];
    for (std::int64_t frame = a.frame; frame <= b.frame; ++frame) {
      const double w = static_cast<double>(frame - a.frame) / static_cast<double>(b.frame - a.frame);
      const double value = (a.sine + w * (b.sine - a.sine)) * signal.sine(frame) +
                           (a.cosine + w * (b.cosine - a.cosine)) * signal.cosine(frame);
      worst = std::fmax(worst, std::fabs(value - signal.at(frame)));
    }
  }
  return worst;
}

/// One point per sample: exact, by projection onto the two sines.
QuadraturePiece sampleBySample(const Signal& signal, const Grid& grid) {
  QuadraturePiece piece;
  for (std::int64_t frame = grid.from; frame <= grid.to; ++frame)
    piece.push_back({frame, signal.at(frame) * signal.sine(frame), signal.at(frame) * signal.cosine(frame)});
  return piece;
}

QuadraturePiece pieceWithin(const Signal& signal, std::int64_t from, std::int64_t to) {
  for (const std::int64_t step : stepsTried) {
    if (step >= to - from && step > stepsTried.back()) continue;
    QuadraturePiece piece = fitted(signal, {from, to, step});
    if (worstError(signal, piece) <= signal.tolerance) return piece;
  }
  return sampleBySample(signal, {from, to, 1});
}

}  // namespace

std::vector<QuadraturePiece> quadraturePieces(const std::vector<double>& samples, double sampleRate_Hz,
                                              double frequency_Hz, double tolerance) {
  const Signal signal{samples, frequency_Hz / sampleRate_Hz, tolerance};
  const auto count = static_cast<std::int64_t>(samples.size());
  std::vector<QuadraturePiece> pieces;
  for (std::int64_t from = 0; from < count;) {
    if (signal.silent(from)) {
      ++from;
      continue;
    }
    std::int64_t to = from;  // the last audible sample within reach
    for (std::int64_t frame = from; frame < std::min(count, from + pieceFrames); ++frame)
      if (!signal.silent(frame)) to = frame;
    pieces.push_back(pieceWithin(signal, from, to));
    from = to + 1;
  }
  return pieces;
}

}  // namespace detent::playback
