// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/split_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "importer/page/quantile.h"

namespace detent::importer {
std::vector<StrokeSpan> spansOf(const std::vector<CurvePoint>& samples, double least_mm) {
  std::vector<StrokeSpan> spans;
  if (samples.size() < 2) return spans;
  // direction of the current stroke (+1 press, -1 release, 0 not known yet), its first sample, and its
  // extremes
  int way = 0;
  std::size_t begin = 0, lowest = 0, highest = 0;
  const auto x = [&](std::size_t i) { return samples[i].displacement_mm; };
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (x(i) < x(lowest)) lowest = i;
    // The last of equal maxima is the turning point. A dwell there is removed from the press later
    // (endBeforeDwell).
    if (x(i) >= x(highest)) highest = i;
    if (way >= 0 && x(highest) - x(i) > least_mm && highest < i) {
      if (way > 0 || highest > begin) spans.push_back({begin, highest, Stroke::press});
      way = -1;
      begin = lowest = highest;
      for (std::size_t k = begin; k <= i; ++k)
        if (x(k) < x(lowest)) lowest = k;
    } else if (way <= 0 && x(i) - x(lowest) > least_mm && lowest < i) {
      if (way < 0) spans.push_back({begin, lowest, Stroke::release});
      way = 1;
      begin = highest = lowest;
      for (std::size_t k = begin; k <= i; ++k)
        if (x(k) >= x(highest)) highest = k;
    }
  }
  if (way > 0) spans.push_back({begin, highest, Stroke::press});
  if (way < 0) spans.push_back({begin, lowest, Stroke::release});
  return spans;
}

void endBeforeDwell(std::vector<CurvePoint>& press, double noise_mm, double noise_N) {
  constexpr double band = 3, fall = 5;  // noises
  if (press.size() < 2) return;
  double deepest_mm = press.back().displacement_mm;
  for (const CurvePoint& p : press) deepest_mm = std::max(deepest_mm, p.displacement_mm);
  const auto first = std::ranges::find_if(
      press, [&](const CurvePoint& p) { return p.displacement_mm >= deepest_mm - band * noise_mm; });
  const auto strongest = std::ranges::max_element(first, press.end(), {}, &CurvePoint::force_N);
  if (strongest->force_N - press.back().force_N <= fall * noise_N || strongest - press.begin() < 1) return;
  press.erase(strongest + 1, press.end());
}

std::vector<CurvePoint> bridged(const std::vector<CurvePoint>& stroke) {
  constexpr double farGaps = 4, leastShare = 0.02;  // factor of the usual gap; share of the travel
  std::vector<double> gaps_mm;
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    const double gap_mm = std::abs(stroke[i].displacement_mm - stroke[i - 1].displacement_mm);
    if (gap_mm > 0) gaps_mm.push_back(gap_mm);
  }
  if (gaps_mm.size() < 3) return stroke;
  const double travel_mm = std::accumulate(gaps_mm.begin(), gaps_mm.end(), 0.0);
  std::nth_element(gaps_mm.begin(), gaps_mm.begin() + static_cast<std::ptrdiff_t>(gaps_mm.size() / 2),
                   gaps_mm.end());
  const double usual_mm = std::max(gaps_mm[gaps_mm.size() / 2], 0.25 * leastShare * travel_mm);
  std::vector<CurvePoint> filled{stroke.front()};
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    const CurvePoint &a = stroke[i - 1], &b = stroke[i];
    const double gap_mm = std::abs(b.displacement_mm - a.displacement_mm);
    if (gap_mm > farGaps * usual_mm) {
      const int pieces = static_cast<int>(std::ceil(gap_mm / usual_mm));
      for (int k = 1; k < pieces; ++k) {
        const double share = static_cast<double>(k) / pieces;
        filled.push_back(
            {std::lerp(a.displacement_mm, b.displacement_mm, share), std::lerp(a.force_N, b.force_N, share)});
      }
    }
    filled.push_back(b);
  }
  return filled;
}

