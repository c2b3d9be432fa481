// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/quadrature_wave.h"

#include <cmath>
#include <numbers>
#include <random>

#include <catch2/catch.hpp>

using namespace detent::playback;

namespace {

constexpr double rate_Hz = 48000, carrier_Hz = 150;

double played(const std::vector<QuadraturePiece>& pieces, std::int64_t frame) {
  const double angle = 2 * std::numbers::pi * carrier_Hz * static_cast<double>(frame) / rate_Hz;
  for (const QuadraturePiece& piece : pieces) {
    if (frame < piece.front().frame || frame > piece.back().frame) continue;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (piece[i].frame == frame) return piece[i].sine * std::sin(angle) + piece[i].cosine * std::cos(angle);
      if (i + 1 == piece.size() || piece[i + 1].frame < frame) continue;
      const double w = static_cast<double>(frame - piece[i].frame) /
                       static_cast<double>(piece[i + 1].frame - piece[i].frame);
      return (piece[i].sine + w * (piece[i + 1].sine - piece[i].sine)) * std::sin(angle) +
             (piece[i].cosine + w * (piece[i + 1].cosine - piece[i].cosine)) * std::cos(angle);
    }
  }
  return 0;
}

double worst(const std::vector<double>& samples, double tolerance) {
  const auto pieces = quadraturePieces(samples, rate_Hz, carrier_Hz, tolerance);
  double worst = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    worst = std::fmax(worst, std::fabs(samples[i] - played(pieces, static_cast<std::int64_t>(i))));
  return worst;
}

}  // namespace

TEST_CASE("Any samples are carried within the tolerance") {
  constexpr double tolerance = 3e-4;
  std::mt19937 chance(7);
  std::vector<double> tone, noise, clicks(5000, 0), single(100, 0);
  for (int i = 0; i < 5000; ++i) {
    const double t = i / rate_Hz;
    tone.push_back(0.7 * std::exp(-30 * t) * std::sin(2 * std::numbers::pi * 390 * t));
    noise.push_back(std::uniform_real_distribution<double>(-1, 1)(chance));
  }
  for (std::size_t i = 100; i < clicks.size(); i += 700) clicks[i] = 1;
  single[50] = -0.4;
  CHECK(worst(tone, tolerance) <= tolerance * 1.0001);
  CHECK(worst(noise, tolerance) <= tolerance * 1.0001);
  CHECK(worst(clicks, tolerance) <= tolerance * 1.0001);
  CHECK(worst(single, tolerance) <= tolerance * 1.0001);
}

TEST_CASE("A decaying tone of the carrier's frequency needs few points, silence none") {
  std::vector<double> tone;
  for (int i = 0; i < 4800; ++i)
    tone.push_back((1 - i / 4800.0) * std::sin(2 * std::numbers::pi * carrier_Hz * i / rate_Hz + 1));
  std::size_t points = 0;
  for (const QuadraturePiece& piece : quadraturePieces(tone, rate_Hz, carrier_Hz, 3e-4))
    points += piece.size();
  CHECK(points <= 20);
  CHECK(quadraturePieces(std::vector<double>(4800, 0), rate_Hz, carrier_Hz, 3e-4).empty());
}
