// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/sampling.h"
#include "model/sections.h"

namespace detent {
namespace {

constexpr double sampleStep = 0.002;  // distance of samples, in normalised units of arc length
constexpr double mostSamples = 1e5;   // reached by a stroke that is 200 times as long as the spans
constexpr std::size_t runsPerLine = 256;

struct Spot {
  double x, y;
};

using Line = std::vector<Spot>;

Line normalised(const StrokePolyline& stroke, double span_mm, double span_N) {
  Line line;
  for (const CurvePoint& p : stroke) {
    const Spot spot{p.displacement_mm / span_mm, p.force_N / span_N};
    if (line.empty() || line.back().x != spot.x || line.back().y != spot.y) line.push_back(spot);
  }
  return line;
}

// Returns points at even arc lengths, both ends included.
Line sampled(const Line& line) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < line.size(); ++i)
    along.push_back(along.back() + std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y));
  if (!(along.back() > 0)) return {line.front()};
  const auto count =
      static_cast<std::size_t>(std::clamp(std::ceil(along.back() / sampleStep), 1.0, mostSamples));
  Line samples;
  std::size_t segment = 0;
  for (std::size_t k = 0; k <= count; ++k) {
    const double at = along.back() * static_cast<double>(k) / static_cast<double>(count);
    while (segment + 2 < line.size() && along[segment + 1] < at) ++segment;
    const double length = along[segment + 1] - along[segment];
    const double share = length > 0 ? std::clamp((at - along[segment]) / length, 0.0, 1.0) : 0;
    const Spot a = line[segment], b = line[segment + 1];
    samples.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
  }
  return samples;
}

struct Offset {
  double squared, dx, dy;
  double distance() const { return std::sqrt(squared); }
};

Offset offsetTo(const Spot& p, const Spot& a, const Spot& b) {
  const double vx = b.x - a.x, vy = b.y - a.y, length2 = vx * vx + vy * vy;
  const double share =
      length2 > 0 ? std::clamp(((p.x - a.x) * vx + (p.y - a.y) * vy) / length2, 0.0, 1.0) : 0;
  const double dx = p.x - (a.x + share * vx), dy = p.y - (a.y + share * vy);
  return {dx * dx + dy * dy, std::abs(dx), std::abs(dy)};
}

// Finds the nearest place on a polyline. Bounding boxes of runs of segments let distant runs be skipped.
class NearestPlace {
 public:
  explicit NearestPlace(const Line& line) : line_(line) {
    const std::size_t segments = std::max<std::size_t>(1, line.size() - 1);
    runLength_ = std::max<std::size_t>(1, segments / runsPerLine);
    for (std::size_t first = 0; first < segments; first += runLength_) {
      Box box{line[first].x, line[first].x, line[first].y, line[first].y};
      for (std::size_t i = first; i <= std::min(first + runLength_, line.size() - 1); ++i) {
        box.x0 = std::min(box.x0, line[i].x);
        box.x1 = std::max(box.x1, line[i].x);
        box.y0 = std::min(box.y0, line[i].y);
        box.y1 = std::max(box.y1, line[i].y);
      }
      boxes_.push_back(box);
    }
  }

  Offset to(const Spot& p) {
    if (line_.size() == 1) return offsetTo(p, line_[0], line_[0]);
    Offset best{std::numeric_limits<double>::infinity(), 0, 0};
    searchRun(p, lastRun_, best);  // the previous sample's run first, for a tight bound
    const std::size_t near = lastRun_;
    for (std::size_t run = 0; run < boxes_.size(); ++run)
      if (run != near && boxes_[run].squaredDistance(p) < best.squared) searchRun(p, run, best);
    return best;
  }

 private:
  struct Box {
    double x0, x1, y0, y1;
    double squaredDistance(const Spot& p) const {
      const double dx = std::max({x0 - p.x, 0.0, p.x - x1}), dy = std::max({y0 - p.y, 0.0, p.y - y1});
      return dx * dx + dy * dy;
    }
  };
  void searchRun(const Spot& p, std::size_t run, Offset& best) {
    const std::size_t first = run * runLength_, end = std::min(first + runLength_, line_.size() - 1);
    for (std::size_t i = first; i < end; ++i) {
      const Offset offset = offsetTo(p, line_[i], line_[i + 1]);
      if (offset.squared >= best.squared) continue;
      best = offset;
      lastRun_ = run;
    }
  }
  const Line& line_;
  std::vector<Box> boxes_;
  std::size_t runLength_ = 1, lastRun_ = 0;
};

struct OneWay {
  double mean = 0, p95 = 0, max = 0, maxBefore = 0, meanX = 0, maxX = 0, meanY = 0, maxY = 0;
};

