// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/fit/segment_stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace detent::importer {
namespace {

/// A point in its run: z is the run's variable, w is fitted as a cubic of z.
struct RunPoint {
  double z = 0, w = 0;
  double weight = 1;  ///< weight of a squared residual in w
};

struct Run {
  std::size_t from = 0, to = 0;  ///< points [from, to)
  bool steep = false;
};

/// Direction of the points around each one, over a few sigmas to suppress noise.
std::vector<SigmaPoint> localDirections(const std::vector<SigmaPoint>& points) {
  constexpr double reach = 3;  // sigmas on each side
  const std::size_t n = points.size();
  std::vector<SigmaPoint> directions(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t lo = i, hi = i;
    const auto far = [&](std::size_t k) {
      return std::hypot(points[k].u - points[i].u, points[k].v - points[i].v) >= reach;
    };
    while (lo > 0 && !far(lo)) --lo;
    while (hi + 1 < n && !far(hi)) ++hi;
    directions[i] = {points[hi].u - points[lo].u, points[hi].v - points[lo].v, 1};
  }
  return directions;
}

std::vector<Run> runsOf(const std::vector<SigmaPoint>& points, const std::vector<SigmaPoint>& directions) {
  constexpr double steepness = 4;       // sigma per sigma: above it u(v) is the better-conditioned function
  constexpr double shortestSteep = 10;  // sigmas of v
  std::vector<char> steep(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    steep[i] = std::abs(directions[i].v) > steepness * std::abs(directions[i].u);
  std::vector<Run> runs;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t j = i;
    while (j < points.size() && steep[j] == steep[i]) ++j;
    const bool isSteep = steep[i] && std::abs(points[j - 1].v - points[i].v) >= shortestSteep;
    if (!runs.empty() && runs.back().steep == isSteep)
      runs.back().to = j;
    else
      runs.push_back({i, j, isSteep});
    i = j;
  }
  return runs;
}

/// Sums over points of z^k and z^k w about an origin; shifting the origin keeps them accurate for short
/// stretches.
struct Moments {
  double z[7] = {}, zw[4] = {}, ww = 0;
  int count = 0;

  void add(double dz, double w, double weight) {
    double power = weight;
    for (int k = 0; k < 7; ++k) {
      z[k] += power;
      if (k < 4) zw[k] += power * w;
      power *= dz;
    }
    ww += weight * w * w;
    ++count;
  }

