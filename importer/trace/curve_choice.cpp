#include "importer/trace/curve_choice.h"

#include <algorithm>
#include <cmath>

namespace detent::importer::inks {

namespace {

constexpr double kMinSpan = 0.12;          // of the frame's width
constexpr double kMinInkShare = 0.5;       // of the visible course: dashes have about this much
constexpr double kMinInkShareNeutral = 0.85;
constexpr double kMinExplained = 0.3;      // of the ink's mass outside text and legend
constexpr float kGreyChroma = 26;          // colour levels between the largest and the smallest channel

double massOf(const Plane& plane) {
  double sum = 0;
  for (float v : plane.values) sum += static_cast<double>(v);
  return sum;
}

/// Calls `visit(x, y)` for every pixel of the plane within `reach` of a course; pixels may come several times.
template <class Visit>
void forPixelsNear(const Plane& plane, const std::vector<Point>& course, double reach, Visit visit) {
  const int r = static_cast<int>(std::ceil(reach));
  for (Point p : course) {
    const int cx = static_cast<int>(p.x), cy = static_cast<int>(p.y);
    for (int y = cy - r; y <= cy + r; ++y)
      for (int x = cx - r; x <= cx + r; ++x)
        if (plane.inside(x, y)) visit(x, y);
  }
}

/// Clears the ink within `reach` of a course and gives how much that was.
double eraseAlong(Plane& plane, const std::vector<Point>& course, double reach) {
  double erased = 0;
  forPixelsNear(plane, course, reach, [&](int x, int y) {
    erased += static_cast<double>(plane.at(x, y));
    plane.at(x, y) = 0;
  });
  return erased;
}

/// Share of a course that runs within `reach` of another one.
double shareAlong(const CoarseCurve& course, const CoarseCurve& other, double reach, const Plane& size) {
  Plane near(size.width, size.height);
  forPixelsNear(near, other.points, reach, [&](int x, int y) { near.at(x, y) = 1; });
  double inside = 0;
  for (Point p : course.points) inside += static_cast<double>(near.at(static_cast<int>(p.x), static_cast<int>(p.y)));
  return inside / static_cast<double>(std::max<std::size_t>(1, course.points.size()));
}

FollowOptions optionsFor(double thickness) {
  FollowOptions options;
  options.reversalCost = 6 + 2 * thickness;
  return options;
}

/// A level or plumb line is a marker, an axis or a leader, never a force curve.
bool isAxisParallel(const CoarseCurve& course, double thickness) {
  return course.rise_px <= 1.5 * thickness + 1 || course.span_px <= 1.5 * thickness + 1;
}

/// All of the course within a line's width of the chord between its ends.
bool isStraight(const CoarseCurve& course, double thickness) {
  const Point a = course.points.front(), b = course.points.back();
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::max(1.0, std::hypot(dx, dy));
  return std::all_of(course.points.begin(), course.points.end(), [&](Point p) {
    return std::abs((p.x - a.x) * dy - (p.y - a.y) * dx) / length <= thickness + 2;
  });
}

std::optional<CurveInk> curveOf(const PlotInks& plot, int index, bool neutral) {
  std::vector<int> others;
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k)
    if (k != index) others.push_back(k);
  CurveField field = fieldOf(plot, index, others);
  CurveInk curve;
  curve.ink = index;
  curve.neutral = neutral;
  curve.thickness_px = lineThickness(field.own);
  const FollowOptions options = optionsFor(curve.thickness_px);
  curve.course = followCurve(field, plot.area.frame, options);
  const double width = plot.area.frame.width();
  if (!curve.course.found() || curve.course.span_px < kMinSpan * width || curve.course.gain_px < kMinSpan * width)
    return {};
  if (curve.course.inkShare < (neutral ? kMinInkShareNeutral : kMinInkShare)) return {};
  if (isAxisParallel(curve.course, curve.thickness_px)) return {};
  if (neutral && isStraight(curve.course, curve.thickness_px)) return {};
  const double mass = massOf(field.own);
  double explained = eraseAlong(field.own, curve.course.points, curve.thickness_px + 2);
  const CoarseCurve second = followCurve(field, plot.area.frame, options);
  if (second.found() && second.span_px >= 0.25 * curve.course.span_px &&
      !isAxisParallel(second, curve.thickness_px)) {
    curve.secondStrand = second.gain_px / curve.course.gain_px;
    explained += eraseAlong(field.own, second.points, curve.thickness_px + 2);
  }
  if (explained < kMinExplained * mass) return {};
  return curve;
}

/// Edge pixels between two touching lines look like a third ink; its course never leaves theirs.
bool isSeam(const CurveInk& curve, const std::vector<CurveInk>& stronger, const Plane& size) {
  return std::any_of(stronger.begin(), stronger.end(), [&](const CurveInk& other) {
    return curve.course.gain_px < 0.6 * other.course.gain_px &&
           shareAlong(curve.course, other.course, other.thickness_px + 2, size) > 0.75;
  });
}

}  // namespace