// Linear interpolation between order statistics, as in numpy.
double percentile(std::vector<double>& values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

// `bottomOut`: displacement, normalised, from which samples do not count for `maxBefore`.
OneWay oneWay(const Line& from, const Line& to, double bottomOut) {
  NearestPlace nearest(to);
  OneWay result;
  std::vector<double> distances;
  for (const Spot& p : sampled(from)) {
    const Offset offset = nearest.to(p);
    distances.push_back(offset.distance());
    result.mean += distances.back();
    result.meanX += offset.dx;
    result.meanY += offset.dy;
    result.max = std::max(result.max, distances.back());
    if (p.x < bottomOut) result.maxBefore = std::max(result.maxBefore, distances.back());
    result.maxX = std::max(result.maxX, offset.dx);
    result.maxY = std::max(result.maxY, offset.dy);
  }
  const auto count = static_cast<double>(distances.size());
  result.mean /= count;
  result.meanX /= count;
  result.meanY /= count;
  result.p95 = percentile(distances, 0.95);
  return result;
}

StrokeDistance distanceBetween(const Line& a, const Line& b, double span_mm, double span_N,
                               double bottomOut_mm) {
  const double bottomOut = bottomOut_mm / span_mm;
  const OneWay there = oneWay(a, b, bottomOut), back = oneWay(b, a, bottomOut);
  StrokeDistance d;
  d.meanOfSpan = 0.5 * (there.mean + back.mean);
  d.p95OfSpan = std::max(there.p95, back.p95);
  d.maxOfSpan = std::max(there.max, back.max);
  d.maxBeforeBottomOutOfSpan = std::max(there.maxBefore, back.maxBefore);
  d.mean_mm = 0.5 * (there.meanX + back.meanX) * span_mm;
  d.max_mm = std::max(there.maxX, back.maxX) * span_mm;
  d.mean_N = 0.5 * (there.meanY + back.meanY) * span_N;
  d.max_N = std::max(there.maxY, back.maxY) * span_N;
  return d;
}

// max - min over both strokes; 1 if nothing varies.
double spanOf(const GraphPolylines& graph, double CurvePoint::*value) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const StrokePolyline* stroke : {&graph.press, &graph.release})
    for (const CurvePoint& p : *stroke) {
      low = std::min(low, p.*value);
      high = std::max(high, p.*value);
    }
  return high > low ? high - low : 1;
}

}  // namespace

GraphPolylines polylinesOf(const ForceGraph& graph) {
  GraphPolylines lines;
  const auto bottomOut_mm = [](const StrokeCurve& curve) {
    const BottomOut found = bottomOutOf(curve);
    return found.isSteep ? found.displacement_mm : std::numeric_limits<double>::infinity();
  };
  lines.press = travelledSamples(graph, Stroke::press);
  lines.pressBottomOut_mm = bottomOut_mm(graph.press());
  if (graph.release()) {
    lines.release = travelledSamples(graph, Stroke::release);
    lines.releaseBottomOut_mm = bottomOut_mm(*graph.release());
  }
  return lines;
}

Result<GraphDistance> compare(const GraphPolylines& first, const GraphPolylines& second) {
  GraphDistance result;
  result.span_mm = spanOf(first, &CurvePoint::displacement_mm);
  result.span_N = spanOf(first, &CurvePoint::force_N);
  const auto strokeDistance = [&](StrokePolyline GraphPolylines::*stroke,
                                  double GraphPolylines::*bottomOut) -> std::optional<StrokeDistance> {
    const StrokePolyline &a = first.*stroke, &b = second.*stroke;
    if (a.empty() || b.empty()) return {};
    return distanceBetween(normalised(a, result.span_mm, result.span_N),
                           normalised(b, result.span_mm, result.span_N), result.span_mm, result.span_N,
                           std::min(first.*bottomOut, second.*bottomOut));
  };
  result.press = strokeDistance(&GraphPolylines::press, &GraphPolylines::pressBottomOut_mm);
  result.release = strokeDistance(&GraphPolylines::release, &GraphPolylines::releaseBottomOut_mm);
  if (!result.press && !result.release)
    return Failure{FailureCode::wrongUsage, "compare", "", Message("the two graphs have no stroke in common"),
                   Message("Choose two graphs that both have a press, or both have a release")};
  int strokes = 0;
  for (const auto& stroke : {result.press, result.release}) {
    if (!stroke) continue;
    ++strokes;
    result.meanOfSpan += stroke->meanOfSpan;
    result.maxOfSpan = std::max(result.maxOfSpan, stroke->maxOfSpan);
  }
  result.meanOfSpan /= strokes;
  return result;
}

}  // namespace detent
