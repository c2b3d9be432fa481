// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "playback/measurement/exact_number.h"
#include "playback/measurement/fourier.h"
#include "playback/prepare/felt_level.h"
#include "playback/realtime/biquad.h"

namespace detent::playback {

namespace {

constexpr double fade_s = 0.02;
constexpr double responseLength_s = 0.8;  // length of the impulse response that is kept: 1.25 Hz resolution
constexpr double wholeShare = 0.5;        // share of the impulse response before it fades out
constexpr double beforePeak_s = 0.01;
constexpr double stepsPerOctave = 24;
constexpr double regularisation = 1e-6;  // share of the sweep's strongest bin
constexpr double faintest_dB = 20;  // least height of the response's peak over the rest of the deconvolution

// For finding lost sound (dropoutsIn). A block of 256 samples is 5 ms; a deviation of half the expected level
// exceeds distortion.
constexpr double step_s = 0.005, around_s = 0.05;
constexpr double lostShare = 0.5, overOrdinary = 6;

using Spectrum = std::vector<std::complex<double>>;

Spectrum spectrumOf(const std::vector<float>& samples, std::size_t size) {
  Spectrum s(size);
  for (std::size_t i = 0; i < samples.size(); ++i) s[i] = static_cast<double>(samples[i]);
  transform(s, Transform::forward);
  return s;
}

/// Height of a peak above the higher of its two valleys.
double prominenceOf(const std::vector<double>& gain, std::size_t peak) {
  const auto valley = [&](int step) {
    double lowest = gain[peak];
    for (auto i = static_cast<std::ptrdiff_t>(peak); i >= 0 && i < static_cast<std::ptrdiff_t>(gain.size());
         i += step) {
      const double g = gain[static_cast<std::size_t>(i)];
      if (g > gain[peak]) break;
      lowest = std::min(lowest, g);
    }
    return lowest;
  };
  return gain[peak] - std::max(valley(-1), valley(1));
}

/// Width of a peak `depth_dB` below its top, relative to its frequency.
double widthOf(const FrequencyResponse& r, std::size_t peak, double depth_dB) {
  const double bar = r.gain_dB[peak] - depth_dB;
  const auto crossing = [&](int step) {
    auto i = static_cast<std::ptrdiff_t>(peak);
    const auto last = static_cast<std::ptrdiff_t>(r.gain_dB.size()) - 1;
    while (i + step >= 0 && i + step <= last && r.gain_dB[static_cast<std::size_t>(i + step)] > bar)
      i += step;
    const auto a = static_cast<std::size_t>(i);
    if (i + step < 0 || i + step > last) return r.frequency_Hz[a];
    const auto b = static_cast<std::size_t>(i + step);
    const double share = (r.gain_dB[a] - bar) / (r.gain_dB[a] - r.gain_dB[b]);
    return r.frequency_Hz[a] * std::pow(r.frequency_Hz[b] / r.frequency_Hz[a], share);
  };
  return (crossing(1) - crossing(-1)) / r.frequency_Hz[peak];
}

/// Q of the peaking section (biquad.h) with this peak's height and, `depth_dB` below its top, this width. At
/// half the height, Q is the inverse of the width; nearer to the top, a section of 14 dB is less than half as
/// wide as a plain resonance with the same Q.
double qualityOf(double width, double height_dB, double depth_dB) {
  const double height = std::pow(10, height_dB / 20),
               share = std::pow(10, -depth_dB / 10);  // amplitude; power
  const double q = std::sqrt(height * (1 - share) / (height * height * share - 1)) / width;
  return width > 0 ? std::clamp(q, 0.3, 100.0) : 100;
}

/// Window over the impulse response. Within a band of 1 kHz it keeps the part before time 0 and the first
/// oscillations unchanged.
double windowAt(std::size_t i, std::size_t length, std::size_t before) {
  const auto faded = [](double share) {
    return 0.5 * (1 - std::cos(std::numbers::pi * std::clamp(share, 0.0, 1.0)));
  };
  const double along = static_cast<double>(i), in = 0.5 * static_cast<double>(before);
  return std::min(faded(along / in), faded((1 - along / static_cast<double>(length)) / (1 - wholeShare)));
}

/// Finds the peaks and their shapes, each separately.
void findResonances(FrequencyResponse& r, const SweepSettings& settings) {
  std::vector<double> sorted = r.gain_dB;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<long>(sorted.size() / 2), sorted.end());
  const double median = sorted[sorted.size() / 2];
  for (std::size_t i = 1; i + 1 < r.gain_dB.size(); ++i) {
    if (!(r.gain_dB[i] > r.gain_dB[i - 1] && r.gain_dB[i] >= r.gain_dB[i + 1])) continue;
    const double prominence_dB = prominenceOf(r.gain_dB, i);
    if (prominence_dB < settings.resonanceProminence_dB) continue;
    // Top of the parabola through the three highest points, over log frequency.
    const double a = r.gain_dB[i - 1], b = r.gain_dB[i], c = r.gain_dB[i + 1];
    const double shift = std::clamp(0.5 * (a - c) / (a - 2 * b + c), -0.5, 0.5);
    Resonance found;
    found.frequency_Hz = r.frequency_Hz[i] * std::exp2(shift / stepsPerOctave);
    found.gain_dB = b - median;
    // depth at which the width is measured: half of the height above the valleys
    const double depth_dB = prominence_dB / 2;
    found.q = qualityOf(widthOf(r, i, depth_dB), std::max(found.gain_dB, prominence_dB), depth_dB);
    r.resonances.push_back(found);
  }
  std::sort(r.resonances.begin(), r.resonances.end(),
            [](const Resonance& x, const Resonance& y) { return x.gain_dB > y.gain_dB; });
}

/// Fits the same resonances together, over all bins.
void fitResonances(FrequencyResponse& r, const Spectrum& response, double binWidth_Hz,
                   const SweepSettings& settings) {
  std::vector<double> frequency_Hz, gain_dB;
  // near the sweep's ends the spectrum leaks
  const double low = settings.from_Hz * 1.1, high = settings.to_Hz / 1.05;
  for (auto bin = static_cast<std::size_t>(std::ceil(low / binWidth_Hz));
       static_cast<double>(bin) * binWidth_Hz <= high; ++bin) {
    frequency_Hz.push_back(static_cast<double>(bin) * binWidth_Hz);
    gain_dB.push_back(10 * std::log10(std::norm(response[bin]) + 1e-20));
  }
  auto fit = fitSectionsTogether(frequency_Hz, gain_dB, r.resonances, settings.sampleRate_Hz);
  if (!fit) return;
  r.resonances = std::move(fit->resonances);
  r.errors = std::move(fit->errors);
}

double rootMeanSquare(const std::vector<double>& squaresUpTo, std::size_t from, std::size_t to) {
  return std::sqrt(std::max(0.0, squaresUpTo[to] - squaresUpTo[from]) / static_cast<double>(to - from));
}

/// Running sums of the squares of `value(i)` for i < n.
template <class Value>
std::vector<double> sumsOfSquares(std::size_t n, Value value) {
  std::vector<double> sums(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i) sums[i + 1] = sums[i] + value(i) * value(i);
  return sums;
}

/// Times at which the recording differs from `expected` by half its level and far more than it usually does.
std::vector<double> dropoutsIn(const std::vector<float>& recorded, const Spectrum& expected,
                               double sampleRate_Hz) {
  const std::size_t n = recorded.size();
  const auto width = std::max<std::size_t>(1, static_cast<std::size_t>(step_s * sampleRate_Hz));
  const auto around = static_cast<std::size_t>(around_s * sampleRate_Hz);
  const std::vector<double> level = sumsOfSquares(n, [&](std::size_t i) { return expected[i].real(); });
  const std::vector<double> rest =
      sumsOfSquares(n, [&](std::size_t i) { return static_cast<double>(recorded[i]) - expected[i].real(); });
  std::vector<double> rests;
  for (std::size_t i = 0; i + width <= n; i += width) rests.push_back(rootMeanSquare(rest, i, i + width));
  if (rests.empty()) return {};
  // The usual deviation by noise and distortion, assuming that at least a quarter of the recording is intact.
  std::vector<double> sorted = rests;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<long>(sorted.size() / 4), sorted.end());
  const double ordinary = sorted[sorted.size() / 4];
  std::vector<double> times_s;
  for (std::size_t k = 0; k < rests.size(); ++k) {
    const std::size_t at = k * width;
    const double here =
        rootMeanSquare(level, at > around ? at - around : 0, std::min(n, at + width + around));
    if (!(rests[k] > lostShare * here && rests[k] > overOrdinary * ordinary)) continue;
    const double time_s = static_cast<double>(at) / sampleRate_Hz;
    if (times_s.empty() || time_s - times_s.back() > around_s) times_s.push_back(time_s);
  }
  return times_s;
}

}  // namespace

