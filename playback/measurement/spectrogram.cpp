// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/spectrogram.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "model/check.h"
#include "playback/measurement/fourier.h"

namespace detent::playback {

namespace {

constexpr double stopBand_dB = 80;
constexpr double ratePerBand = 2.6;  // the reduced rate relative to highest_Hz: 2, plus room for the filter
constexpr std::size_t padding = 3;   // bins per window width: enough for smooth interpolation on a display
// shape of a Kaiser window with a stop band of more than 50 dB
constexpr double kaiserBeta = 0.1102 * (stopBand_dB - 8.7);

double besselI0(double x) {
  double sum = 1, term = 1;
  for (int k = 1; term > 1e-12 * sum; ++k) {
    term *= (x / (2 * k)) * (x / (2 * k));
    sum += term;
  }
  return sum;
}

/// Low-pass that passes up to `pass_Hz` and blocks what would alias at a rate of `reduced_Hz`.
std::vector<double> antiAlias(double pass_Hz, double reduced_Hz, double sampleRate_Hz) {
  const double transition = 2 * std::numbers::pi * (reduced_Hz - 2 * pass_Hz) / sampleRate_Hz;
  const auto half = static_cast<std::ptrdiff_t>(std::ceil((stopBand_dB - 8) / (2.285 * transition) / 2));
  const double cutoff = reduced_Hz / 2 / sampleRate_Hz;  // the middle of the transition band
  std::vector<double> taps;
  double sum = 0;
  for (std::ptrdiff_t i = -half; i <= half; ++i) {
    const double t = static_cast<double>(i);
    const double share = half > 0 ? t / static_cast<double>(half) : 0;
    const double sinc =
        i == 0 ? 2 * cutoff : std::sin(2 * std::numbers::pi * cutoff * t) / (std::numbers::pi * t);
    taps.push_back(sinc * besselI0(kaiserBeta * std::sqrt(1 - share * share)));
    sum += taps.back();
  }
  for (double& tap : taps) tap /= sum;
  return taps;
}

/// Every `factor`-th sample of the filtered signal; sample 0 stays at time 0.
std::vector<double> reduced(const std::vector<float>& samples, std::size_t factor, double pass_Hz,
                            double sampleRate_Hz) {
  if (factor < 2) return {samples.begin(), samples.end()};
  const std::vector<double> taps =
      antiAlias(pass_Hz, sampleRate_Hz / static_cast<double>(factor), sampleRate_Hz);
  const auto half = static_cast<std::ptrdiff_t>(taps.size() / 2);
  const auto count = static_cast<std::ptrdiff_t>(samples.size());
  std::vector<double> out;
  out.reserve(samples.size() / factor + 1);
  for (std::ptrdiff_t centre = 0; centre < count; centre += static_cast<std::ptrdiff_t>(factor)) {
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, centre - half);
    const std::ptrdiff_t to = std::min(count - 1, centre + half);
    double sum = 0;
    for (std::ptrdiff_t i = from; i <= to; ++i)
      sum += taps[static_cast<std::size_t>(i - centre + half)] *
             static_cast<double>(samples[static_cast<std::size_t>(i)]);
    out.push_back(sum);
  }
  return out;
}

std::vector<double> hannWindow(std::size_t length) {
  std::vector<double> window(length);
  for (std::size_t i = 0; i < length; ++i) {
    const double phase = (static_cast<double>(i) + 0.5) / static_cast<double>(length);
    window[i] = 0.5 * (1 - std::cos(2 * std::numbers::pi * phase));
  }
  return window;
}

float decibels(double power) {
  return power > 1e-12 ? static_cast<float>(10 * std::log10(power)) : lowestLevel_dB;
}

}  // namespace

Spectrogram spectrogramOf(const std::vector<float>& samples, double sampleRate_Hz,
                          const SpectrogramSettings& settings) {
  DETENT_CHECK(settings.window_s > 0.001 && settings.window_s <= 1, "window_s in (0.001, 1]");
  DETENT_CHECK(settings.hop_s > 0 && settings.hop_s <= settings.window_s, "hop_s in (0, window_s]");
  DETENT_CHECK(settings.highest_Hz > 0 && settings.highest_Hz <= 0.45 * sampleRate_Hz,
               "highest_Hz in (0, 0.45 of the sample rate]");
  const auto factor = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::floor(sampleRate_Hz / (ratePerBand * settings.highest_Hz))));
  const double rate_Hz = sampleRate_Hz / static_cast<double>(factor);
  const std::vector<double> signal = reduced(samples, factor, settings.highest_Hz, sampleRate_Hz);

  const auto length =
      std::max<std::size_t>(8, static_cast<std::size_t>(std::lround(settings.window_s * rate_Hz)));
  const auto hop = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(settings.hop_s * rate_Hz)));
  const std::vector<double> window = hannWindow(length);
  double gain = 0;
  for (const double w : window) gain += w / 2;

  Spectrogram result;
  const std::size_t size = powerOfTwo(padding * length);
  result.hop_s = static_cast<double>(hop) / rate_Hz;
  result.row_Hz = rate_Hz / static_cast<double>(size);
  result.rows = static_cast<std::size_t>(std::floor(settings.highest_Hz / result.row_Hz)) + 1;
  result.columns = signal.empty() ? 0 : (signal.size() - 1) / hop + 1;
  result.level_dB.resize(result.columns * result.rows);
  // Value `i` of the window centred at sample `centre`; silence outside the signal.
  const auto windowed = [&](std::size_t centre, std::size_t i) {
    const std::size_t at = centre + i;  // shifted by half a window
    if (i >= length || at < length / 2 || at - length / 2 >= signal.size()) return 0.0;
    return window[i] * signal[at - length / 2];
  };
  // Two columns are computed by one transform, as its real and imaginary part; the symmetry of real signals'
  // spectra separates them.
  const Fourier fourier(size);
  const double perFullScale = 1 / (4 * gain * gain);
  std::vector<std::complex<double>> bins(size);
  for (std::size_t column = 0; column < result.columns; column += 2) {
    for (std::size_t i = 0; i < size; ++i)
      bins[i] = {windowed(column * hop, i), windowed((column + 1) * hop, i)};
    fourier.transform(bins, Transform::forward);
    const bool second = column + 1 < result.columns;
    float* first = result.level_dB.data() + column * result.rows;
    for (std::size_t row = 0; row < result.rows; ++row) {
      const std::complex<double> z = bins[row], mirrored = std::conj(bins[(size - row) % size]);
      first[row] = decibels(std::norm(z + mirrored) * perFullScale);
      if (second) first[row + result.rows] = decibels(std::norm(z - mirrored) * perFullScale);
    }
  }
  return result;
}

}  // namespace detent::playback
