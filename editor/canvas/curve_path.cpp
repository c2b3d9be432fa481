// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/curve_path.h"

#include <algorithm>
#include <cmath>

namespace detent::editor {
namespace {

// One piece in Bézier form: displacement is linear in its parameter, so only forces curve.
struct Piece {
  double x0, x1;
  double f0, f1, f2, f3;

  Piece(const Knot& a, const Knot& b) : x0(a.displacement_mm), x1(b.displacement_mm) {
    const double third = (x1 - x0) / 3;
    f0 = a.force_N;
    f3 = b.force_N;
    f1 = f0 + third * a.slopeAfter_N_per_mm;
    f2 = f3 - third * b.slopeBefore_N_per_mm;
  }
  double force(double t) const {
    const double s = 1 - t;
    return s * s * s * f0 + 3 * s * s * t * f1 + 3 * s * t * t * f2 + t * t * t * f3;
  }
  // Number of chords: the distance of a cubic from n equal chords is at most 3/4 of its largest second
  // difference over n squared.
  int chords(double pxPerN, double share, double tolerance_px) const {
    const double bend = std::max(std::abs(f0 - 2 * f1 + f2), std::abs(f1 - 2 * f2 + f3)) * pxPerN;
    const double n = share * std::sqrt(0.75 * bend / tolerance_px);
    return std::isfinite(n) ? std::clamp(static_cast<int>(std::ceil(n)), 1, 4096) : 4096;
  }
};

// Appends the points of a curve between two displacements (including the first), in plot coordinates.
template <class Sink>
void flatten(const StrokeCurve& curve, double from_mm, double to_mm, double pxPerN, double tolerance_px,
             const Sink& put) {
  const std::vector<Knot>& knots = curve.knots();
  const auto before = [](double x, const Knot& k) { return x < k.displacement_mm; };
  // The last knot at or before `from`, but before a vertical piece exactly there.
  auto first = std::upper_bound(knots.begin(), knots.end(), from_mm, before);
  while (first != knots.begin() && (first - 1)->displacement_mm >= from_mm) --first;
  std::size_t i = first == knots.begin() ? 0 : static_cast<std::size_t>(first - knots.begin()) - 1;
  bool started = false;
  for (; i + 1 < knots.size(); ++i) {
    const Knot &a = knots[i], &b = knots[i + 1];
    if (a.displacement_mm > to_mm) break;
    if (b.displacement_mm < from_mm) continue;
    if (a.displacement_mm == b.displacement_mm) {  // a vertical piece
      if (!started) put(a.displacement_mm, a.force_N);
      put(b.displacement_mm, b.force_N);
      started = true;
      continue;
    }
    const Piece piece(a, b);
    const double width = piece.x1 - piece.x0;
    const double t0 = std::clamp((from_mm - piece.x0) / width, 0.0, 1.0);
    const double t1 = std::clamp((to_mm - piece.x0) / width, 0.0, 1.0);
    const int n = piece.chords(pxPerN, t1 - t0, tolerance_px);
    if (!started) put(t0 > 0 ? piece.x0 + t0 * width : piece.x0, t0 > 0 ? piece.force(t0) : piece.f0);
    started = true;
    for (int k = 1; k < n; ++k) {
      const double t = t0 + (t1 - t0) * k / n;
      put(piece.x0 + t * width, piece.force(t));
    }
    if (t1 >= 1)
      put(piece.x1, piece.f3);
    else
      put(to_mm, piece.force(t1));
  }
}

// Liang and Barsky: clips a line to a box; returns false if nothing remains.
bool clipLine(QPointF& a, QPointF& b, const QRectF& box) {
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  double t0 = 0, t1 = 1;
  const auto cut = [&](double p, double q) {
    if (p == 0) return q >= 0;
    const double t = q / p;
    if (p < 0) {
      if (t > t1) return false;
      t0 = std::max(t0, t);
    } else {
      if (t < t0) return false;
      t1 = std::min(t1, t);
    }
    return true;
  };
  if (!cut(-dx, a.x() - box.left()) || !cut(dx, box.right() - a.x()) || !cut(-dy, a.y() - box.top()) ||
      !cut(dy, box.bottom() - a.y()))
    return false;
  const QPointF start = a, by(dx, dy);
  if (t0 > 0) a = start + t0 * by;
  if (t1 < 1) b = start + t1 * by;
  return true;
}

// Leaves out points between which a straight line stays within the tolerance: from an anchor, a point is
// skipped as long as one direction misses no skipped point by more than the tolerance. Of a thousand knots on
// a smooth curve a few dozen remain.
class Simplifier {
 public:
  explicit Simplifier(double tolerance_px) : tolerance_px_(tolerance_px) {}

