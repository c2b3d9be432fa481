// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/centre_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace detent::importer::inks {

namespace {

constexpr double kStep_px = 0.5;          // along the normal
constexpr double kStiffness = 0.15;       // of one round's moves against bending; seen points have weight 1
constexpr double kLargestMove_px = 0.75;  // per round of matching: the comparison is linear only so far

using Polyline = std::vector<Point>;

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Points `spacing` apart along the line; ends kept.
Polyline resampled(const Polyline& line, double spacing) {
  if (line.size() < 2) return line;
  std::vector<double> length(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i) length[i] = length[i - 1] + distance(line[i - 1], line[i]);
  const double total = length.back();
  if (total <= 0) return {line.front(), line.back()};
  const std::size_t n = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(total / spacing)));
  Polyline out;
  out.reserve(n + 1);
  std::size_t j = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    const double s = total * static_cast<double>(i) / static_cast<double>(n);
    while (j + 2 < line.size() && length[j + 1] < s) ++j;
    const double piece = length[j + 1] - length[j];
    const double t = piece > 0 ? std::clamp((s - length[j]) / piece, 0.0, 1.0) : 0;
    out.push_back({line[j].x + t * (line[j + 1].x - line[j].x), line[j].y + t * (line[j + 1].y - line[j].y)});
  }
  return out;
}

/// Gaussian along the line; near the ends the window shrinks so that ends stay where they are.
Polyline smoothed(const Polyline& line, double sigma) {
  const int reach = std::max(1, static_cast<int>(std::ceil(2.5 * sigma)));
  std::vector<double> kernel(static_cast<std::size_t>(reach) + 1);
  for (int k = 0; k <= reach; ++k)
    kernel[static_cast<std::size_t>(k)] = std::exp(-0.5 * k * k / (sigma * sigma));
  Polyline out(line.size());
  const int n = static_cast<int>(line.size());
  for (int i = 0; i < n; ++i) {
    const int window = std::min({reach, i, n - 1 - i});
    double x = 0, y = 0, sum = 0;
    for (int k = -window; k <= window; ++k) {
      const double w = kernel[static_cast<std::size_t>(std::abs(k))];
      x += w * line[static_cast<std::size_t>(i + k)].x;
      y += w * line[static_cast<std::size_t>(i + k)].y;
      sum += w;
    }
    out[static_cast<std::size_t>(i)] = {x / sum, y / sum};
  }
  return out;
}

/// Unit normals of a lightly smoothed line, so that the pixel staircase does not turn them.
Polyline normalsOf(const Polyline& line, double sigma) {
  const Polyline calm = smoothed(line, sigma);
  Polyline normals(line.size(), {0, 1});
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(line.size() - 1, i + 1);
    const double dx = calm[b].x - calm[a].x, dy = calm[b].y - calm[a].y, length = std::hypot(dx, dy);
    if (length > 1e-9)
      normals[i] = {-dy / length, dx / length};
    else if (i > 0)
      normals[i] = normals[i - 1];
  }
  return normals;
}

/// Minimises sum w_i (x_i - d_i)^2 + stiffness * sum (second difference)^2: banded Cholesky, two
/// off-diagonals.
std::vector<double> stiffened(const std::vector<double>& target, const std::vector<double>& weight,
                              double stiffness) {
  const std::size_t n = target.size();
  if (n < 3) return target;
  std::vector<double> a(n), b(n, 0), c(n, 0), x(n);
  for (std::size_t i = 0; i < n; ++i) {
    a[i] = weight[i] + 1e-6;  // a faint pull to zero keeps unseen lines finite
    x[i] = weight[i] * target[i];
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    a[i - 1] += stiffness;
    a[i] += 4 * stiffness;
    a[i + 1] += stiffness;
    b[i - 1] -= 2 * stiffness;
    b[i] -= 2 * stiffness;
    c[i - 1] += stiffness;
  }
  // a, b, c: diagonal, first and second super-diagonal; LDL^T in place.
  std::vector<double> l1(n, 0), l2(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    if (i >= 2) a[i] -= l2[i - 2] * l2[i - 2] * a[i - 2];
    if (i >= 1) a[i] -= l1[i - 1] * l1[i - 1] * a[i - 1];
    if (i + 1 < n) {
      double off = b[i];
      if (i >= 1) off -= l1[i - 1] * l2[i - 1] * a[i - 1];
      l1[i] = off / a[i];
    }
    if (i + 2 < n) l2[i] = c[i] / a[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (i >= 1) x[i] -= l1[i - 1] * x[i - 1];
    if (i >= 2) x[i] -= l2[i - 2] * x[i - 2];
  }
  for (std::size_t i = 0; i < n; ++i) x[i] /= a[i];
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) x[i] -= l1[i] * x[i + 1];
    if (i + 2 < n) x[i] -= l2[i] * x[i + 2];
  }
  return x;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Ink seen across the line at one point.
struct CrossSection {
  double own = 0;     ///< integral of the curve's own ink, px
  double offset = 0;  ///< its centroid
  double spread = 0;  ///< its variance, px²
  double hidden = 0;  ///< integral of other curves' ink
  double hiddenOffset = 0;
  double clutter = 0;
};

