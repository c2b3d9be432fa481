// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/stroke_samples.h"

#include <algorithm>
#include <cmath>

#include "importer/strokes/calmed_points.h"

namespace detent::importer {
namespace {

std::string nameOf(Stroke stroke) { return stroke == Stroke::press ? "press stroke" : "release stroke"; }

Failure unreadable(Stroke stroke, Message place, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, nameOf(stroke), std::move(place), std::move(problem),
          std::move(remedies)};
}

struct Extent {
  double minX, maxX, minF, maxF;
  double travel() const { return maxX - minX; }
  double forceSpan() const { return maxF - minF; }
};

Extent extentOf(const std::vector<CurvePoint>& points) {
  Extent e{points[0].displacement_mm, points[0].displacement_mm, points[0].force_N, points[0].force_N};
  for (const CurvePoint& p : points) {
    e.minX = std::min(e.minX, p.displacement_mm);
    e.maxX = std::max(e.maxX, p.displacement_mm);
    e.minF = std::min(e.minF, p.force_N);
    e.maxF = std::max(e.maxF, p.force_N);
  }
  return e;
}

/// Returns true if a point is an isolated outlier: the two points on each side increase in displacement and
/// lie on one line, far from the point. A peak of one sample is not an outlier, because the samples on its
/// flanks lie on no line.
bool standsAlone(const std::vector<CurvePoint>& points, std::size_t i, double sigma_N) {
  // sigmas: noise alone exceeds 4 in 1 of 16,000 points; five times that
  constexpr double near = 4, far = 20;
  if (i < 2 || i + 2 >= points.size()) return false;
  const CurvePoint &first = points[i - 2], &last = points[i + 2];
  const double way_mm = last.displacement_mm - first.displacement_mm;
  const auto off_N = [&](const CurvePoint& p) {
    return std::abs(p.force_N - std::lerp(first.force_N, last.force_N,
                                          (p.displacement_mm - first.displacement_mm) / way_mm));
  };
  for (std::size_t k = i - 1; k <= i + 2; ++k)
    if (!((points[k].displacement_mm - points[k - 1].displacement_mm) * way_mm > 0)) return false;
  return off_N(points[i]) > far * sigma_N && off_N(points[i - 1]) <= near * sigma_N &&
         off_N(points[i + 1]) <= near * sigma_N;
}

/// Removes instrument errors: inner points farther outside the others than their range, or isolated outliers.
/// One of the former would make the resolution, a share of the spans, too coarse; one of the latter could
/// become a tactile point. Ends stay, because an end may be the only sample of a bottom-out.
std::vector<CurvePoint> withoutSlips(const std::vector<CurvePoint>& points, const PointNoise& noise) {
  constexpr std::size_t fewest = 8;
  if (points.size() < fewest) return points;
  const Extent calm = extentOf(calmed(points));
  const auto outside = [](double value, double low, double high) {
    return high > low && (value < low - (high - low) || value > high + (high - low));
  };
  std::vector<CurvePoint> kept;
  kept.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint& p = points[i];
    const bool slip = outside(p.displacement_mm, calm.minX, calm.maxX) ||
                      outside(p.force_N, calm.minF, calm.maxF) || standsAlone(points, i, noise.sigma_N);
    if (!slip || i == 0 || i + 1 == points.size()) kept.push_back(p);
  }
  return kept;
}

/// Largest movement against the direction of travel: 0 for a clean stroke, near the travel for a
/// there-and-back run.
double greatestSetback(const std::vector<SigmaPoint>& points) {
  double furthest = points.front().u, setback = 0;
  for (const SigmaPoint& p : points) {
    furthest = std::max(furthest, p.u);
    setback = std::max(setback, furthest - p.u);
  }
  return setback;
}

std::vector<SigmaPoint> withoutRepeats(const std::vector<SigmaPoint>& points) {
  std::vector<SigmaPoint> kept;
  kept.reserve(points.size());
  for (const SigmaPoint& p : points) {
    if (!kept.empty() && kept.back().u == p.u && kept.back().v == p.v) continue;
    kept.push_back(p);
  }
  return kept;
}