  /// Adds moments whose origin lies `shift` further along z and `lift` higher in w.
  void addShifted(const Moments& m, double shift, double lift) {
    static constexpr double binomial[7][7] = {{1},
                                              {1, 1},
                                              {1, 2, 1},
                                              {1, 3, 3, 1},
                                              {1, 4, 6, 4, 1},
                                              {1, 5, 10, 10, 5, 1},
                                              {1, 6, 15, 20, 15, 6, 1}};
    double power[7];
    power[0] = 1;
    for (int k = 1; k < 7; ++k) power[k] = power[k - 1] * shift;
    for (int k = 0; k < 7; ++k) {
      double sum = 0;
      for (int j = 0; j <= k; ++j) sum += binomial[k][j] * power[k - j] * m.z[j];
      z[k] += sum;
    }
    double lifted[4];
    for (int k = 0; k < 4; ++k) lifted[k] = m.zw[k] + lift * m.z[k];
    for (int k = 0; k < 4; ++k) {
      double sum = 0;
      for (int j = 0; j <= k; ++j) sum += binomial[k][j] * power[k - j] * lifted[j];
      zw[k] += sum;
    }
    ww += m.ww + 2 * lift * m.zw[0] + lift * lift * m.z[0];
    count += m.count;
  }
};

/// w = c0 + c1 s + c2 s^2 + c3 s^3 with s = (z - z0) / scale.
struct Cubic {
  double z0 = 0, scale = 1, w0 = 0;
  double c[4] = {};
  double at(double z) const {
    const double s = (z - z0) / scale;
    return w0 + c[0] + s * (c[1] + s * (c[2] + s * c[3]));
  }
  double slopeAt(double z) const {
    const double s = (z - z0) / scale;
    return (c[1] + s * (2 * c[2] + s * 3 * c[3])) / scale;
  }
};

/// Fits a cubic by least squares from moments about (z0, w0); `length` is the extent of the stretch. Returns
/// chi-square.
double solveCubic(const Moments& m, double length, Cubic& cubic) {
  const int order = std::min(4, std::max(1, m.count));
  const double scale = length > 0 ? length : 1;
  double power[7];
  power[0] = 1;
  for (int k = 1; k < 7; ++k) power[k] = power[k - 1] / scale;
  double lower[4][4], y[4];
  // Cholesky with a small ridge: equal z make the system singular, and the ridge selects the flattest
  // solution.
  const double ridge = 1e-11 * m.z[0];
  for (int i = 0; i < order; ++i) {
    for (int j = 0; j <= i; ++j) {
      double sum = m.z[i + j] * power[i + j] + (i == j ? ridge : 0);
      for (int k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
      lower[i][j] = i == j ? std::sqrt(std::max(sum, ridge)) : sum / lower[j][j];
    }
    double sum = m.zw[i] * power[i];
    for (int k = 0; k < i; ++k) sum -= lower[i][k] * y[k];
    y[i] = sum / lower[i][i];
  }
  double explained = 0;
  for (int i = 0; i < order; ++i) explained += y[i] * y[i];
  for (int i = order - 1; i >= 0; --i) {
    double sum = y[i];
    for (int k = i + 1; k < order; ++k) sum -= lower[k][i] * cubic.c[k];
    cubic.c[i] = sum / lower[i][i];
  }
  for (int i = order; i < 4; ++i) cubic.c[i] = 0;
  cubic.scale = scale;
  return std::max(0.0, m.ww - explained);
}

/// Limits w to the median of its neighbours, so that noise spikes get no piece of their own.
void tameSpikes(std::vector<RunPoint>& points) {
  constexpr double reach = 4;  // sigmas
  if (points.size() < 5) return;
  std::vector<double> tamed(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t from = std::min(i < 2 ? 0 : i - 2, points.size() - 5);
    double five[5];
    for (std::size_t k = 0; k < 5; ++k) five[k] = points[from + k].w;
    std::nth_element(five, five + 2, five + 5);
    const double slack = reach / std::sqrt(points[i].weight);
    tamed[i] = std::clamp(points[i].w, five[2] - slack, five[2] + slack);
  }
  for (std::size_t i = 0; i < points.size(); ++i) points[i].w = tamed[i];
}

std::vector<RunPoint> alongRun(const std::vector<SigmaPoint>& points,
                               const std::vector<SigmaPoint>& directions, const Run& run) {
  std::vector<RunPoint> along;
  along.reserve(run.to - run.from);
  for (std::size_t i = run.from; i < run.to; ++i) {
    const SigmaPoint &p = points[i], &dir = directions[i];
    // A residual in w, measured across the curve, is shorter by the cosine of the local direction.
    const double length = std::hypot(dir.u, dir.v), across = run.steep ? dir.v : dir.u;
    const double cosine = length > 0 ? std::max(0.02, std::abs(across) / length) : 1;
    const double weight = p.weight * p.weight * cosine * cosine;
    along.push_back(run.steep ? RunPoint{p.v, p.u, weight} : RunPoint{p.u, p.v, weight});
  }
  tameSpikes(along);
  return along;
}

/// Indices where blocks of points begin: about `blocks` at most, at equal shares of points and of length.
std::vector<std::size_t> blockStarts(const std::vector<RunPoint>& points, double blocks) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += std::hypot(points[i].z - points[i - 1].z, points[i].w - points[i - 1].w);
  std::vector<std::size_t> starts{0};
  double share = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = std::hypot(points[i].z - points[i - 1].z, points[i].w - points[i - 1].w);
    share += 0.5 / static_cast<double>(points.size()) + (length > 0 ? 0.5 * step / length : 0);
    if (share * blocks >= 1) {
      starts.push_back(i);
      share = 0;
    }
  }
  starts.push_back(points.size());
  return starts;
}

struct Stretch {
  std::size_t from = 0, to = 0;  ///< points of the run
  Cubic cubic;
};

Cubic cubicOver(const std::vector<RunPoint>& points, std::size_t from, std::size_t to) {
  Cubic cubic;
  cubic.z0 = points[from].z;
  cubic.w0 = points[from].w;
  Moments m;
  for (std::size_t i = from; i < to; ++i)
    m.add(points[i].z - cubic.z0, points[i].w - cubic.w0, points[i].weight);
  solveCubic(m, std::abs(points[to - 1].z - cubic.z0), cubic);
  return cubic;
}

