// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/centre_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "importer/page/polyline.h"
#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

constexpr double kNormalStep_px = 0.5;  // along the normal
// resistance of one round's moves to bending; visible points have weight 1
constexpr double kStiffness = 0.15;
// per matching round; the comparison is linear only within this distance
constexpr double kLargestMove_px = 0.75;

/// Unit normals of a lightly smoothed line, so that pixel steps do not rotate them.
Polyline calmNormalsOf(const Polyline& line, double sigma) { return normalsOf(smoothed(line, sigma), 1); }

/// Coverage across the line at one point.
struct CrossSection {
  double own = 0;     ///< integral of the curve's own coverage, px
  double offset = 0;  ///< its centroid
  double spread = 0;  ///< variance of the profile, px²
  double hidden = 0;  ///< integral of the coverage by other curves
  double hiddenOffset = 0;
  double clutter = 0;
};

CrossSection crossSection(const CurveField& field, Point p, Point normal, double reach) {
  CrossSection s;
  double moment = 0, second = 0, hiddenMoment = 0;
  for (double t = -reach; t <= reach + 1e-9; t += kNormalStep_px) {
    const double x = p.x + t * normal.x, y = p.y + t * normal.y;
    const double own = static_cast<double>(field.own.sample(x, y));
    const double hidden = static_cast<double>(field.otherCurves.sample(x, y));
    s.own += own;
    moment += own * t;
    second += own * t * t;
    s.hidden += hidden;
    hiddenMoment += hidden * t;
    s.clutter += static_cast<double>(field.clutter.sample(x, y));
  }
  if (s.own > 1e-6) {
    s.offset = moment / s.own;
    s.spread = second / s.own - s.offset * s.offset;
  }
  if (s.hidden > 1e-6) s.hiddenOffset = hiddenMoment / s.hidden;
  s.own *= kNormalStep_px;
  s.hidden *= kNormalStep_px;
  s.clutter *= kNormalStep_px;
  return s;
}

void move(Polyline& line, const Polyline& normals, const std::vector<double>& by) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    line[i] = line[i] + by[i] * normals[i];
  }
}

/// Moves the line to the centroids of the coverage across it.
void moveToCentroids(Polyline& line, const CurveField& field, double thickness) {
  const double reach = 0.5 * thickness + 2.5;
  const Polyline normals = calmNormalsOf(line, 2.0);
  std::vector<double> offset(line.size(), 0), weight(line.size(), 0);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const CrossSection s = crossSection(field, line[i], normals[i], reach);
    if (s.own >= 0.25 * thickness) {
      offset[i] = s.offset;
      weight[i] = std::min(1.0, s.own / thickness);
    } else if (s.hidden >= 0.5 * thickness) {
      offset[i] = s.hiddenOffset;
      weight[i] = 0.2;
    }
  }
  move(line, normals, stiffened(offset, weight, 2 * kStiffness));
}

/// Direction of a piece of the line, from a to b; that of the chord if the piece is too short.
Point directionOf(const Polyline& line, std::size_t a, std::size_t b, Point chord) {
  const double length = distance(line[a], line[b]);
  if (length < 4) return chord;
  const Point d = (1 / length) * (line[b] - line[a]);
  // The tangent is continued across gaps; one far off the chord belongs to a corner.
  return dot(d, chord) > 0.7 ? d : chord;
}