CurveField fieldOf(const PlotInks& plot, int index, const std::vector<int>& curveInks) {
  const Plane& own = plot.coverage.ink[static_cast<std::size_t>(index)];
  CurveField field{own, Plane(own.width, own.height), plot.coverage.unknown};
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k) {
    if (k == index) continue;
    const bool isCurve = std::find(curveInks.begin(), curveInks.end(), k) != curveInks.end();
    Plane& target = isCurve ? field.otherCurves : field.clutter;
    const Plane& source = plot.coverage.ink[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < source.values.size(); ++i)
      target.values[i] = std::min(1.0F, target.values[i] + source.values[i]);
  }
  for (std::size_t i = 0; i < plot.text.mask.size(); ++i)
    if (plot.text.mask[i]) {
      // Letters' edges have any colour (sub-pixel rendering); only a pixel full of the ink is believed.
      if (field.own.values[i] < 0.85F) field.own.values[i] = 0;
      field.otherCurves.values[i] = 0;
      field.clutter.values[i] = 1 - std::min(1.0F, field.own.values[i]);
    }
  for (const LegendSample& sample : plot.samples)
    for (int y = static_cast<int>(sample.box.y0) - 1; y <= static_cast<int>(sample.box.y1); ++y)
      for (int x = static_cast<int>(sample.box.x0) - 1; x <= static_cast<int>(sample.box.x1); ++x)
        if (field.own.inside(x, y)) field.own.at(x, y) = 0;
  for (std::size_t i = 0; i < plot.masked.size(); ++i)
    if (plot.masked[i]) field.own.values[i] = field.otherCurves.values[i] = 0;
  return field;
}

bool isNeutral(const PlotInks& plot, int index) {
  const Ink& ink = plot.palette[static_cast<std::size_t>(index)];
  const Color3 full = plot.backdrop.paper() + ink.difference();
  const float chroma = std::max({full.r, full.g, full.b}) - std::min({full.r, full.g, full.b});
  return chroma <= kGreyChroma || dot(ink.direction, plot.backdrop.lineDirection()) > 0.985F;
}

std::vector<CurveInk> chooseCurveInks(const PlotInks& plot) {
  std::vector<CurveInk> found;
  std::vector<int> neutral;
  for (int k = 0; k < static_cast<int>(plot.palette.size()); ++k) {
    if (isNeutral(plot, k)) {
      neutral.push_back(k);
    } else if (auto curve = curveOf(plot, k, false)) {
      found.push_back(std::move(*curve));
    }
  }
  std::sort(found.begin(), found.end(),
            [](const CurveInk& a, const CurveInk& b) { return a.course.gain_px > b.course.gain_px; });
  std::vector<CurveInk> curves;
  for (CurveInk& curve : found)
    if (!isSeam(curve, curves, plot.coverage.unknown)) curves.push_back(std::move(curve));
  if (curves.size() != 1 || curves.front().secondStrand > 0.3) return curves;
  for (int k : neutral) {
    auto curve = curveOf(plot, k, true);
    // A lone coloured curve may have its partner in the ink of the frame; a leader or a callout is much shorter.
    if (curve && curve->course.span_px >= 0.5 * curves.front().course.span_px &&
        curve->course.gain_px >= 0.4 * curves.front().course.gain_px) {
      curves.push_back(std::move(*curve));
      break;
    }
  }
  return curves;
}

}  // namespace detent::importer::inks