std::vector<float> sweepSignal(const SweepSettings& s) {
  const auto length = static_cast<std::size_t>(s.duration_s * s.sampleRate_Hz);
  std::vector<float> samples(length + static_cast<std::size_t>(s.silence_s * s.sampleRate_Hz), 0);
  const double octaves = std::log(s.to_Hz / s.from_Hz);
  for (std::size_t i = 0; i < length; ++i) {
    const double t = static_cast<double>(i) / s.sampleRate_Hz;
    const double phase = 2 * std::numbers::pi * s.from_Hz * s.duration_s / octaves *
                         (std::exp(t / s.duration_s * octaves) - 1);
    const double edge = std::min({1.0, t / fade_s, (s.duration_s - t) / fade_s});
    samples[i] = static_cast<float>(s.level * std::max(edge, 0.0) * std::sin(phase));
  }
  return samples;
}

Result<FrequencyResponse> analyseSweep(const std::vector<float>& played, const std::vector<float>& recorded,
                                       const SweepSettings& settings) {
  Failure nothing{FailureCode::notCertain, "sweep", "", "nothing of the sweep is in the recording",
                  "Check that the accelerometer or microphone is on the input channel, and raise the level"};
  if (recorded.size() != played.size() || played.empty()) return nothing;
  for (float v : recorded) {
    if (!std::isfinite(v)) return nothing;
  }
  const std::size_t size = powerOfTwo(2 * played.size());
  const Spectrum x = spectrumOf(played, size);
  Spectrum h = spectrumOf(recorded, size);
  double strongest = 0;
  for (const auto& bin : x) strongest = std::max(strongest, std::norm(bin));
  for (std::size_t i = 0; i < size; ++i)
    h[i] = h[i] * std::conj(x[i]) / (std::norm(x[i]) + regularisation * strongest);
  transform(h, Transform::inverse);

  // The sound path only delays, so the response starts in the first part; distortion appears before time 0,
  // at the end.
  const auto latest = static_cast<std::size_t>(settings.silence_s * settings.sampleRate_Hz);
  std::size_t peak = 0;
  double all = 0;
  for (std::size_t i = 0; i < size; ++i) {
    all += std::norm(h[i]);
    if (i < latest && std::norm(h[i]) > std::norm(h[peak])) peak = i;
  }
  const double rest = all / static_cast<double>(size);
  if (!(std::norm(h[peak]) > rest * std::pow(10, faintest_dB / 10))) return nothing;

  const auto before = static_cast<std::size_t>(beforePeak_s * settings.sampleRate_Hz);
  const auto length = static_cast<std::size_t>(responseLength_s * settings.sampleRate_Hz);
  const std::size_t analysed = powerOfTwo(length);
  Spectrum response(analysed), expected(size);
  for (std::size_t i = 0; i < length; ++i) {
    const double window = windowAt(i, length, before);
    const std::size_t at = (peak + size - before + i) % size;
    response[i] = expected[at] = h[at].real() * window;
  }
  transform(response, Transform::forward);
  transform(expected, Transform::forward);
  for (std::size_t i = 0; i < size; ++i) expected[i] *= x[i];
  transform(expected, Transform::inverse);

  FrequencyResponse result;
  result.dropouts_s = dropoutsIn(recorded, expected, settings.sampleRate_Hz);
  result.delay_s = static_cast<double>(peak) / settings.sampleRate_Hz;
  const double binWidth = settings.sampleRate_Hz / static_cast<double>(analysed);
  const auto steps =
      static_cast<int>(std::floor(std::log2(settings.to_Hz / settings.from_Hz) * stepsPerOctave));
  for (int i = 0; i <= steps; ++i) {
    const double f = settings.from_Hz * std::exp2(i / stepsPerOctave);
    const double low = f * std::exp2(-0.5 / stepsPerOctave), high = f * std::exp2(0.5 / stepsPerOctave);
    auto first = static_cast<std::size_t>(std::floor(low / binWidth));
    const auto last = std::max(static_cast<std::size_t>(std::ceil(high / binWidth)), first + 1);
    double power = 0;
    const std::size_t from = first;
    for (; first < last; ++first) power += std::norm(response[first]);
    result.frequency_Hz.push_back(f);
    result.gain_dB.push_back(10 * std::log10(power / static_cast<double>(last - from) + 1e-20));
  }
  findResonances(result, settings);
  fitResonances(result, response, binWidth, settings);
  return result;
}