/// Replaces stretches where neither the curve nor anything it could hide under is visible by a smooth curve,
/// because the coarse path is arbitrary there (all ways across a box cost the same).
void bridgeUnseen(Polyline& line, const CurveField& field, double thickness) {
  constexpr std::size_t kShortest = 4, kTangent = 12;
  const double reach = 0.5 * thickness + 1.5;
  const Polyline normals = calmNormalsOf(line, 2.0);
  std::vector<char> seen(line.size(), 0);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const CrossSection s = crossSection(field, line[i], normals[i], reach);
    seen[i] = s.own >= 0.25 * thickness || s.hidden >= 0.5 * thickness;
  }
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (seen[i] || !seen[i - 1]) continue;
    std::size_t end = i;
    while (end < line.size() && !seen[end]) ++end;
    if (end == line.size()) return;
    const std::size_t from = i - 1;
    i = end;
    if (end - from <= kShortest) continue;
    const Point a = line[from], b = line[end];
    const double length = distance(a, b);
    if (length < 1) continue;
    const Point chord = (1 / length) * (b - a);
    const Point out = directionOf(line, from - std::min(from, kTangent), from, chord);
    const Point in = directionOf(line, end, std::min(end + kTangent, line.size() - 1), chord);
    for (std::size_t k = from + 1; k < end; ++k) {
      const double t = static_cast<double>(k - from) / static_cast<double>(end - from), u = 1 - t;
      const double fromOut = length * t * u * u, fromIn = -length * t * t * u;
      const double atA = u * u * (1 + 2 * t), atB = t * t * (1 + 2 * u);
      line[k] = atA * a + atB * b + fromOut * out + fromIn * in;
    }
  }
}

/// Width and blur from cross-sections that are not hidden.
LineProfile measureProfile(const Polyline& line, const CurveField& field, double thickness) {
  const double reach = 0.5 * thickness + 3;
  const Polyline normals = calmNormalsOf(line, 2.0);
  std::vector<double> areas, spreads;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const CrossSection s = crossSection(field, line[i], normals[i], reach);
    if (s.own < 0.3 * thickness || s.hidden + s.clutter > 0.1 * thickness) continue;
    areas.push_back(s.own);
    spreads.push_back(s.spread);
  }
  LineProfile profile;
  profile.width_px = areas.size() < 8 ? thickness : medianOf(areas);
  // A box of width w blurred by a box of width s has variance (w² + s²) / 12; sampling between pixels adds
  // about 1/12 more on either axis, which the drawn line gets too.
  const double variance =
      spreads.size() < 8 ? (profile.width_px * profile.width_px + 2) / 12 : medianOf(spreads);
  profile.blur_px =
      std::sqrt(std::clamp(12 * variance - profile.width_px * profile.width_px - 1.0, 1.0, 9.0));
  return profile;
}

/// The line drawn onto a plane: per pixel the coverage at its distance to the nearest piece. Only touched
/// pixels are cleared afterwards.
class LineDrawing {
 public:
  LineDrawing(int width, int height) : plane_(width, height) {}

  const Plane& plane() const { return plane_; }

  void draw(const Polyline& line, const LineProfile& profile) {
    for (std::size_t i : touched_) plane_.values[i] = 0;
    touched_.clear();
    const double reach = profile.reach_px() + 0.5;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) drawPiece(line[i], line[i + 1], profile, reach);
  }

 private:
  void drawPiece(Point a, Point b, const LineProfile& profile, double reach) {
    const int x0 = std::max(0, static_cast<int>(std::floor(std::min(a.x, b.x) - reach)));
    const int x1 = std::min(plane_.width - 1, static_cast<int>(std::ceil(std::max(a.x, b.x) + reach)));
    const int y0 = std::max(0, static_cast<int>(std::floor(std::min(a.y, b.y) - reach)));
    const int y1 = std::min(plane_.height - 1, static_cast<int>(std::ceil(std::max(a.y, b.y) + reach)));
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const Point p{static_cast<double>(x), static_cast<double>(y)};
        const float value = static_cast<float>(profile.at(distance(p, a + projectionOn(a, b, p) * (b - a))));
        const std::size_t k = plane_.index(x, y);
        if (value <= plane_.values[k]) continue;
        if (plane_.values[k] == 0) touched_.push_back(k);
        plane_.values[k] = value;
      }
  }

  Plane plane_;
  std::vector<std::size_t> touched_;
};