/// The cuts with the least chi-square + penalty per piece.
std::vector<Stretch> cutRun(const std::vector<RunPoint>& points, double blocks, double penalty) {
  const std::vector<std::size_t> starts = blockStarts(points, blocks);
  const std::size_t n = starts.size() - 1;
  std::vector<Moments> block(n);
  for (std::size_t b = 0; b < n; ++b) {
    const RunPoint& origin = points[starts[b]];
    for (std::size_t i = starts[b]; i < starts[b + 1]; ++i)
      block[b].add(points[i].z - origin.z, points[i].w - origin.w, points[i].weight);
  }
  std::vector<double> best(n + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> previous(n + 1, 0);
  best[0] = 0;
  for (std::size_t i = 0; i < n; ++i) {
    Moments m;
    const RunPoint& origin = points[starts[i]];
    for (std::size_t j = i; j < n; ++j) {
      const RunPoint& here = points[starts[j]];
      m.addShifted(block[j], here.z - origin.z, here.w - origin.w);
      Cubic unused;
      const double total =
          best[i] + penalty + solveCubic(m, std::abs(points[starts[j + 1] - 1].z - origin.z), unused);
      if (total < best[j + 1]) best[j + 1] = total, previous[j + 1] = i;
    }
  }
  std::vector<Stretch> stretches;
  for (std::size_t j = n; j > 0; j = previous[j])
    stretches.push_back({starts[previous[j]], starts[j], cubicOver(points, starts[previous[j]], starts[j])});
  std::reverse(stretches.begin(), stretches.end());
  return stretches;
}

constexpr double steepest = 1e6;  // slope in scaled axes: steeper is vertical

double slopeOf(const Stretch& stretch, double z, bool steep) {
  const double slope = stretch.cubic.slopeAt(z);
  if (!steep) return slope;
  return std::abs(slope) * steepest > 1 ? 1 / slope : std::copysign(steepest, slope);
}

/// Common slope of both sides: the gentler one, which never overshoots; 0 if the signs differ.
double sharedSlope(double before, double after) {
  if (before * after <= 0) return 0;
  return std::abs(before) < std::abs(after) ? before : after;
}

/// A corner if one common slope would bend the curve visibly; else a smooth or flat joint.
JointKind jointFor(double slopeBefore, double slopeAfter, double lengthBefore, double lengthAfter) {
  const double shared = std::atan(sharedSlope(slopeBefore, slopeAfter));
  // A cubic whose end slope is off by a small angle deviates by 4/27 of the angle times its length.
  const auto bend = [&](double slope, double length) {
    return 4.0 / 27 * std::abs(std::atan(slope) - shared) * length;
  };
  if (std::max(bend(slopeBefore, lengthBefore), bend(slopeAfter, lengthAfter)) > 1) return JointKind::corner;
  return slopeBefore * slopeAfter <= 0 ? JointKind::flat : JointKind::smooth;
}

ChainKnot knotAt(double u, double v, double slopeBefore, double slopeAfter, JointKind joint) {
  if (joint == JointKind::corner) return {{u, v, slopeBefore, slopeAfter}, joint};
  const double shared = sharedSlope(slopeBefore, slopeAfter);
  return {{u, v, shared, shared}, joint};
}

/// Adds knots at extrema inside a cubic that exceed the noise.
void addInnerExtrema(KnotChain& chain, const Stretch& stretch, double fromU, double toU) {
  const Cubic& cubic = stretch.cubic;
  const double a = 3 * cubic.c[3], b = cubic.c[2], c = cubic.c[1];  // derivative a s^2 + 2 b s + c
  double roots[2];
  int count = 0;
  const double discriminant = b * b - a * c;
  if (discriminant > 0) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (a != 0) roots[count++] = q / a;
    if (q != 0) roots[count++] = c / q;
  }
  std::sort(roots, roots + count);
  std::vector<CurvePoint> extrema;
  for (int i = 0; i < count; ++i) {
    const double u = cubic.z0 + roots[i] * cubic.scale;
    if (u > fromU && u < toU) extrema.push_back({u, cubic.at(u)});
  }
  constexpr double standsOut = 0.5;  // sigmas
  for (std::size_t i = 0; i < extrema.size(); ++i) {
    const double before = i == 0 ? cubic.at(fromU) : extrema[i - 1].force_N;
    const double after = i + 1 < extrema.size() ? extrema[i + 1].force_N : cubic.at(toU);
    const double v = extrema[i].force_N;
    if (std::abs(v - before) > standsOut && std::abs(v - after) > standsOut)
      chain.push_back({{extrema[i].displacement_mm, v, 0, 0}, JointKind::flat});
  }
}