CrossSection crossSection(const CurveField& field, Point p, Point normal, double reach) {
  CrossSection s;
  double moment = 0, second = 0, hiddenMoment = 0;
  for (double t = -reach; t <= reach + 1e-9; t += kStep_px) {
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
  s.own *= kStep_px;
  s.hidden *= kStep_px;
  s.clutter *= kStep_px;
  return s;
}

void move(Polyline& line, const Polyline& normals, const std::vector<double>& by) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    line[i].x += by[i] * normals[i].x;
    line[i].y += by[i] * normals[i].y;
  }
}

/// Pulls the line onto the centroids of what is seen across it.
void moveToCentroids(Polyline& line, const CurveField& field, double thickness) {
  const double reach = 0.5 * thickness + 2.5;
  const Polyline normals = normalsOf(line, 2.0);
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

/// Direction of a piece of the line, from a to b; the chord's where the piece is too short.
Point directionOf(const Polyline& line, std::size_t a, std::size_t b, Point chord) {
  const double dx = line[b].x - line[a].x, dy = line[b].y - line[a].y, length = std::hypot(dx, dy);
  if (length < 4) return chord;
  const Point d{dx / length, dy / length};
  // Across a gap a line goes on roughly as it came; what turns far off the chord ended in a corner.
  return d.x * chord.x + d.y * chord.y > 0.7 ? d : chord;
}

/// Where neither the curve nor anything that follows it is seen, the coarse course is arbitrary (all ways
/// across a box cost the same): a smooth piece joins what is seen on both sides.
void bridgeUnseen(Polyline& line, const CurveField& field, double thickness) {
  constexpr std::size_t kShortest = 4, kTangent = 12;
  const double reach = 0.5 * thickness + 1.5;
  const Polyline normals = normalsOf(line, 2.0);
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
    const Point chord{(b.x - a.x) / length, (b.y - a.y) / length};
    const Point out = directionOf(line, from - std::min(from, kTangent), from, chord);
    const Point in = directionOf(line, end, std::min(end + kTangent, line.size() - 1), chord);
    for (std::size_t k = from + 1; k < end; ++k) {
      const double t = static_cast<double>(k - from) / static_cast<double>(end - from), u = 1 - t;
      const double fromOut = length * t * u * u, fromIn = -length * t * t * u;
      const double atA = u * u * (1 + 2 * t), atB = t * t * (1 + 2 * u);
      line[k] = {atA * a.x + atB * b.x + fromOut * out.x + fromIn * in.x,
                 atA * a.y + atB * b.y + fromOut * out.y + fromIn * in.y};
    }
  }
}

/// Width and blur from cross-sections that nothing hides.
LineProfile measureProfile(const Polyline& line, const CurveField& field, double thickness) {
  const double reach = 0.5 * thickness + 3;
  const Polyline normals = normalsOf(line, 2.0);
  std::vector<double> areas, spreads;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const CrossSection s = crossSection(field, line[i], normals[i], reach);
    if (s.own < 0.3 * thickness || s.hidden + s.clutter > 0.1 * thickness) continue;
    areas.push_back(s.own);
    spreads.push_back(s.spread);
  }
  LineProfile profile;
  profile.width_px = areas.size() < 8 ? thickness : median(areas);
  // A box of width w blurred by a box of width s has variance (w² + s²) / 12; sampling between pixels adds
  // about 1/12 more on either axis, which the drawn line gets as well.
  const double variance =
      spreads.size() < 8 ? (profile.width_px * profile.width_px + 2) / 12 : median(spreads);
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
    const double dx = b.x - a.x, dy = b.y - a.y, l2 = dx * dx + dy * dy;
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double t = l2 > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / l2, 0.0, 1.0) : 0;
        const double d = std::hypot(x - a.x - t * dx, y - a.y - t * dy);
        const float value = static_cast<float>(profile.at(d));
        const std::size_t k = plane_.index(x, y);
        if (value <= plane_.values[k]) continue;
        if (plane_.values[k] == 0) touched_.push_back(k);
        plane_.values[k] = value;
      }
  }

  Plane plane_;
  std::vector<std::size_t> touched_;
};

/// One round: compares drawn with seen across every point and moves the line; gives each point's weight.
std::vector<double> matchRound(Polyline& line, const CurveField& field, const LineProfile& profile,
                               LineDrawing& drawing) {
  drawing.draw(line, profile);
  const double reach = profile.reach_px() + 1.5;
  const Polyline normals = normalsOf(line, 1.5);
  double fullInformation = 0;
  for (double t = -reach; t <= reach + 1e-9; t += kStep_px) {
    const double slope = profile.at(std::abs(t - 0.25)) - profile.at(std::abs(t + 0.25));
    fullInformation += 4 * slope * slope;
  }
  std::vector<double> offset(line.size(), 0), weight(line.size(), 0);
  for (std::size_t i = 0; i < line.size(); ++i) {
    double information = 0, agreement = 0, ownArea = 0, drawnArea = 0;
    for (double t = -reach; t <= reach + 1e-9; t += kStep_px) {
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
    const double mismatch = std::abs(ownArea - drawnArea) * kStep_px / profile.width_px;
    if (mismatch > 0.5) weight[i] *= 0.15;  // a marker, an arrow, a gap: not the line's own shape
  }
  move(line, normals, stiffened(offset, weight, kStiffness));
  return weight;
}

}  // namespace

double LineProfile::at(double distance_px) const {
  const double wide = std::max(width_px, blur_px), narrow = std::min(width_px, blur_px);
  const double top = std::min(1.0, width_px / blur_px);
  const double inner = 0.5 * (wide - narrow), outer = 0.5 * (wide + narrow);
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

}  // namespace detent::importer::inks