/// Weight of a mean of `count` points: noise averages out, the resolution does not.
double weightOfMean(double count, double noiseShare) {
  return 1 / std::sqrt(noiseShare / count + (1 - noiseShare));
}

/// Means over equal numbers of points; limit the work and the noise before arc length is measured.
std::vector<SigmaPoint> blockMeans(const std::vector<SigmaPoint>& points, std::size_t maxCount,
                                   double noiseShare) {
  if (points.size() <= maxCount) return points;
  const std::size_t inner = points.size() - 2, bins = maxCount - 2;
  std::vector<SigmaPoint> means{points.front()};
  for (std::size_t b = 0; b < bins; ++b) {
    const std::size_t from = 1 + b * inner / bins, to = 1 + (b + 1) * inner / bins;
    SigmaPoint mean{0, 0, 1};
    for (std::size_t i = from; i < to; ++i) {
      mean.u += points[i].u;
      mean.v += points[i].v;
    }
    const double count = static_cast<double>(to - from);
    means.push_back({mean.u / count, mean.v / count, weightOfMean(count, noiseShare)});
  }
  means.push_back(points.back());
  return means;
}

/// Means over equal arc lengths (each axis relative to its span), so that a steep stretch keeps its points.
std::vector<SigmaPoint> arcMeans(const std::vector<SigmaPoint>& points, std::size_t maxCount, double spanU,
                                 double spanV, double noiseShare) {
  if (points.size() <= maxCount) return points;
  const double toU = spanU > 0 ? 1 / spanU : 0, toV = spanV > 0 ? 1 / spanV : 0;
  std::vector<double> arc(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i)
    arc[i] =
        arc[i - 1] + std::hypot((points[i].u - points[i - 1].u) * toU, (points[i].v - points[i - 1].v) * toV);
  const double bins = static_cast<double>(maxCount - 2);
  std::vector<SigmaPoint> means{points.front()};
  double u = 0, v = 0, sumSquaredWeight = 0;
  long bin = 0;
  const auto flush = [&] {
    if (sumSquaredWeight > 0)
      means.push_back(
          {u / sumSquaredWeight, v / sumSquaredWeight, weightOfMean(sumSquaredWeight, noiseShare)});
    u = v = sumSquaredWeight = 0;
  };
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const long here = static_cast<long>(std::min(bins - 1, std::floor(arc[i] / arc.back() * bins)));
    if (here != bin) flush();
    bin = here;
    const double w = points[i].weight * points[i].weight;
    u += w * points[i].u;
    v += w * points[i].v;
    sumSquaredWeight += w;
  }
  flush();
  means.push_back(points.back());
  return means;
}

/// One local maximum after a running mean.
struct Peak {
  std::size_t at = 0;
  double height = 0;
};

std::vector<double> smoothedHeights(const std::vector<SigmaPoint>& points, double sign) {
  constexpr std::size_t reach = 2;
  const std::size_t window = std::min(2 * reach + 1, points.size());
  std::vector<double> heights(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Full window width at the ends too, so that a single reading there is no peak.
    const std::size_t first = std::min(i - std::min(i, reach), points.size() - window);
    double sum = 0;
    for (std::size_t k = first; k < first + window; ++k) sum += points[k].v;
    heights[i] = sign * sum / static_cast<double>(window);
  }
  return heights;
}

/// Maxima without the ends that exceed their surroundings by more than `least`.
std::vector<Peak> peaksOf(const std::vector<double>& heights, double least) {
  std::vector<Peak> peaks;
  // One pass: a candidate is the highest point since the last minimum; it counts once the force has dropped
  // by `least`.
  std::size_t top = 0;
  double low = heights[0];
  bool climbed = false;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    if (!climbed) {
      low = std::min(low, heights[i]);
      if (heights[i] - low > least) climbed = true, top = i;
    } else if (heights[i] > heights[top]) {
      top = i;
    } else if (heights[top] - heights[i] > least) {
      peaks.push_back({top, heights[top]});
      climbed = false;
      low = heights[i];
    }
  }
  return peaks;
}

