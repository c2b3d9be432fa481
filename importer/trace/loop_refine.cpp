// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/loop_refine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "importer/page/polyline.h"
#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

/// A straight line of the plot in plane px, sub-pixel, with its width in view px.
struct ThinLine {
  bool vertical;
  double centre;
  double halfWidth_px;
  double level;
};

std::vector<ThinLine> thinLines(const std::vector<StraightLine>& lines, double scale) {
  std::vector<ThinLine> out;
  for (const StraightLine& l : lines) {
    double sum = 0, moment = 0, top = 0;
    for (int o = -l.reach; o <= l.reach; ++o) {
      sum += l.at(o);
      moment += o * double(l.at(o));
      top = std::max(top, double(l.at(o)));
    }
    if (sum <= 0) continue;
    out.push_back({l.vertical, l.position + moment / sum, 0.5 * scale * sum / top, top});
  }
  return out;
}

/// Coverage across one point of a stroke.
struct Profile {
  std::vector<double> covered;  ///< 0..1 in units of the curve's darkness
  std::vector<char> known;      ///< false where a gridline hides the curve
  double first = 0, step = 1;   ///< offset of the first sample along the normal, px

  double offset(std::size_t k) const { return first + step * static_cast<double>(k); }
};

class Profiler {
 public:
  Profiler(const Plane& coverage, const WorkPlane& plane, const std::vector<StraightLine>& lines,
           double level)
      : coverage_(coverage), plane_(plane), lines_(thinLines(lines, plane.scale)), level_(level) {}

  Profile across(Point p, Point normal, double from, double to, double step) const {
    Profile out;
    out.first = from;
    out.step = step;
    const auto n = static_cast<std::size_t>(std::floor((to - from) / step)) + 1;
    out.covered.resize(n);
    out.known.assign(n, 1);
    const Point base = plane_.fromArea(p), ahead = plane_.fromArea(p + normal);
    for (std::size_t k = 0; k < n; ++k) {
      const double t = out.offset(k);
      const double c = static_cast<double>(coverage_.sample(p + t * normal));
      double hidden = 0;
      for (const ThinLine& l : lines_) {
        const double at = l.vertical ? base.x + t * (ahead.x - base.x) : base.y + t * (ahead.y - base.y);
        const double off = std::abs(at - l.centre) * plane_.scale;
        if (off > l.halfWidth_px + 1) continue;
        hidden = std::max(hidden, l.level * std::clamp(l.halfWidth_px + 0.8 - off, 0.0, 1.0));
      }
      if (c < 0.5 * hidden) hidden = 0;  // the line is broken here
      if (hidden > 0.4 * level_) out.known[k] = 0;
      out.covered[k] = std::clamp((c - hidden) / std::max(0.2, 1 - hidden) / level_, 0.0, 1.0);
    }
    return out;
  }

 private:
  const Plane& coverage_;
  const WorkPlane& plane_;
  std::vector<ThinLine> lines_;
  double level_;
};

double lineModel(double offset, double halfWidth) {
  return std::clamp(halfWidth + 0.5 - std::abs(offset), 0.0, 1.0);
}

struct Fit {
  double offset = 0;    ///< of this stroke, along the normal
  double other = 0;     ///< of the other stroke, if part of the model
  double misfit = 1;    ///< mean squared difference of coverage and model, 0..1
  double evidence = 0;  ///< share of the line's own width that was visible
};

/// Misfit of one line at u (and of a second at v) to the coverage around them.
double misfitOf(const Profile& p, double halfWidth, double u, std::optional<double> v,
                double* evidence = nullptr) {
  const double low = std::min(u, v.value_or(u)) - halfWidth - 1.5,
               high = std::max(u, v.value_or(u)) + halfWidth + 1.5;
  double sum = 0, count = 0, seen = 0, own = 0;
  for (std::size_t k = 0; k < p.covered.size(); ++k) {
    const double t = p.offset(k);
    if (t < low || t > high) continue;
    const double mine = lineModel(t - u, halfWidth);
    own += mine;
    if (!p.known[k]) continue;
    seen += mine;
    const double model = v ? std::max(mine, lineModel(t - *v, halfWidth)) : mine;
    sum += (p.covered[k] - model) * (p.covered[k] - model);
    count += 1;
  }
  if (evidence) *evidence = own > 0 ? seen / own : 0;
  // Hidden samples count as undecided, so that a place completely under a gridline is no perfect fit.
  const double all = std::max(1.0, (high - low) / p.step);
  return (sum + 0.04 * (all - count)) / all;
}