/// One round: compares the drawn line with the picture at every point and moves the line; returns each
/// point's weight.
std::vector<double> matchRound(Polyline& line, const CurveField& field, const LineProfile& profile,
                               LineDrawing& drawing) {
  drawing.draw(line, profile);
  const double reach = profile.reach_px() + 1.5;
  const Polyline normals = calmNormalsOf(line, 1.5);
  double fullInformation = 0;
  for (double t = -reach; t <= reach + 1e-9; t += kNormalStep_px) {
    const double slope = profile.at(std::abs(t - 0.25)) - profile.at(std::abs(t + 0.25));
    fullInformation += 4 * slope * slope;
  }
  std::vector<double> offset(line.size(), 0), weight(line.size(), 0);
  for (std::size_t i = 0; i < line.size(); ++i) {
    double information = 0, agreement = 0, ownArea = 0, drawnArea = 0;
    for (double t = -reach; t <= reach + 1e-9; t += kNormalStep_px) {
      const double x = line[i].x + t * normals[i].x, y = line[i].y + t * normals[i].y;
      const double own = std::min(1.0, static_cast<double>(field.own.sample(x, y)));
      const double open = 1 - std::min(1.0, static_cast<double>(field.otherCurves.sample(x, y)) +
                                                static_cast<double>(field.clutter.sample(x, y)));
      const double full = static_cast<double>(drawing.plane().sample(x, y));
      const double drawn = std::min(full, open);
      ownArea += own;
      drawnArea += drawn;
      if (full > open + 0.05) continue;  // hidden: moving the line would change nothing here
      const double slope = 2 * (profile.at(std::abs(t - 0.25)) - profile.at(std::abs(t + 0.25)));
      information += slope * slope;
      agreement += slope * (own - drawn);
    }
    const double share = std::min(1.0, information / fullInformation);
    if (share < 0.08) continue;
    offset[i] = std::clamp(agreement / information, -kLargestMove_px, kLargestMove_px);
    weight[i] = share;
    const double mismatch = std::abs(ownArea - drawnArea) * kNormalStep_px / profile.width_px;
    // a marker, an arrow or a gap changes the shape here, not the line itself
    if (mismatch > 0.5) weight[i] *= 0.15;
  }
  move(line, normals, stiffened(offset, weight, kStiffness));
  return weight;
}

}  // namespace

double LineProfile::at(double distance_px) const {
  const double wider = std::max(width_px, blur_px), narrow = std::min(width_px, blur_px);
  const double top = std::min(1.0, width_px / blur_px);
  const double inner = 0.5 * (wider - narrow), outer = 0.5 * (wider + narrow);
  if (distance_px <= inner) return top;
  if (distance_px >= outer) return 0;
  return top * (outer - distance_px) / (outer - inner);
}

CentreLine centreLine(const CurveField& field, const CoarseCurve& coarse, double thickness_px,
                      const CentreLineOptions& options) {
  CentreLine result;
  if (!coarse.found()) return result;
  Polyline line = resampled(smoothed(coarse.points, 1 + 0.7 * thickness_px), 1);
  for (int round = 0; round < options.centroidRounds; ++round) {
    moveToCentroids(line, field, thickness_px);
    line = resampled(smoothed(line, 0.7), 1);
  }
  bridgeUnseen(line, field, thickness_px);
  line = resampled(line, 1);
  result.profile = measureProfile(line, field, thickness_px);
  LineDrawing drawing(field.own.width, field.own.height);
  for (int round = 0; round < options.matchRounds; ++round) {
    result.weight = matchRound(line, field, result.profile, drawing);
    if (round + 1 < options.matchRounds) line = resampled(line, 1);
  }
  if (result.weight.size() != line.size()) result.weight.assign(line.size(), 1.0);
  result.seenShare = std::accumulate(result.weight.begin(), result.weight.end(), 0.0) /
                     static_cast<double>(std::max<std::size_t>(1, line.size()));
  result.points = std::move(line);
  return result;
}

}  // namespace detent::importer::trace
