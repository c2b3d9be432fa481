// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/split_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

double travelOf(const StrokeSpan& span, const std::vector<CurvePoint>& samples) {
  return std::abs(samples[span.to].displacement_mm - samples[span.from].displacement_mm);
}

}  // namespace

std::vector<StrokeSpan> spansOf(const std::vector<CurvePoint>& samples, double least_mm) {
  std::vector<StrokeSpan> spans;
  if (samples.size() < 2) return spans;
  // The way of the current stroke (+1 press, -1 release, 0 not yet known), where it began and its furthest
  // sample.
  int way = 0;
  std::size_t begin = 0, lowest = 0, highest = 0;
  const auto x = [&](std::size_t i) { return samples[i].displacement_mm; };
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (x(i) < x(lowest)) lowest = i;
    // The last of equal heights: a dwell at the bottom is cut off the press later (endBeforeDwell).
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

FirstCycle firstCycleOf(const std::vector<StrokeSpan>& spans, const std::vector<CurvePoint>& samples) {
  constexpr double most = 0.6;  // of the longest stroke: an aborted press or a twitch is none
  double longest = 0;
  for (const StrokeSpan& span : spans) longest = std::max(longest, travelOf(span, samples));
  FirstCycle cycle;
  const auto isWhole = [&](const StrokeSpan& span) { return travelOf(span, samples) >= most * longest; };
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (spans[i].stroke != Stroke::press || !isWhole(spans[i])) continue;
    ++cycle.cycles;
    const bool releases = i + 1 < spans.size() && isWhole(spans[i + 1]);
    if (!cycle.press || (!cycle.release && releases)) {
      cycle.press = spans[i];
      if (releases) cycle.release = spans[i + 1];
    }
  }
  // A run that begins at the bottom: the release before the only press.
  if (cycle.press && !cycle.release)
    for (const StrokeSpan& span : spans)
      if (span.stroke == Stroke::release && isWhole(span)) cycle.release = span;
  return cycle;
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
  constexpr double farGaps = 4, leastShare = 0.02;  // of the usual gap, and of the travel
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

double noiseOf(const std::vector<double>& values) {
  std::vector<double> bends;
  double resolution = std::numeric_limits<double>::infinity();
  double greatest = 0;
  for (const double value : values) greatest = std::max(greatest, std::abs(value));
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    // Rounding of decimal fractions leaves differences of a few ulp between equal numbers.
    if (step > 1e-12 * greatest) resolution = std::min(resolution, step);
    if (i + 1 < values.size()) bends.push_back(std::abs(values[i + 1] - 2 * values[i] + values[i - 1]));
  }
  constexpr std::size_t fewest = 16;
  double noise = 0;
  if (values.size() < fewest) return noise;
  if (!bends.empty()) noise = 1.4826 * medianOf(std::move(bends)) / std::sqrt(6.0);
  if (std::isfinite(resolution)) noise = std::max(noise, resolution / std::sqrt(12.0));
  return noise;
}

std::optional<double> forceBeforeContact(const std::vector<CurvePoint>& press, double noise_N) {
  if (press.size() < 8) return std::nullopt;
  const std::size_t few = std::max<std::size_t>(3, press.size() / 200);
  std::vector<double> start;
  for (std::size_t i = 0; i < few; ++i) start.push_back(press[i].force_N);
  double highest = press[0].force_N, lowest = press[0].force_N;
  for (const CurvePoint& p : press)
    highest = std::max(highest, p.force_N), lowest = std::min(lowest, p.force_N);
  const double first = medianOf(start), span = highest - lowest;
  const double band = std::max(5 * noise_N, 2e-3 * span);
  std::size_t end = 0;
  while (end < press.size() && std::abs(press[end].force_N - first) <= band) ++end;
  const double travel = press.back().displacement_mm - press.front().displacement_mm;
  const double flat = end > 0 ? press[end - 1].displacement_mm - press.front().displacement_mm : 0;
  // Short of this it is the foot of the rise; beyond half it is the button's own force.
  if (end < 5 || flat < 0.01 * travel || flat > 0.5 * travel) return std::nullopt;
  std::vector<double> before;
  for (std::size_t i = 0; i < end; ++i) before.push_back(press[i].force_N);
  const double offset = medianOf(before);
  // An offset is small against the forces it is an offset of; a plateau at working force is not.
  if (std::abs(offset) > 0.1 * span) return std::nullopt;
  return offset;
}

}  // namespace detent::importer
