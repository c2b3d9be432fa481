// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/study/perception/baselines.h"

#include <algorithm>
#include <cmath>

#include "playback/measurement/fourier.h"
#include "playback/measurement/normal.h"

namespace detent::playback {

namespace {

constexpr std::size_t block = 512;
constexpr double tiny = 1e-12;

/// MPEG's reference model in the form of vibromaf: dB of a just felt sine.
double threshold_dB(double frequency_Hz) {
  constexpr double a = 62, e = 77, reference_Hz = 550, beta = 1 - 250.0 / 550.0;
  const double bend = std::log10(frequency_Hz / reference_Hz + beta) / std::log10(beta);
  return std::fabs(a * bend * bend) - e;
}

std::vector<double> magnitudes(const std::vector<double>& samples) {
  std::vector<std::complex<double>> data(samples.begin(), samples.end());
  data.resize(powerOfTwo(std::max<std::size_t>(samples.size(), 2)));
  transform(data, Transform::forward);
  std::vector<double> result;
  for (std::size_t i = 0; i < data.size() / 2; ++i) result.push_back(std::abs(data[i]));
  return result;
}

/// Number of blocks when both signals are padded to one length.
std::size_t blocksOf(const std::vector<float>& a, const std::vector<float>& b) {
  return (std::max(a.size(), b.size()) + block - 1) / block;
}

std::vector<double> blockOf(const std::vector<float>& samples, std::size_t index) {
  std::vector<double> part(block, 0.0);
  for (std::size_t i = 0; i < block && index * block + i < samples.size(); ++i)
    part[i] = static_cast<double>(samples[index * block + i]);
  return part;
}

/// Support of each bin, 0..1.
std::vector<double> supportOf(const std::vector<double>& samples) {
  constexpr double softness_dB = 12;
  const std::vector<double> spectrum = magnitudes(samples);
  std::vector<double> support;
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const double frequency_Hz =
        perceptionRate_Hz * static_cast<double>(i) / (2 * static_cast<double>(spectrum.size()));
    const double level_dB = 20 * std::log10(2 * spectrum[i] / static_cast<double>(block) + tiny);
    support.push_back(normalCdf((level_dB - threshold_dB(frequency_Hz)) / softness_dB));
  }
  return support;
}

/// Least squares share of one in the other; 1 for equal, 0 for nothing in common.
double agreement(const std::vector<double>& r, const std::vector<double>& d) {
  double rd = 0, rr = 0, dd = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    rd += r[i] * d[i];
    rr += r[i] * r[i];
    dd += d[i] * d[i];
  }
  const double larger = std::max(rr, dd);
  return larger > tiny ? std::clamp(rd / larger, 0.0, 1.0) : 1;
}

void standardise(std::vector<double>& x) {
  double mean = 0, square = 0;
  for (const double v : x) mean += v / static_cast<double>(x.size());
  for (const double v : x) square += (v - mean) * (v - mean) / static_cast<double>(x.size());
  const double scale = square > tiny ? 1 / std::sqrt(square) : 0;
  for (double& v : x) v = (v - mean) * scale;
}

/// Power above threshold, by bin.
std::vector<double> perceptualSpectrum(const std::vector<float>& samples, std::size_t length) {
  std::vector<double> padded(samples.begin(), samples.end());
  padded.resize(length);
  std::vector<double> spectrum = magnitudes(padded);
  for (std::size_t i = 0; i < spectrum.size(); ++i) {
    const double frequency_Hz =
        perceptionRate_Hz * static_cast<double>(i) / (2 * static_cast<double>(spectrum.size()));
    spectrum[i] = spectrum[i] * spectrum[i] * std::pow(10, -threshold_dB(frequency_Hz) / 10);
  }
  return spectrum;
}

}  // namespace

double stSimDistance(const std::vector<float>& a, const std::vector<float>& b) {
  const std::size_t blocks = blocksOf(a, b);
  double spectral = 0, temporal = 0;
  for (std::size_t i = 0; i < blocks; ++i) {
    std::vector<double> x = blockOf(a, i), y = blockOf(b, i);
    spectral += agreement(supportOf(x), supportOf(y));
    standardise(x);
    standardise(y);
    temporal += agreement(x, y);
  }
  if (blocks == 0) return 0;
  const auto n = static_cast<double>(blocks);
  return 1 - std::pow(temporal / n, 2.0 / 3) * std::pow(spectral / n, 1.0 / 3);
}

double spqiDistance(const std::vector<float>& a, const std::vector<float>& b) {
  const std::size_t length = std::max(a.size(), b.size());
  const std::vector<double> r = perceptualSpectrum(a, length), d = perceptualSpectrum(b, length);
  double difference = 0, sum = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    difference += std::fabs(r[i] - d[i]);
    sum += 0.5 * (r[i] + d[i]);  // symmetric: neither is the reference
  }
  if (sum <= tiny || difference <= 0) return 0;
  const double distortion_dB = 10 * std::log10(difference / sum);
  return 1 - (1 - std::tanh(0.3 * distortion_dB + 2)) / 2;
}

double spectralDistance_dB(const std::vector<float>& a, const std::vector<float>& b) {
  constexpr double floor = 1e-3;  // 60 dB below the peak
  const std::size_t length = std::max(a.size(), b.size());
  std::vector<double> x(a.begin(), a.end()), y(b.begin(), b.end());
  x.resize(length);
  y.resize(length);
  const std::vector<double> p = magnitudes(x), q = magnitudes(y);
  double peak = tiny;
  for (std::size_t i = 0; i < p.size(); ++i) peak = std::max({peak, p[i], q[i]});
  double square = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double d = 20 * std::log10(std::max(p[i], floor * peak) / std::max(q[i], floor * peak));
    square += d * d;
  }
  return p.empty() ? 0 : std::sqrt(square / static_cast<double>(p.size()));
}

double distanceBetween(const FeltButton& a, const FeltButton& b, VibrationDistance distance) {
  const std::size_t states = std::max(a.states.size(), b.states.size());
  double sum = 0;
  for (std::size_t s = 0; s < states; ++s) {
    for (std::size_t i = 0; i < pressLengths_s.size(); ++i) {
      const FeltPress& x = a.states[s % a.states.size()][i];
      const FeltPress& y = b.states[s % b.states.size()][i];
      sum += distance(x.press.samples, y.press.samples) + distance(x.release.samples, y.release.samples);
    }
  }
  return sum / static_cast<double>(2 * pressLengths_s.size() * states);
}

}  // namespace detent::playback