constexpr double kPull = 0.004;  ///< preference for the offset nearest to the path, per squared search radius

Fit fitSingle(const Profile& p, double halfWidth, double radius) {
  Fit best;
  double bestCost = 1e9;
  std::vector<double> costs;
  for (double u = -radius; u <= radius + 1e-9; u += p.step) {
    const double cost = misfitOf(p, halfWidth, u, std::nullopt) + kPull * (u * u) / (radius * radius);
    costs.push_back(cost);
    if (cost < bestCost) {
      bestCost = cost;
      best.offset = u;
    }
  }
  for (double step = p.step / 2; step > 0.04; step /= 2) {
    for (double u : {best.offset - step, best.offset + step}) {
      const double cost = misfitOf(p, halfWidth, u, std::nullopt) + kPull * (u * u) / (radius * radius);
      if (cost >= bestCost) continue;
      bestCost = cost;
      best.offset = u;
    }
  }
  best.misfit = misfitOf(p, halfWidth, best.offset, std::nullopt, &best.evidence);
  return best;
}

/// Both strokes at once; `side` +1: this one lies to the left (press), -1: to the right. Sides are never
/// exchanged.
Fit fitDouble(const Profile& p, double halfWidth, double radius, double otherGuess, double side) {
  Fit best;
  double bestCost = 1e9;
  const auto tryAt = [&](double u, double v) {
    if (side * (u - v) < 0) return;
    const double cost = misfitOf(p, halfWidth, u, v) +
                        kPull * (u * u + (v - otherGuess) * (v - otherGuess)) / (radius * radius);
    if (cost >= bestCost) return;
    bestCost = cost;
    best.offset = u;
    best.other = v;
  };
  for (double u = -radius; u <= radius + 1e-9; u += p.step) {
    for (double v = otherGuess - radius; v <= otherGuess + radius + 1e-9; v += p.step) tryAt(u, v);
  }
  for (double step = p.step / 2; step > 0.04; step /= 2) {
    const double u = best.offset, v = best.other;
    for (double du : {-step, 0.0, step}) {
      for (double dv : {-step, 0.0, step}) tryAt(u + du, v + dv);
    }
  }
  best.misfit = misfitOf(p, halfWidth, best.offset, best.other, &best.evidence);
  return best;
}

/// Offset at which the other stroke crosses this one's normal, if it runs close by.
std::optional<double> offsetOfOther(Point p, Point normal, const std::vector<Point>& other,
                                    const std::vector<Point>& otherNormals, double reach, std::size_t& hint) {
  if (other.empty()) return std::nullopt;
  // Both run in the same order, so the nearest point advances with the sample.
  const std::size_t from = hint > 60 ? hint - 60 : 0, to = std::min(other.size(), hint + 120);
  double best = 1e18;
  std::size_t at = hint;
  for (std::size_t j = from; j < to; ++j) {
    const double d = distance(p, other[j]);
    if (d < best) {
      best = d;
      at = j;
    }
  }
  hint = at;
  if (best > reach) return std::nullopt;
  const Point q = other[at], m = otherNormals[at];
  const double parallel = dot(normal, m);
  if (parallel < 0.8) return std::nullopt;
  // The other line through q, intersected with this normal.
  return dot(q - p, m) / parallel;
}

struct Pass {
  double radius;     ///< px searched on either side
  double step;       ///< px
  double stiffness;  ///< of the smoothing
};

struct Working {
  std::vector<Point> points, normals;
  std::vector<double> trust;
};

void refineOnce(Working& self, const Working& other, double side, const Profiler& profiler,
                double strokeWidth, const Pass& pass) {
  const double half = strokeWidth / 2;
  std::vector<double> offset(self.points.size()), weight(self.points.size()), trust(self.points.size());
  std::size_t hint = 0;
  for (std::size_t i = 0; i < self.points.size(); ++i) {
    const std::optional<double> beside =
        offsetOfOther(self.points[i], self.normals[i], other.points, other.normals,
                      strokeWidth + 2 * pass.radius + 1, hint);
    const double reach = pass.radius + half + 1.5;
    const double low = std::min(0.0, beside.value_or(0.0)) - reach,
                 high = std::max(0.0, beside.value_or(0.0)) + reach;
    const Profile profile = profiler.across(self.points[i], self.normals[i], low, high, pass.step);
    const Fit fit =
        beside ? fitDouble(profile, half, pass.radius, *beside, side) : fitSingle(profile, half, pass.radius);
    const bool atLimit = std::abs(fit.offset) > pass.radius - 0.01;
    offset[i] = fit.offset;
    const double good =
        std::clamp(1 - fit.misfit / 0.08, 0.0, 1.0) * std::clamp((fit.evidence - 0.15) / 0.35, 0.0, 1.0);
    trust[i] = atLimit ? 0.1 * good : good;
    // Weight of the path, which is the best guess if nothing can be measured; without it the ends would
    // drift along their slope.
    constexpr double kPath = 0.02;
    offset[i] *= trust[i] / (trust[i] + kPath);
    weight[i] = trust[i] + kPath;
  }
  const std::vector<double> smoothOffset = stiffened(offset, weight, pass.stiffness);
  for (std::size_t i = 0; i < self.points.size(); ++i) {
    self.points[i] = self.points[i] + smoothOffset[i] * self.normals[i];
  }
  self.trust = trust;
}