/// Weights points near tactile points with their own noise instead of the resolution, because a tactile point
/// is felt first. "Near": the force is within `flatTop` of the extremum, because such deviations decide where
/// a flat top has its middle. `ownNoise` in units of the points' sigma.
void sharpenTactilePoints(std::vector<SigmaPoint>& points, Stroke stroke, double ownNoise) {
  constexpr double standsOut = 0.03, flatTop = 0.012;  // share of the force span
  constexpr double greatestGain = 8;                   // times the weight of a point away from peaks
  const std::vector<double> heights = smoothedHeights(points, stroke == Stroke::press ? 1 : -1);
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  const double span = *highest - *lowest;
  if (!(span > 0)) return;
  const double gain = greatestGain * ownNoise > 1 ? 1 / ownNoise : greatestGain;
  for (const Peak& peak : peaksOf(heights, standsOut * span)) {
    std::size_t from = peak.at, to = peak.at;
    while (from > 0 && heights[from - 1] > peak.height - flatTop * span) --from;
    while (to + 1 < points.size() && heights[to + 1] > peak.height - flatTop * span) ++to;
    for (std::size_t i = from; i <= to; ++i) points[i].weight = std::max(points[i].weight, gain);
  }
}

}  // namespace

Result<StrokeSamples> prepareSamples(const std::vector<CurvePoint>& given, Stroke stroke,
                                     const FitOptions& options) {
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!std::isfinite(given[i].displacement_mm) || !std::isfinite(given[i].force_N))
      return unreadable(stroke, "point " + std::to_string(i + 1),
                        Message("displacement or force is not a usable number"),
                        Message("Leave out such points before fitting"));
  const std::vector<CurvePoint> points = withoutSlips(given, options.noise);
  if (points.size() < 2)
    return unreadable(stroke, "",
                      points.empty() ? Message("there are no points") : Message("there is only one point"),
                      Message("Give at least two points with different displacements"));
  const Extent extent = extentOf(points);
  const double travel = extent.travel(), forceSpan = extent.forceSpan();
  if (!(travel > 0))
    return unreadable(stroke, "", Message("all points have the same displacement, so there is no travel"),
                      Message("Check the displacement axis or column"));
  if (!std::isfinite(travel) || !std::isfinite(forceSpan))
    return unreadable(stroke, "", Message("the points are too far apart to compute with"),
                      Message("Check the units of the axes"));

  StrokeSamples samples;
  const bool turned = points.back().displacement_mm < points.front().displacement_mm;
  samples.origin = turned ? points.back() : points.front();
  const double floor_mm = options.resolutionOfSpan * travel, floor_N = options.resolutionOfSpan * forceSpan;
  samples.mmPerU = std::hypot(options.noise.sigma_mm, floor_mm);
  samples.newtonsPerV = std::hypot(options.noise.sigma_N, floor_N);
  const double noiseShare = std::max(std::pow(options.noise.sigma_mm / samples.mmPerU, 2),
                                     std::pow(options.noise.sigma_N / samples.newtonsPerV, 2));
  samples.points.reserve(points.size());
  for (const CurvePoint& p : points)
    samples.points.push_back({samples.u(p.displacement_mm), samples.v(p.force_N), 1});
  if (turned) std::reverse(samples.points.begin(), samples.points.end());

  const double spanU = travel / samples.mmPerU, spanV = forceSpan / samples.newtonsPerV;
  const double advance = samples.points.back().u - samples.points.front().u;
  if (!(advance > 0) || greatestSetback(samples.points) > std::max(0.25 * spanU, 8.0))
    return unreadable(
        stroke, "", Message("the displacement of the points goes back and forth"),
        Message("Separate press and release, and put the points of each into the order of the movement"));
  const std::size_t maxCount = static_cast<std::size_t>(options.maxPoints);
  samples.points = withoutRepeats(samples.points);
  samples.points = blockMeans(samples.points, 8 * maxCount, noiseShare);
  samples.points = arcMeans(samples.points, maxCount, spanU, spanV, noiseShare);
  sharpenTactilePoints(samples.points, stroke, options.noiseAtTactilePoints_share * std::sqrt(noiseShare));
  return samples;
}

}  // namespace detent::importer
