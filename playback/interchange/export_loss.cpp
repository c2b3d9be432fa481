// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/export_loss.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

#include "playback/measurement/fourier.h"

namespace detent::playback {

namespace {

constexpr std::size_t finer =
    4;  // bins relative to the press's own: a burst at the edge of a band is divided exactly there
constexpr double noEnergy = 1e-9;  // share of the whole energy; a band of the engine below it is rounding
// share of the whole energy that the transform's rounding causes in silence
constexpr double ofTransform = 1e-24;

/// Share of the bin around `frequency_Hz`, `width_Hz` wide, that lies within the band.
double shareWithin(const FeltBand& band, double frequency_Hz, double width_Hz) {
  const double low = std::fmax(band.low_Hz, frequency_Hz - width_Hz / 2);
  const double high = std::fmin(band.high_Hz, frequency_Hz + width_Hz / 2);
  return std::fmax(0, (high - low) / width_Hz);
}

using BandEnergies = std::array<double, feltBands.size()>;

/// Bins 1..highest and -1..-highest of a transform.
struct LowBins {
  std::vector<std::complex<double>> above, below;
};

/// Spectra of two signals, one as the real and one as the imaginary part, padded with silence to `length`
/// samples. Only the lowest bins are needed, so every L-th sample is transformed separately: exact, in a
/// third of the time.
template <class First>
LowBins lowBins(const std::vector<First>& first, const std::vector<double>& second, const Fourier& fourier,
                std::size_t length, std::size_t highest) {
  const std::size_t every = length / fourier.length();
  LowBins bins{std::vector<std::complex<double>>(highest + 1),
               std::vector<std::complex<double>>(highest + 1)};
  std::vector<std::complex<double>> part;
  for (std::size_t r = 0; r < every; ++r) {
    part.assign(fourier.length(), 0);
    for (std::size_t i = r, j = 0; i < first.size(); i += every)
      part[j++].real(static_cast<double>(first[i]));
    for (std::size_t i = r, j = 0; i < second.size(); i += every) part[j++].imag(second[i]);
    fourier.transform(part, Transform::forward);
    const double turn = -2 * std::numbers::pi * static_cast<double>(r) / static_cast<double>(length);
    for (std::size_t k = 1; k <= highest; ++k) {
      const std::complex<double> late = std::polar(1.0, turn * static_cast<double>(k));
      bins.above[k] += late * part[k];
      bins.below[k] += std::conj(late) * part[fourier.length() - k];
    }
  }
  return bins;
}

/// Energies of two signals within each band, by one transform: the halves of a real signal's spectrum are
/// conjugates.
template <class First>
std::pair<BandEnergies, BandEnergies> energies(const std::vector<First>& first,
                                               const std::vector<double>& second, std::size_t length,
                                               double sampleRate_Hz) {
  const double width_Hz = sampleRate_Hz / static_cast<double>(length);
  const auto highest =
      std::min(length / 2 - 1, static_cast<std::size_t>(std::ceil(feltBands.back().high_Hz / width_Hz)) + 1);
  const Fourier fourier(std::min(length, powerOfTwo(2 * (highest + 1))));
  const LowBins bins = lowBins(first, second, fourier, length, highest);
  std::pair<BandEnergies, BandEnergies> sums{};
  for (std::size_t i = 1; i <= highest; ++i) {
    const std::complex<double> mirrored = std::conj(bins.below[i]);
    const double ofFirst = std::norm(bins.above[i] + mirrored) / 4;
    const double ofSecond = std::norm(bins.above[i] - mirrored) / 4;
    for (std::size_t band = 0; band < feltBands.size(); ++band) {
      const double share = shareWithin(feltBands[band], static_cast<double>(i) * width_Hz, width_Hz);
      sums.first[band] += share * ofFirst;
      sums.second[band] += share * ofSecond;
    }
  }
  return sums;
}

std::string inWords(const std::optional<double>& share) {
  if (!share) return "none was there";
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * *share);
  return text;
}

}  // namespace

std::array<std::optional<double>, feltBands.size()> energyKept(const std::vector<float>& original,
                                                               const std::vector<std::vector<double>>& parts,
                                                               double sampleRate_Hz) {
  std::size_t longest = std::max<std::size_t>(original.size(), 2);
  for (const std::vector<double>& part : parts) longest = std::max(longest, part.size());
  const std::size_t length = powerOfTwo(finer * longest);
  static const std::vector<double> none;
  auto [before, after] = energies(original, parts.empty() ? none : parts.front(), length, sampleRate_Hz);
  for (std::size_t i = 1; i < parts.size(); i += 2) {
    const std::vector<double>& beside = i + 1 < parts.size() ? parts[i + 1] : none;
    const auto [one, other] = energies(parts[i], beside, length, sampleRate_Hz);
    for (std::size_t band = 0; band < feltBands.size(); ++band) after[band] += one[band] + other[band];
  }
  double whole = 0;
  for (const double energy : before) whole += energy;
  std::array<std::optional<double>, feltBands.size()> kept;
  for (std::size_t band = 0; band < feltBands.size(); ++band)
    if (before[band] > noEnergy * whole)
      kept[band] = after[band] > ofTransform * whole ? after[band] / before[band] : 0;
  return kept;
}

std::vector<std::string> linesOf(const ExportLoss& loss) {
  std::string kept = "energy kept:";
  for (std::size_t band = 0; band < feltBands.size(); ++band) {
    char range[32];
    std::snprintf(range, sizeof range, "%s %g-%g Hz ", band == 0 ? "" : ",", feltBands[band].low_Hz,
                  feltBands[band].high_Hz);
    kept += range + inWords(loss.energyKept[band]);
  }
  char rest[128];
  std::snprintf(rest, sizeof rest,
                "worst timing error %.3g ms; %zu grains merged; frequency moved by up to %.3g Hz",
                loss.worstTimingError_ms, loss.grainsMerged, loss.frequencyMoved_Hz);
  std::vector<std::string> lines{kept, rest};
  for (const std::string& what : loss.dropped) lines.push_back("not carried: " + what);
  return lines;
}

}  // namespace detent::playback