/// Darkness on the ridge and width of a stroke where nothing else is near.
struct StrokeProfile {
  double level = 1;
  double width_px = 1;
};

/// Measured on the original coverage (a profiler of level 1); `guess` if too little of the stroke stands
/// alone.
StrokeProfile measureStrokeProfile(const Working& stroke, const Profiler& plain, const StrokeProfile& guess) {
  std::vector<double> coverages, peaks;
  const double reach = 1.5 * guess.width_px + 2.5;
  for (std::size_t i = 0; i < stroke.points.size(); i += 3) {
    const Profile p = plain.across(stroke.points[i], stroke.normals[i], -reach, reach, 0.25);
    bool clear = true;
    double sum = 0, peak = 0;
    for (std::size_t k = 0; k < p.covered.size(); ++k) {
      clear = clear && p.known[k];
      sum += p.covered[k] * p.step;
      peak = std::max(peak, p.covered[k]);
    }
    if (!clear || peak < 0.05 || std::max(p.covered.front(), p.covered.back()) > 0.15 * peak) continue;
    coverages.push_back(sum);
    peaks.push_back(peak);
  }
  if (coverages.size() < 10) return guess;
  StrokeProfile strokeProfile;
  strokeProfile.level = std::clamp(quantileOf(peaks, 0.5), 0.05, 1.0);
  // Blends of two lines are wider, never narrower: the single line is below the median.
  strokeProfile.width_px =
      std::clamp(quantileOf(coverages, 0.4) / strokeProfile.level, 0.9, 2.5 * guess.width_px + 1);
  return strokeProfile;
}

Working start(const std::vector<Point>& planePoints, const WorkPlane& plane) {
  Working w;
  Polyline area;
  for (const Point& p : planePoints) area.push_back(plane.toArea(p));
  // Long horizontal or vertical runs of one plane pixel are steps of the search, not of the curve.
  w.points = smoothed(resampled(area, 1.0), 1.6 * plane.scale);
  w.normals = normalsOf(w.points, static_cast<int>(std::ceil(2 * plane.scale)) + 1);
  return w;
}

void renew(Working& w) {
  w.points = resampled(w.points, 1.0);
  w.normals = normalsOf(smoothed(w.points, 1.5), 3);
}

}  // namespace

RefinedPair refinePair(const PlanePair& pair, const WorkPlane& plane, const Plane& coverage,
                       const std::vector<StraightLine>& lines, const Structure& structure) {
  const Profiler plain(coverage, plane, lines, 1);
  Working press = start(pair.press, plane), release;
  if (!pair.release.empty()) release = start(pair.release, plane);
  StrokeProfile strokeProfile{structure.curveLevel, structure.strokeWidth_px * plane.scale};
  const std::array<Pass, 2> passes{
      Pass{1.2 * plane.scale + 1, std::max(0.6, plane.scale / 3), 4 * plane.scale}, Pass{1.5, 0.5, 3}};
  for (std::size_t k = 0; k < passes.size(); ++k) {
    if (k > 0) {
      renew(press);
      if (!release.points.empty()) renew(release);
    }
    strokeProfile = measureStrokeProfile(press, plain, strokeProfile);
    const Profiler profiler(coverage, plane, lines, strokeProfile.level);
    const Working pressBefore = press;
    refineOnce(press, release, 1, profiler, strokeProfile.width_px, passes[k]);
    if (!release.points.empty())
      refineOnce(release, pressBefore, -1, profiler, strokeProfile.width_px, passes[k]);
  }
  return {{press.points, strokeProfile.width_px, press.trust},
          {release.points, strokeProfile.width_px, release.trust}};
}

}  // namespace detent::importer::trace