  template <class Sink>
  void add(QPointF point, const Sink& put) {
    if (!anchor_) {
      put(point);
      return startAt(point);
    }
    const QPointF way = point - *anchor_;
    const double length = std::hypot(way.x(), way.y());
    const bool onTheWay = !last_ || (length >= lastLength_ && inside(way));
    if (!onTheWay) {
      const QPointF corner = *last_;
      put(corner);
      startAt(corner);
      return add(point, put);
    }
    if (length > tolerance_px_) narrow(way, length);
    last_ = point;
    lastLength_ = length;
  }
  template <class Sink>
  void finish(const Sink& put) {
    if (last_) put(*last_);
  }

 private:
  static double cross(QPointF a, QPointF b) { return a.x() * b.y() - a.y() * b.x(); }

  void startAt(QPointF point) {
    anchor_ = point;
    last_.reset();
    low_.reset();
    high_.reset();
    lastLength_ = 0;
  }
  bool inside(QPointF way) const { return !low_ || (cross(*low_, way) >= 0 && cross(way, *high_) >= 0); }
  // Restricts the allowed directions to those that miss this point by at most the tolerance.
  void narrow(QPointF way, double length) {
    const QPointF aside = tolerance_px_ / length * QPointF(-way.y(), way.x());
    const QPointF low = way - aside, high = way + aside;
    if (!low_ || cross(*low_, low) > 0) low_ = low;
    if (!high_ || cross(high, *high_) > 0) high_ = high;
  }

  double tolerance_px_;
  std::optional<QPointF> anchor_, last_, low_, high_;
  double lastLength_ = 0;
};

// Joins clipped lines to polylines.
class PolylineClipper {
 public:
  explicit PolylineClipper(const QRectF& box) : box_(box) {}

  void add(QPointF point) {
    if (!std::isfinite(point.x()) || !std::isfinite(point.y())) return;
    if (!last_) {
      last_ = point;
      return;
    }
    // Distances below a third of a pixel are invisible.
    if (std::abs(point.x() - last_->x()) < 0.3 && std::abs(point.y() - last_->y()) < 0.3) {
      skipped_ = point;
      return;
    }
    skipped_.reset();
    line(*last_, point);
    last_ = point;
  }
  std::vector<QPolygonF> take() {
    if (last_ && skipped_) line(*last_, *skipped_);
    return std::move(polylines_);
  }

 private:
  void line(QPointF a, QPointF b) {
    const QPointF end = b;
    if (!clipLine(a, b, box_)) {
      open_ = false;
      return;
    }
    if (!open_) polylines_.push_back(QPolygonF{a});
    polylines_.back().push_back(b);
    open_ = b == end;
  }

  QRectF box_;
  std::optional<QPointF> last_, skipped_;
  std::vector<QPolygonF> polylines_;
  bool open_ = false;
};

QRectF withMargin(const QRectF& clip_px) {
  return clip_px.adjusted(-offscreenMargin_px, -offscreenMargin_px, offscreenMargin_px, offscreenMargin_px);
}

}  // namespace

std::vector<QPolygonF> curvePolylines(const StrokeCurve& curve, const PlotMapping& map, double tolerance_px) {
  const QRectF box = withMargin(map.clip_px);
  PolylineClipper clipper(box);
  // Half of the tolerance is for the curve's chords, half for leaving out points.
  Simplifier simplifier(0.5 * tolerance_px);
  const auto put = [&](QPointF point) { clipper.add(point); };
  flatten(curve, map.toPlot(box.topLeft()).x(), map.toPlot(box.topRight()).x(), map.pxPerY,
          0.5 * tolerance_px, [&](double x, double force) { simplifier.add(map.toPixel(x, force), put); });
  simplifier.finish(put);
  return clipper.take();
}

std::vector<QPolygonF> clippedPolylines(const QPolygonF& points_px, const QRectF& clip_px) {
  PolylineClipper clipper(withMargin(clip_px));
  for (const QPointF& point : points_px) clipper.add(point);
  return clipper.take();
}

QPolygonF curveOutline(const StrokeCurve& curve, double from_mm, double to_mm, const PlotMapping& map,
                       double tolerance_px) {
  const QRectF box = withMargin(map.clip_px);
  const double lower = std::max(std::min(from_mm, to_mm), map.toPlot(box.topLeft()).x());
  const double upper = std::min(std::max(from_mm, to_mm), map.toPlot(box.topRight()).x());
  QPolygonF outline;
  if (lower > upper) return outline;
  Simplifier simplifier(0.5 * tolerance_px);
  const auto put = [&](QPointF px) {
    outline.push_back({px.x(), std::clamp(px.y(), box.top(), box.bottom())});
  };
  flatten(curve, lower, upper, map.pxPerY, 0.5 * tolerance_px,
          [&](double x, double force) { simplifier.add(map.toPixel(x, force), put); });
  simplifier.finish(put);
  return outline;
}

}  // namespace detent::editor