bool agree(const FrequencyResponse& a, const FrequencyResponse& b) {
  constexpr double frequencyShare = 0.03, resonance_dB = 2, median_dB = 1;
  if (a.gain_dB.size() != b.gain_dB.size() || a.resonances.size() != b.resonances.size() || a.gain_dB.empty())
    return false;
  for (const Resonance& r : a.resonances) {
    const bool found = std::any_of(b.resonances.begin(), b.resonances.end(), [&](const Resonance& other) {
      return std::fabs(other.frequency_Hz - r.frequency_Hz) <= frequencyShare * r.frequency_Hz &&
             std::fabs(other.gain_dB - r.gain_dB) <= resonance_dB;
    });
    if (!found) return false;
  }
  std::vector<double> differences_dB(a.gain_dB.size());
  for (std::size_t i = 0; i < differences_dB.size(); ++i)
    differences_dB[i] = std::fabs(a.gain_dB[i] - b.gain_dB[i]);
  const auto middle = differences_dB.begin() + static_cast<long>(differences_dB.size() / 2);
  std::nth_element(differences_dB.begin(), middle, differences_dB.end());
  return *middle <= median_dB;
}

double fullScaleLevel_dB(const FrequencyResponse& response, const SweepSettings& settings,
                         double inputFullScale_m_per_s2) {
  std::vector<double> beside_dB = response.gain_dB;
  for (std::size_t i = 0; i < beside_dB.size(); ++i) {
    for (const Resonance& r : response.resonances) {
      const BiquadCoefficients section = peaking(settings.sampleRate_Hz, r.frequency_Hz, r.q, r.gain_dB);
      beside_dB[i] -= 20 * std::log10(magnitude(section, settings.sampleRate_Hz, response.frequency_Hz[i]));
    }
  }
  const auto middle = beside_dB.begin() + static_cast<long>(beside_dB.size() / 2);
  std::nth_element(beside_dB.begin(), middle, beside_dB.end());
  return *middle + 20 * std::log10(inputFullScale_m_per_s2 / threshold_m_per_s2);
}

void applyResponse(const FrequencyResponse& response, const SweepSettings& settings, DeviceProfile& profile) {
  profile.resonances = response.resonances;
  profile.equalizer.clear();
  for (const Resonance& r : response.resonances) {
    if (profile.equalizer.size() == maxEqualizerBands || r.gain_dB <= 0) break;
    profile.equalizer.push_back({r.frequency_Hz, r.q, -std::min(r.gain_dB, settings.highestCut_dB)});
  }
}

std::string responseCsv(const FrequencyResponse& response) {
  std::string text = "frequency_Hz,gain_dB\n";
  for (std::size_t i = 0; i < response.frequency_Hz.size(); ++i) {
    text += exact(response.frequency_Hz[i]) + "," + exact(response.gain_dB[i]) + "\n";
  }
  return text;
}

}  // namespace detent::playback