double noiseOf(const std::vector<double>& values, double lastDigit) {
  constexpr std::size_t enough = 4096;  // with this many bends the median is exact to 2 %
  const std::size_t every = values.size() / enough + 1;
  std::vector<double> bends;
  double resolution = std::numeric_limits<double>::infinity();
  double greatest = 0;
  for (const double value : values) greatest = std::max(greatest, std::abs(value));
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    // Rounding of decimal fractions leaves differences of a few ulp between equal numbers.
    if (step > 1e-12 * greatest) resolution = std::min(resolution, step);
    if (i % every == 0 && i + 1 < values.size())
      bends.push_back(std::abs(values[i + 1] - 2 * values[i] + values[i - 1]));
  }
  constexpr std::size_t fewest = 16;
  double noise = 0;
  if (values.size() < fewest) return noise;
  if (!bends.empty()) noise = 1.4826 * medianOf(std::move(bends)) / std::sqrt(6.0);
  resolution = std::min(resolution, lastDigit);
  if (std::isfinite(resolution)) noise = std::max(noise, resolution / std::sqrt(12.0));
  return noise;
}

std::optional<BeforeContact> beforeContact(const std::vector<CurvePoint>& press, double noise_N) {
  constexpr std::size_t fewest = 5;
  if (press.size() < 8) return std::nullopt;
  const std::size_t few = std::max<std::size_t>(3, press.size() / 200);
  std::vector<double> start;
  for (std::size_t i = 0; i < few; ++i) start.push_back(press[i].force_N);
  const auto [lowest, highest] = std::ranges::minmax(press, {}, &CurvePoint::force_N);
  const double first = medianOf(start), span = highest.force_N - lowest.force_N;
  constexpr double leastBand = 2e-3, mostBand = 0.02;  // share of the span
  const double band = std::clamp(4 * noise_N, leastBand * span, mostBand * span);
  std::size_t end = 0;
  // One reading outside the band is noise; two in a row mean that the key is touched.
  while (end < press.size() && (std::abs(press[end].force_N - first) <= band ||
                                (end + 1 < press.size() && std::abs(press[end + 1].force_N - first) <= band)))
    ++end;
  const double travel = press.back().displacement_mm - press.front().displacement_mm;
  const double flat = end > 0 ? press[end - 1].displacement_mm - press.front().displacement_mm : 0;
  // A shorter flat stretch is the beginning of the rise; one over most of the travel is the button's own
  // force.
  constexpr double leastFlat = 0.01, mostFlat = 0.9;  // share of the travel
  if (end < fewest || flat < leastFlat * travel || flat > mostFlat * travel) return std::nullopt;
  // On a slope the last readings of the stretch already rise, so they are left out.
  const std::size_t judged = std::max(fewest, end - end / 5);
  std::vector<double> before;
  double mean_mm = 0, mean_N = 0;
  const double n = static_cast<double>(judged);
  for (std::size_t i = 0; i < judged; ++i) {
    before.push_back(press[i].force_N);
    mean_mm += press[i].displacement_mm / n, mean_N += press[i].force_N / n;
  }
  double xx = 0, xf = 0, ff = 0;
  for (std::size_t i = 0; i < judged; ++i) {
    const double x = press[i].displacement_mm - mean_mm, f = press[i].force_N - mean_N;
    xx += x * x, xf += x * f, ff += f * f;
  }
  if (!(xx > 0)) return std::nullopt;
  const double slope = xf / xx, scatter = std::sqrt(std::max(0.0, ff - slope * xf) / std::max(1.0, n - 2));
  const double rise = slope * (press[judged - 1].displacement_mm - press.front().displacement_mm);
  constexpr double mostRise = 0.004;  // share of the force span: drift of a gauge
  if (rise > std::max(3 * std::sqrt(12.0 / n) * scatter, mostRise * span)) return std::nullopt;
  BeforeContact found;
  found.force_N = medianOf(before);
  // An offset is small compared with the button's forces; a larger flat force is the button's own.
  constexpr double mostOffset = 0.06;  // share of the span
  if (std::abs(found.force_N) > mostOffset * span) return std::nullopt;
  // The contact is the point at which a line through the first readings of the rise meets the flat force.
  const std::size_t rising = std::min(press.size(), end + 4);
  if (rising <= end) return std::nullopt;
  const CurvePoint a = press[end], b = press[rising - 1];
  const double steep = (b.force_N - a.force_N) / std::max(1e-12, b.displacement_mm - a.displacement_mm);
  found.contact_mm = press[end].displacement_mm;
  if (steep > 0) {
    found.contact_mm -= (a.force_N - found.force_N) / steep;
    found.uncertainty_mm = band / 4 / steep;
  }
  found.contact_mm =
      std::clamp(found.contact_mm, press[judged - 1].displacement_mm, press[end].displacement_mm);
  return found;
}

}  // namespace detent::importer