struct PlacedStretch {
  Stretch stretch;
  const std::vector<RunPoint>* points = nullptr;
  bool steep = false;
  std::size_t offset = 0;  ///< index of the first point of its run

  std::size_t first() const { return offset + stretch.from; }
  std::size_t last() const { return offset + stretch.to - 1; }
  double length() const {
    const RunPoint &a = (*points)[stretch.from], &b = (*points)[stretch.to - 1];
    return std::hypot(b.z - a.z, b.w - a.w);
  }
};

ChainKnot jointBetween(const std::vector<SigmaPoint>& points, const PlacedStretch& before,
                       const PlacedStretch& after) {
  const SigmaPoint &p = points[before.last()], &q = points[after.first()];
  double u = 0.5 * (p.u + q.u), v = 0.5 * (p.v + q.v);
  const double zBefore = before.steep ? v : u, zAfter = after.steep ? v : u;
  if (before.steep == after.steep) {
    const double w = 0.5 * (before.stretch.cubic.at(zBefore) + after.stretch.cubic.at(zAfter));
    (before.steep ? u : v) = w;
  }
  const double slopeBefore = slopeOf(before.stretch, zBefore, before.steep);
  const double slopeAfter = slopeOf(after.stretch, zAfter, after.steep);
  return knotAt(u, v, slopeBefore, slopeAfter,
                jointFor(slopeBefore, slopeAfter, before.length(), after.length()));
}

}  // namespace

double correlationOf(std::vector<double> residuals) {
  double meanSquare = 0;
  for (double r : residuals) meanSquare += r * r;
  const double cut =
      3 * std::sqrt(meanSquare / static_cast<double>(std::max<std::size_t>(1, residuals.size())));
  for (double& r : residuals) r = std::clamp(r, -cut, cut);
  const auto covariance = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t i = lag; i < residuals.size(); ++i) sum += residuals[i] * residuals[i - lag];
    return sum;
  };
  const double variance = covariance(0);
  if (!(variance > 0)) return 1;
  double together = 1;
  for (std::size_t lag = 1; lag < std::min<std::size_t>(residuals.size() / 4, 50); ++lag) {
    const double rho = covariance(lag) / variance;
    if (rho < 0.05) break;
    together += 2 * rho;
  }
  return together;
}

Segmentation segmentStroke(const std::vector<SigmaPoint>& points, int candidates, double penalty) {
  const std::vector<SigmaPoint> directions = localDirections(points);
  const std::vector<Run> runs = runsOf(points, directions);
  std::vector<std::vector<RunPoint>> along;
  along.reserve(runs.size());
  std::vector<PlacedStretch> stretches;
  std::vector<double> residuals;
  for (const Run& run : runs) {
    along.push_back(alongRun(points, directions, run));
    const double share = static_cast<double>(run.to - run.from) / static_cast<double>(points.size());
    for (const Stretch& s : cutRun(along.back(), std::max(2.0, share * candidates), penalty)) {
      stretches.push_back({s, &along.back(), run.steep, run.from});
      for (std::size_t i = s.from; i < s.to; ++i)
        residuals.push_back(std::sqrt(along.back()[i].weight) *
                            (along.back()[i].w - s.cubic.at(along.back()[i].z)));
    }
  }

  KnotChain chain;
  const PlacedStretch &head = stretches.front(), &tail = stretches.back();
  const double headSlope =
      slopeOf(head.stretch, head.steep ? points.front().v : points.front().u, head.steep);
  chain.push_back({{points.front().u, points.front().v, headSlope, headSlope}, JointKind::smooth});
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const bool isLast = i + 1 == stretches.size();
    const double tailSlope =
        slopeOf(tail.stretch, tail.steep ? points.back().v : points.back().u, tail.steep);
    const ChainKnot next =
        isLast ? ChainKnot{{points.back().u, points.back().v, tailSlope, tailSlope}, JointKind::smooth}
               : jointBetween(points, stretches[i], stretches[i + 1]);
    if (!stretches[i].steep) addInnerExtrema(chain, stretches[i].stretch, chain.back().u(), next.u());
    chain.push_back(next);
  }
  levelDisplacements(chain);
  return {std::move(chain), correlationOf(std::move(residuals))};
}

}  // namespace detent::importer
