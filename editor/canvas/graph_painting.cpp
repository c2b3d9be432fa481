// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/graph_painting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <QCoreApplication>
#include <QFontMetricsF>

#include "editor/canvas/curve_path.h"
#include "editor/document/message_words.h"
#include "editor/quantity/reading_error.h"

namespace detent::editor {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("GraphPainting", text); }

// With more knots they are drawn small, because circles would hide the curve and cost time.
constexpr std::size_t fewKnots = 120;
constexpr std::size_t fewFlags = 4;  // with more valleys than this, their labels would cover the curve
constexpr double longestResidual_px = 60;

QColor withAlpha(QColor color, double alpha) {
  color.setAlphaF(static_cast<float>(alpha));
  return color;
}

QPointF pixelOf(const PlotMapping& map, CurvePoint at) { return map.toPixel(at.displacement_mm, at.force_N); }

// ---- background

const QColor& shadeOf(SectionKind kind, const GraphColors& colors) {
  switch (kind) {
    case SectionKind::slope:
      return colors.slopeSection;
    case SectionKind::jump:
      return colors.jumpSection;
    case SectionKind::bottomOut:
      return colors.bottomOutSection;
  }
  return colors.slopeSection;
}

// Shades the area under the press curve by section.
void shadePress(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const double base_px = std::clamp(map.toPixel(0, 0).y(), map.clip_px.top(), map.clip_px.bottom());
  for (const Section& section : scene.values.press.sections) {
    if (section.from_mm == section.to_mm) continue;
    QPolygonF area = curveOutline(scene.state.graph.press(), section.from_mm, section.to_mm, map);
    if (area.size() < 2) continue;
    area.push_back({area.back().x(), base_px});
    area.push_back({area.front().x(), base_px});
    painter.setBrush(shadeOf(section.kind, scene.colors));
    painter.drawPolygon(area);
  }
}

// Shades the area between the curve and the horizontal through the jump's tactile point: Kim & Lee's
// measure of the jump's strength.
void shadeJumpAreas(QPainter& painter, const PlotMapping& map, const GraphScene& scene, Stroke stroke) {
  for (const Section& section : scene.values.of(stroke).sections) {
    if (section.kind != SectionKind::jump) continue;
    QPolygonF area = curveOutline(scene.state.graph.curve(stroke), section.from_mm, section.to_mm, map);
    if (area.size() < 2) continue;
    const double level_px = map.toPixel(section.from_mm, section.fromForce_N).y();
    for (QPointF& p : area)  // a vertical piece at the jump's end rises above the level
      p.setY(stroke == Stroke::press ? std::max(p.y(), level_px) : std::min(p.y(), level_px));
    area.push_back({area.back().x(), level_px});
    area.push_back({area.front().x(), level_px});
    painter.setBrush(withAlpha(scene.colors.jumpSection, scene.colors.jumpSection.alphaF() * 1.4));
    painter.drawPolygon(area);
    painter.setPen(QPen(withAlpha(scene.colors.tactilePoint, 0.6), 1, Qt::DotLine));
    painter.drawLine(QPointF(area.front().x(), level_px), QPointF(area[area.size() - 3].x(), level_px));
    painter.setPen(Qt::NoPen);
  }
}

// Draws the end of the travel as a line with hatching behind it, as in mechanical drawings.
void paintBottomOut(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const double at_px = map.toPixel(scene.state.graph.travel_mm(), 0).x();
  const QRectF& clip = map.clip_px;
  if (at_px < clip.left() - 1 || at_px > clip.right() + 1) return;
  painter.setPen(QPen(scene.colors.bottomOut, 1.5));
  painter.drawLine(QPointF(at_px, clip.top()), QPointF(at_px, clip.bottom()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(QBrush(withAlpha(scene.colors.bottomOut, 0.3), Qt::BDiagPattern));
  painter.drawRect(QRectF(at_px, clip.top(), 6, clip.height()));
}

constexpr double bandOpacity = 0.22, referenceOpacity = 0.7;

void drawPolylines(QPainter& painter, const std::vector<QPolygonF>& lines) {
  for (const QPolygonF& line : lines) painter.drawPolyline(line);
}

QPen strokePen(Stroke stroke, const GraphColors& colors, double width) {
  QPen pen(stroke == Stroke::press ? colors.press : colors.release, width);
  pen.setJoinStyle(Qt::MiterJoin);  // round joins cost twice as much and are equal at these angles
  pen.setCapStyle(Qt::FlatCap);
  if (stroke == Stroke::release) pen.setDashPattern({7, 3});
  return pen;
}

/// The strokes of a graph, the dashed release on top, so that both are seen in their common bottom-out;
/// `penOf` gives their pens, Qt::NoPen for one that is not drawn.
template <class PenOf>
void drawStrokes(QPainter& painter, const PlotMapping& map, const ForceGraph& graph, const PenOf& penOf) {
  painter.setBrush(Qt::NoBrush);
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && !graph.release()) continue;
    const QPen pen = penOf(stroke);
    if (pen.style() == Qt::NoPen) continue;
    painter.setPen(pen);
    drawPolylines(painter, curvePolylines(graph.curve(stroke), map));
  }
}

// Draws the other state, or the strokes that a drag has changed as they were before.
void paintGhost(QPainter& painter, const PlotMapping& map, const GraphScene& scene, const ForceGraph& graph) {
  drawStrokes(painter, map, graph, [&](Stroke stroke) {
    const bool has = stroke == Stroke::press || scene.state.graph.release();
    if (has && graph.curve(stroke) == scene.state.graph.curve(stroke)) return QPen(Qt::NoPen);
    QPen pen = strokePen(stroke, scene.colors, 1);  // Qt draws wider translucent lines 18 times as slowly
    pen.setColor(withAlpha(pen.color(), 0.6));
    return pen;
  });
}

void paintReference(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  drawStrokes(painter, map, scene.reference->state.graph, [&](Stroke stroke) {
    QPen pen = strokePen(stroke, scene.colors, 2);
    pen.setColor(withAlpha(scene.colors.resetPoint, referenceOpacity));  // the page's own curves are grey
    return pen;
  });
}

// Thin, in the strokes' colours: the graphs at other speeds are shown only for comparison with the edited
// one.
void paintOtherSpeeds(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const auto thin = [&](Stroke stroke) { return strokePen(stroke, scene.colors, 1); };
  for (const SpeedGraph& other : scene.state.otherSpeeds) drawStrokes(painter, map, other.graph, thin);
}

// Places each label at the displacement at which its press is farthest from the edited one.
void paintSpeedLabels(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  constexpr int samples = 64;
  constexpr double beforeBottomOut = 0.9;  // share of the travel
  const StrokeCurve& front = scene.state.graph.press();
  for (const SpeedGraph& other : scene.state.otherSpeeds) {
    const StrokeCurve& press = other.graph.press();
    double farthest_N = -1, at_mm = press.start_mm();
    for (int i = 1; i < samples; ++i) {
      const double here_mm = press.start_mm() + press.travel_mm() * beforeBottomOut * i / samples;
      const double apart_N = std::abs(press.force_N(here_mm) - front.force_N(here_mm));
      if (apart_N > farthest_N) farthest_N = apart_N, at_mm = here_mm;
    }
    paintTag(painter, map.toPixel(at_mm, press.force_N(at_mm)) + QPointF(0, -12),
             speedText(other.speed_mm_per_s), scene.colors.press, scene.colors.background, map.clip_px);
  }
}

// Draws the scatter of the units as a band behind the curves: one standard deviation on each side.
void paintSpread(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const auto band = [&](const ToleranceBand& points, const QColor& color) {
    QPolygonF outline;
    for (const BandPoint& point : points)
      outline.push_back(map.toPixel(point.displacement_mm, point.mean_N + point.sd_N));
    for (auto point = points.rbegin(); point != points.rend(); ++point)
      outline.push_back(map.toPixel(point->displacement_mm, point->mean_N - point->sd_N));
    painter.setBrush(withAlpha(color, bandOpacity));
    painter.drawPolygon(outline);
  };
  painter.setPen(Qt::NoPen);
  band(scene.spread->release, scene.colors.release);
  band(scene.spread->press, scene.colors.press);
}

void paintStrokes(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  drawStrokes(painter, map, scene.state.graph, [&](Stroke stroke) {
    return strokePen(stroke, scene.colors, stroke == Stroke::press ? 2.2 : 2);
  });
}

// Draws the preview in the selection colour, because it belongs to neither stroke yet.
void paintPreview(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  drawStrokes(painter, map, scene.preview->graph, [&](Stroke stroke) {
    return QPen(scene.colors.selection, stroke == Stroke::press ? 2 : 1.5, Qt::DashLine);
  });
}

// ---- residuals

double squared(QPointF v) { return v.x() * v.x() + v.y() * v.y(); }

QPointF nearestOnLine(QPointF p, QPointF a, QPointF b) {
  const QPointF along = b - a;
  const double length = squared(along);
  if (length == 0) return a;
  return a + std::clamp(QPointF::dotProduct(p - a, along) / length, 0.0, 1.0) * along;
}

// Nearest place on a line whose points run from left to right.
std::optional<QPointF> nearestOn(const QPolygonF& line, QPointF p) {
  if (line.size() < 2) return {};
  const auto leftOf = [](QPointF a, double x) { return a.x() < x; };
  const auto start = std::lower_bound(line.begin(), line.end(), p.x(), leftOf) - line.begin();
  QPointF best = line[std::min<qsizetype>(start, line.size() - 1)];
  double distance = squared(best - p);
  const auto tryLine = [&](qsizetype i) {
    const QPointF candidate = nearestOnLine(p, line[i], line[i + 1]);
    if (squared(candidate - p) >= distance) return;
    best = candidate;
    distance = squared(candidate - p);
  };
  for (qsizetype i = start; i + 1 < line.size(); ++i) {
    if (std::pow(std::max(0.0, line[i].x() - p.x()), 2) > distance) break;
    tryLine(i);
  }
  for (qsizetype i = std::min<qsizetype>(start, line.size() - 1) - 1; i >= 0; --i) {
    tryLine(i);
    if (std::pow(std::max(0.0, p.x() - line[i].x()), 2) > distance) break;
  }
  return best;
}

void paintResiduals(QPainter& painter, const PlotMapping& map, const StrokeCurve& curve,
                    std::span<const CurvePoint> traced, const QColor& color) {
  const std::vector<QPolygonF> lines = curvePolylines(curve, map);
  QPolygonF ends;
  QPointF last(-1e9, -1e9);
  for (const CurvePoint& point : traced) {
    const QPointF p = pixelOf(map, point);
    if (!map.clip_px.contains(p) || squared(p - last) < 9) continue;
    last = p;
    std::optional<QPointF> nearest;
    for (const QPolygonF& line : lines) {
      const auto candidate = nearestOn(line, p);
      if (candidate && (!nearest || squared(*candidate - p) < squared(*nearest - p))) nearest = candidate;
    }
    if (!nearest) continue;
    const QPointF off = p - *nearest;
    const double length = std::hypot(off.x(), off.y());
    // A long residual is enlarged less, down to its own length.
    const double times = length > 0 ? std::clamp(longestResidual_px / length, 1.0, residualMagnification) : 0;
    ends << *nearest << *nearest + times * off;
  }
  painter.setPen(QPen(color, 1));
  for (qsizetype i = 0; i + 1 < ends.size(); i += 2) painter.drawLine(ends[i], ends[i + 1]);
}

// ---- marks

void paintKnots(QPainter& painter, const PlotMapping& map, const GraphScene& scene, Stroke stroke) {
  const std::vector<Knot>& knots = scene.state.graph.curve(stroke).knots();
  const QColor tagColor = stroke == Stroke::press ? scene.colors.press : scene.colors.release;
  QVector<QRectF> squares;
  const QRectF near = map.clip_px.adjusted(-4, -4, 4, 4);
  const double half = knots.size() > fewKnots ? 1.5 : 3;
  for (const Knot& k : knots) {
    const QPointF at = map.toPixel(k.displacement_mm, k.force_N);
    if (near.contains(at)) squares.push_back({at.x() - half, at.y() - half, 2 * half, 2 * half});
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, squares.size() <= qsizetype(fewKnots));
  painter.setPen(QPen(tagColor, knots.size() > fewKnots ? 1 : 1.4));
  painter.setBrush(scene.colors.background);
  painter.drawRects(squares);
  painter.restore();
}

void paintTurns(QPainter& painter, const PlotMapping& map, const GraphScene& scene, Stroke stroke) {
  const QColor tagColor = stroke == Stroke::press ? scene.colors.press : scene.colors.release;
  painter.setPen(QPen(tagColor, 1.5));
  painter.setBrush(scene.colors.background);
  for (const CurvePoint& turn : scene.values.of(stroke).turns) {
    const QPointF at = pixelOf(map, turn);
    if (map.clip_px.contains(at)) painter.drawEllipse(at, 4.2, 4.2);
  }
}

// Digits of a number on the curve, few enough to be compared at a glance.
constexpr int shownDigits = 4;

QString shortForce(double force_N, const GraphScene& scene) {
  return readText(force_N, Quantity::force, scene.units, scene.readingError, shownDigits) +
         QStringLiteral("\u2009") + scene.units.forceSymbol();
}

// "55 cN at 1.25 mm".
QString shortPlace(CurvePoint at, const GraphScene& scene) {
  return tr("%1 at %2")
      .arg(shortForce(at.force_N, scene),
           readText(at.displacement_mm, Quantity::length, scene.units, scene.readingError, 3) +
               QStringLiteral("\u2009") + scene.units.lengthSymbol());
}

/// A label's box, moved into the plot.
QRectF keptInside(QRectF box, const QRectF& bounds_px) {
  const QRectF inside = bounds_px.adjusted(3, 3, -3, -3);
  if (box.right() > inside.right()) box.moveRight(inside.right());
  if (box.left() < inside.left()) box.moveLeft(inside.left());
  if (box.bottom() > inside.bottom()) box.moveBottom(inside.bottom());
  if (box.top() < inside.top()) box.moveTop(inside.top());
  return box;
}

QRectF tagBox(const QPainter& painter, QPointF at_px, const QString& text, const QRectF& bounds_px) {
  const QFontMetricsF metrics(painter.font());
  const double width = std::min(metrics.boundingRect(text).width() + 10, 0.8 * bounds_px.width());
  QRectF box = metrics.boundingRect(QRectF(0, 0, width, 1000), Qt::AlignCenter | Qt::TextWordWrap, text)
                   .adjusted(-5, -2, 5, 2);
  box.moveCenter(at_px);
  return keptInside(box, bounds_px);
}

void paintTagIn(QPainter& painter, const QRectF& box, const QString& text, const QColor& tagColor,
                const QColor& background) {
  painter.save();
  painter.setPen(Qt::NoPen);
  painter.setBrush(withAlpha(background, 0.85));
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(tagColor);
  painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, text);
  painter.restore();
}

constexpr double tactileMark_px = 6.5, contactMark_px = 6;  // half the size of the marks
// distance of a tactile point's force label from the point
constexpr double tagAway_px = 20;
constexpr double bubbleAway_px = 38;  // distance of a label with two or three lines
constexpr double measureGap_px = 8;   // distance between a measured line and its label

/// Points on both strokes, close enough to tell whether a label covers them.
std::vector<QPointF> strokePoints_px(const PlotMapping& map, const GraphScene& scene) {
  constexpr int samples = 80;
  std::vector<QPointF> points;
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && !scene.state.graph.release()) continue;
    const StrokeCurve& curve = scene.state.graph.curve(stroke);
    for (int i = 0; i <= samples; ++i) {
      const double at_mm = curve.start_mm() + curve.travel_mm() * i / samples;
      points.push_back(map.toPixel(at_mm, curve.forceBefore_N(at_mm)));
    }
  }
  return points;
}

/// The points of the strokes, of their steep stretches as well, and those of the line at the end of the
/// travel.
std::vector<QPointF> withSteepLines(std::vector<QPointF> points_px, const PlotMapping& map,
                                    const GraphScene& scene) {
  constexpr double apart_px = 4;  // far less than the height of a label
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && !scene.state.graph.release()) continue;
    const StrokeCurve& curve = scene.state.graph.curve(stroke);
    const QPolygonF line = curveOutline(curve, curve.start_mm(), curve.end_mm(), map);
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
      const QLineF part(line[i], line[i + 1]);
      const int steps = 1 + static_cast<int>(part.length() / apart_px);
      for (int k = 0; k < steps; ++k) points_px.push_back(part.pointAt(static_cast<double>(k) / steps));
    }
  }
  const double end_px = map.toPixel(scene.state.graph.travel_mm(), 0).x();
  for (double y = map.clip_px.top(); y < map.clip_px.bottom(); y += apart_px)
    points_px.emplace_back(end_px, y);
  return points_px;
}

int pointsIn(const QRectF& box, const std::vector<QPointF>& points_px) {
  return static_cast<int>(std::ranges::count_if(points_px, [&](QPointF at) { return box.contains(at); }));
}

/// Labels beside marks. No label covers a mark or another label: a later one goes to the next free place, if
/// possible beside the strokes, and is left out if no place near is free.
class Tags {
 public:
  Tags(QPainter& painter, const PlotMapping& map, const GraphScene& scene,
       const std::vector<QPointF>& strokes_px)
      : painter_(painter), map_(map), scene_(scene), strokes_px_(strokes_px) {}

  void keepClear(const QRectF& box) { taken_.push_back(box); }
  void keepClear(QPointF mark_px, double half_px) {
    keepClear(QRectF(mark_px - QPointF(half_px, half_px), 2 * QSizeF(half_px, half_px)));
  }

  void put(QPointF at_px, const QString& text, const QColor& tagColor, std::optional<MarkId> mark = {}) {
    const QRectF wished = tagBox(painter_, at_px, text, map_.clip_px);
    std::optional<QRectF> freeBox;  // of the free places that cover least of the strokes, the nearest
    int least = std::numeric_limits<int>::max();
    for (const QPointF& away : placesAround(wished.size())) {
      const QRectF moved = keptInside(wished.translated(away), map_.clip_px);
      if (!free(moved)) continue;
      const int covered = pointsIn(moved, strokes_px_);
      if (covered < least) least = covered, freeBox = moved;
      if (least == 0) break;
    }
    if (!freeBox) return;
    const QRectF box = *freeBox;
    taken_.push_back(box);
    if (mark && scene_.flags) scene_.flags->push_back({box, *mark});
    paintTagIn(painter_, box, text, tagColor, scene_.colors.background);
  }

 private:
  /// Places around a mark, nearest first.
  static std::vector<QPointF> placesAround(QSizeF size) {
    std::vector<QPointF> offsets;
    for (const double lines : {0, 1, -1, 2, -2, 3, -3})
      for (const double sideways : {0, 1, -1, 2, -2})
        offsets.emplace_back(sideways * (size.width() / 2 + 2 * tactileMark_px), lines * size.height());
    std::ranges::stable_sort(offsets, {}, [](QPointF away) { return QPointF::dotProduct(away, away); });
    return offsets;
  }
  bool free(const QRectF& box) const {
    return std::none_of(taken_.begin(), taken_.end(),
                        [&](const QRectF& other) { return other.intersects(box); });
  }

  QPainter& painter_;
  const PlotMapping& map_;
  const GraphScene& scene_;
  const std::vector<QPointF>& strokes_px_;
  std::vector<QRectF> taken_;
};

void paintTactilePoints(QPainter& painter, const PlotMapping& map, const GraphScene& scene, Stroke stroke) {
  for (const TactilePoint& point : scene.values.of(stroke).tactile) {
    const QPointF at = map.toPixel(point.displacement_mm, point.force_N);
    if (!map.clip_px.contains(at)) continue;
    painter.setPen(QPen(scene.colors.background, 1.5));
    painter.setBrush(scene.colors.tactilePoint);
    const double r = tactileMark_px;
    painter.drawPolygon(
        QPolygonF({{at.x(), at.y() - r}, {at.x() + r, at.y()}, {at.x(), at.y() + r}, {at.x() - r, at.y()}}));
  }
}

// Leaves out dragged points, whose position is shown beside them.
void tagTactilePoints(Tags& tags, const PlotMapping& map, const GraphScene& scene, Stroke stroke) {
  const auto& dragged = scene.feedback.dragged;
  const std::vector<TactilePoint>& points = scene.values.of(stroke).tactile;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint place{points[i].displacement_mm, points[i].force_N};
    const QPointF at = pixelOf(map, place);
    if ((dragged && *dragged == place) || !map.clip_px.contains(at)) continue;
    tags.put(at + QPointF(0, stroke == Stroke::press ? -tagAway_px : tagAway_px), shortPlace(place, scene),
             scene.colors.text, MarkId{MarkKind::tactilePoint, stroke, i});
  }
}

// The lowest point after each tactile point of the press, and the start of its bottom-out.
void tagTurnsAndBottomOut(Tags& tags, const PlotMapping& map, const GraphScene& scene) {
  const auto& dragged = scene.feedback.dragged;
  const auto put = [&](CurvePoint point, MarkId mark) {
    const QPointF at = pixelOf(map, point);
    if ((dragged && *dragged == point) || !map.clip_px.contains(at)) return;
    tags.put(at + QPointF(0, tagAway_px), shortPlace(point, scene), scene.colors.text, mark);
  };
  const StrokeValues& press = scene.values.press;
  for (std::size_t i = 0; i < press.turns.size(); ++i) {
    const CurvePoint& turn = press.turns[i];
    const bool afterPeak = std::ranges::any_of(press.tactile, [&](const TactilePoint& peak) {
      return peak.displacement_mm < turn.displacement_mm && peak.force_N > turn.force_N;
    });
    if (afterPeak) put(turn, {MarkKind::turn, Stroke::press, i});
  }
  const std::vector<Knot>& knots = scene.state.graph.press().knots();
  for (const Section& section : press.sections) {
    if (section.kind != SectionKind::bottomOut) continue;
    const CurvePoint start{section.from_mm, section.fromForce_N};
    for (std::size_t i = 0; i < knots.size(); ++i)
      if (knots[i].displacement_mm == start.displacement_mm && knots[i].force_N == start.force_N)
        put(start, {MarkKind::knot, Stroke::press, i});
  }
}

/// A point at which a contact closes (press) or opens (release).
struct Contact {
  Stroke stroke;
  CurvePoint at;
  QPointF at_px;
  QColor color;
  bool operating() const { return stroke == Stroke::press; }
};

std::vector<Contact> contactsIn(const PlotMapping& map, const GraphScene& scene) {
  std::vector<Contact> contacts;
  const auto add = [&](const std::optional<double>& at_mm, Stroke stroke, const QColor& color) {
    if (!at_mm) return;
    const CurvePoint place{*at_mm, scene.state.graph.curve(stroke).force_N(*at_mm)};
    const QPointF at = pixelOf(map, place);
    if (at.x() >= map.clip_px.left() && at.x() <= map.clip_px.right())
      contacts.push_back({stroke, place, at, color});
  };
  add(scene.state.operatingPoint_mm, Stroke::press, scene.colors.operatingPoint);
  add(scene.state.resetPoint_mm, Stroke::release, scene.colors.resetPoint);
  return contacts;
}

// A thin line through the plot and a marker on its stroke.
void paintContact(QPainter& painter, const PlotMapping& map, const GraphScene& scene,
                  const Contact& contact) {
  const auto& [stroke, place, at, color] = contact;
  painter.setPen(QPen(withAlpha(color, 0.75), 1, Qt::DashDotLine));
  painter.drawLine(QPointF(at.x(), map.clip_px.bottom()), at);
  painter.setPen(QPen(scene.colors.background, 1.5));
  painter.setBrush(color);
  const double r = contactMark_px;
  const double up = contact.operating() ? 1 : -1;  // points down where the contact closes, up where it opens
  painter.drawPolygon(QPolygonF(
      {{at.x() - r, at.y() - up * r}, {at.x() + r, at.y() - up * r}, {at.x(), at.y() + up * 0.9 * r}}));
}

MarkId markOf(const Contact& contact) {
  return {contact.operating() ? MarkKind::operatingPoint : MarkKind::resetPoint, contact.stroke, 0};
}

// A dimension line as in mechanical drawings, above the axis. Its label and its arrow at `to` move that
// contact.
void paintDimension(Tags& tags, QPainter& painter, const PlotMapping& map, const GraphScene& scene,
                    const QString& name, double from_mm, const Contact& to, double aboveAxis_px) {
  constexpr double arrow_px = 7, extension_px = 5, least_px = 3 * arrow_px, reach_px = 9;
  const double y = map.clip_px.bottom() - aboveAxis_px;
  const QPointF a(map.toPixel(from_mm, 0).x(), y), b(to.at_px.x(), y);
  const double way_px = b.x() - a.x();
  if (std::abs(way_px) < least_px) return;
  const double forward = way_px > 0 ? 1 : -1;
  painter.setPen(QPen(to.color, 1));
  painter.setBrush(to.color);
  painter.drawLine(a, b);
  painter.drawLine(a - QPointF(0, extension_px), a + QPointF(0, extension_px));
  for (const auto& [tip, way] : {std::pair{a, forward}, std::pair{b, -forward}}) {
    const QPointF back(way * arrow_px, arrow_px / 3);
    painter.drawPolygon(QPolygonF({tip, tip + back, tip + QPointF(back.x(), -back.y())}));
  }
  if (scene.flags)
    scene.flags->push_back({QRectF(b.x() - reach_px, y - reach_px, 2 * reach_px, 2 * reach_px), markOf(to)});
  const QString length = readText(std::abs(to.at.displacement_mm - from_mm), Quantity::length, scene.units,
                                  scene.readingError, shownDigits);
  tags.put((a + b) / 2, tr("%1 %2").arg(name, length + QStringLiteral("\u2009") + scene.units.lengthSymbol()),
           to.color, markOf(to));
}

std::vector<TactilePoint> tactilePointsIn(const PlotMapping& map, const GraphScene& scene, Stroke stroke) {
  std::vector<TactilePoint> seen;
  if (stroke == Stroke::press || scene.state.graph.release())
    std::ranges::copy_if(scene.values.of(stroke).tactile, std::back_inserter(seen),
                         [&](const TactilePoint& p) {
                           return map.clip_px.contains(map.toPixel(p.displacement_mm, p.force_N));
                         });
  return seen;
}

constexpr QSizeF legendGap_px{14, 8};  // distance to the plot's edges
constexpr double legendText_px = 35;   // distance from the key's left end

struct LegendEntry {
  QString name;
  QPen pen;
};

/// Entries of the legend; empty for a single stroke.
std::vector<LegendEntry> legendOf(const QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  constexpr double longestName = 0.4;  // of the plot's width
  std::vector<LegendEntry> entries;
  const auto stroke = [&](const QString& name, Stroke which) {
    entries.push_back({name, strokePen(which, scene.colors, 2)});
  };
  if (scene.state.graph.release() || scene.spread || scene.reference) stroke(tr("press"), Stroke::press);
  if (scene.state.graph.release()) stroke(tr("release"), Stroke::release);
  if (scene.spread)
    entries.push_back({tr("specimens ± standard deviation"),
                       QPen(withAlpha(scene.colors.press, bandOpacity), 8, Qt::SolidLine, Qt::FlatCap)});
  if (scene.reference)
    entries.push_back(
        {QFontMetricsF(painter.font())
             .elidedText(scene.reference->name, Qt::ElideMiddle, longestName * map.clip_px.width()),
         QPen(withAlpha(scene.colors.resetPoint, referenceOpacity), 2)});
  return entries;
}

/// The box in the corner that covers the fewest points of the strokes.
QRectF legendBox(const QPainter& painter, const PlotMapping& map, const std::vector<LegendEntry>& entries,
                 const std::vector<QPointF>& strokes_px) {
  const QFontMetricsF metrics(painter.font());
  double text_px = 0;
  for (const LegendEntry& entry : entries) text_px = std::max(text_px, metrics.horizontalAdvance(entry.name));
  QRectF box({},
             QSizeF(legendText_px + text_px, static_cast<double>(entries.size()) * (metrics.height() + 2)));
  const QRectF within = map.clip_px.adjusted(legendGap_px.width(), legendGap_px.height(),
                                             -legendGap_px.width(), -legendGap_px.height());
  box.moveTopLeft(within.topLeft());
  QRectF best = box;
  int least = pointsIn(box, strokes_px);
  const auto move = [&](void (QRectF::*to)(const QPointF&), const QPointF& corner) {
    (box.*to)(corner);
    if (const int covered = pointsIn(box, strokes_px); covered < least) least = covered, best = box;
  };
  move(&QRectF::moveBottomRight, within.bottomRight());
  move(&QRectF::moveTopRight, within.topRight());
  move(&QRectF::moveBottomLeft, within.bottomLeft());
  return best;
}

// Forces are tagged first, because they belong beside their points; a contact's name may be anywhere on its
// line.
void paintTags(QPainter& painter, const PlotMapping& map, const GraphScene& scene,
               const std::vector<Contact>& contacts, const std::vector<QPointF>& strokes_px,
               const std::vector<QRectF>& kept) {
  Tags tags(painter, map, scene, strokes_px);
  const auto press = tactilePointsIn(map, scene, Stroke::press);
  const auto release = tactilePointsIn(map, scene, Stroke::release);
  const bool legible = press.size() + release.size() <= fewKnots;
  if (legible)
    for (const auto* points : {&press, &release})
      for (const TactilePoint& point : *points)
        tags.keepClear(map.toPixel(point.displacement_mm, point.force_N), tactileMark_px);
  for (const Contact& contact : contacts) tags.keepClear(contact.at_px, contactMark_px);
  for (const QRectF& box : kept) tags.keepClear(box);
  if (legible) {
    if (scene.state.graph.release()) tagTactilePoints(tags, map, scene, Stroke::release);
    tagTactilePoints(tags, map, scene, Stroke::press);
    if (scene.values.press.turns.size() <= fewFlags) tagTurnsAndBottomOut(tags, map, scene);
  }
  constexpr double aboveAxis_px = 12, lineAbove_px = 30;
  for (const Contact& contact : contacts)
    tags.put({contact.at_px.x(), map.clip_px.bottom() - (contact.operating() ? aboveAxis_px : lineAbove_px)},
             (contact.operating() ? tr("operating %1") : tr("reset %1")).arg(shortPlace(contact.at, scene)),
             contact.color, markOf(contact));
  // heights of the dimension lines, above the labels of the contacts
  constexpr double preTravel_px = 52, differential_px = 74;
  if (!scene.handlesShown) return;
  for (const Contact& contact : contacts) {
    if (contact.operating())
      paintDimension(tags, painter, map, scene, tr("pre-travel"), 0, contact, preTravel_px);
    else if (scene.state.operatingPoint_mm)
      paintDimension(tags, painter, map, scene, tr("differential"), *scene.state.operatingPoint_mm, contact,
                     differential_px);
  }
}

void paintSlopeHandles(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  if (scene.selection.size() != 1) return;
  const MarkId id = scene.selection.front();
  if (id.kind != MarkKind::knot && !isSlope(id.kind)) return;
  const StrokeCurve& curve = scene.state.graph.curve(id.stroke);
  if (id.index >= curve.knots().size()) return;
  const Knot& k = curve.knots()[id.index];
  const QPointF at = map.toPixel(k.displacement_mm, k.force_N);
  const SlopeHandles handles = slopeHandlesOf(curve, id.index, map);
  for (const auto& [end, kind] : {std::pair{handles.before_px, MarkKind::slopeBefore},
                                  std::pair{handles.after_px, MarkKind::slopeAfter}}) {
    if (!end) continue;
    painter.setPen(QPen(scene.colors.selection, 1.2));
    painter.drawLine(at, *end);
    painter.setBrush(id.kind == kind ? scene.colors.selection : scene.colors.background);
    painter.drawEllipse(*end, 4, 4);
  }
}

void paintSectionOutline(QPainter& painter, const PlotMapping& map, const GraphScene& scene, MarkId id,
                         double alpha) {
  const std::vector<Section>& sections = scene.values.of(id.stroke).sections;
  if (id.index >= sections.size()) return;
  const Section& section = sections[id.index];
  const QPolygonF line =
      curveOutline(scene.state.graph.curve(id.stroke), section.from_mm, section.to_mm, map);
  painter.setPen(
      QPen(withAlpha(scene.colors.selection, alpha), 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(line);
}

void paintHighlight(QPainter& painter, const PlotMapping& map, const GraphScene& scene, MarkId id,
                    bool selected) {
  if (id.kind == MarkKind::section) {
    paintSectionOutline(painter, map, scene, id, selected ? 0.3 : 0.15);
    return;
  }
  const auto at = placeOf(id, scene.state, scene.values);
  if (!at || isSlope(id.kind)) return;
  painter.setPen(QPen(withAlpha(scene.colors.selection, selected ? 1 : 0.5), selected ? 2 : 1.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(pixelOf(map, *at), 10, 10);
}

void paintMarks(QPainter& painter, const PlotMapping& map, const GraphScene& scene,
                const std::vector<QPointF>& strokes_px, const std::vector<QRectF>& kept) {
  const ButtonState& state = scene.state;
  for (const Stroke stroke : {Stroke::release, Stroke::press}) {
    if (stroke == Stroke::release && !state.graph.release()) continue;
    if (scene.handlesShown) {
      paintKnots(painter, map, scene, stroke);
      if (scene.values.of(stroke).turns.size() <= fewKnots) paintTurns(painter, map, scene, stroke);
    }
  }
  const std::vector<Contact> contacts = contactsIn(map, scene);
  for (const Contact& contact : contacts) paintContact(painter, map, scene, contact);
  for (const Stroke stroke : {Stroke::release, Stroke::press})
    if (stroke == Stroke::press || state.graph.release()) paintTactilePoints(painter, map, scene, stroke);
  paintTags(painter, map, scene, contacts, strokes_px, kept);
}

// ---- feedback

QString snapText(SnapKind kind) {
  switch (kind) {
    case SnapKind::grid:
      return tr("grid");
    case SnapKind::tracedPoint:
      return tr("traced point");
    case SnapKind::otherStroke:
      return tr("other stroke");
  }
  return {};
}

void paintSnap(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const QPointF at = pixelOf(map, scene.feedback.snap->at);
  painter.setPen(QPen(scene.colors.operatingPoint, 1.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(at.x() - 7, at.y() - 7, 14, 14));
  painter.setPen(QPen(withAlpha(scene.colors.operatingPoint, 0.5), 1, Qt::DashLine));
  painter.drawLine(QPointF(map.clip_px.left(), at.y()), QPointF(map.clip_px.right(), at.y()));
  painter.drawLine(QPointF(at.x(), map.clip_px.top()), QPointF(at.x(), map.clip_px.bottom()));
  paintTag(painter, at + QPointF(0, 24), snapText(scene.feedback.snap->kind), scene.colors.operatingPoint,
           scene.colors.background, map.clip_px);
}

void paintRefusal(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const RefusedMove& refused = *scene.feedback.refused;
  const QPointF at = pixelOf(map, refused.wanted);
  painter.setPen(QPen(scene.colors.refused, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(at, 8, 8);
  painter.drawLine(at + QPointF(-5.6, -5.6), at + QPointF(5.6, 5.6));
  if (scene.feedback.dragged) {
    painter.setPen(QPen(scene.colors.refused, 1, Qt::DashLine));
    painter.drawLine(at, pixelOf(map, *scene.feedback.dragged));
  }
}

void paintProposal(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const Proposal& proposal = *scene.feedback.proposal;
  const QColor tagColor = proposal.stroke == Stroke::press ? scene.colors.press : scene.colors.release;
  const QPointF at = pixelOf(map, proposal.at);
  painter.setPen(QPen(tagColor, 1.6));
  painter.setBrush(withAlpha(tagColor, 0.25));
  painter.drawEllipse(at, 7, 7);
  painter.drawLine(at + QPointF(-3.5, 0), at + QPointF(3.5, 0));
  painter.drawLine(at + QPointF(0, -3.5), at + QPointF(0, 3.5));
  if (!proposal.to) return;
  painter.setPen(QPen(tagColor, 1, Qt::DashLine));
  painter.drawLine(at, pixelOf(map, *proposal.to));
}

void paintDragReadout(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const QPointF at = pixelOf(map, *scene.feedback.dragged);
  painter.setPen(QPen(withAlpha(scene.colors.selection, 0.35), 1));
  painter.drawLine(QPointF(map.clip_px.left(), at.y()), at);
  painter.drawLine(QPointF(at.x(), map.clip_px.bottom()), at);
  const auto changed = [&](double from, double to, Quantity quantity) {
    const QString now = quantityWithUnit(to, quantity, scene.units, shownDigits);
    const QString then = quantityText(from, quantity, scene.units, shownDigits);
    return then == quantityText(to, quantity, scene.units, shownDigits)
               ? now
               : then + QStringLiteral(" \u2192 ") + now;
  };
  const CurvePoint to = *scene.feedback.dragged, from = scene.feedback.draggedFrom.value_or(to);
  const QString lines = changed(from.displacement_mm, to.displacement_mm, Quantity::length) + u'\n' +
                        changed(from.force_N, to.force_N, Quantity::force);
  paintTag(painter, at + QPointF(0, -bubbleAway_px), lines, scene.colors.text, scene.colors.background,
           map.clip_px);
}

// Two places, the sides of the triangle between them, and its numbers.
void paintMeasurement(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const auto& [from, to] = *scene.feedback.measured;
  const QPointF a = pixelOf(map, from), b = pixelOf(map, to);
  painter.setPen(QPen(withAlpha(scene.colors.selection, 0.5), 1, Qt::DashLine));
  painter.drawLine(a, {b.x(), a.y()});
  painter.drawLine({b.x(), a.y()}, b);
  painter.setPen(QPen(scene.colors.selection, 1.5));
  painter.drawLine(a, b);
  painter.setBrush(scene.colors.background);
  for (const QPointF& end : {a, b}) painter.drawEllipse(end, 4, 4);
  const double along_mm = to.displacement_mm - from.displacement_mm, up_N = to.force_N - from.force_N;
  QStringList lines{
      QStringLiteral("\u0394 ") + quantityWithUnit(along_mm, Quantity::length, scene.units, shownDigits),
      QStringLiteral("\u0394 ") + quantityWithUnit(up_N, Quantity::force, scene.units, shownDigits)};
  if (along_mm != 0)
    lines << tr("slope %1").arg(quantityWithUnit(up_N / along_mm, Quantity::slope, scene.units, shownDigits));
  // The numbers are drawn in the corner of the triangle across its right angle, where they cover neither end.
  const QRectF box = tagBox(painter, a, lines.join(u'\n'), map.clip_px);
  const QPointF aside((b.x() < a.x() ? 1 : -1) * (box.width() / 2 + measureGap_px),
                      (b.y() < a.y() ? -1 : 1) * (box.height() / 2 + measureGap_px));
  paintTag(painter, QPointF((a.x() + b.x()) / 2, (a.y() + b.y()) / 2) + aside,
           lines.join(u'\n').replace('-', QChar(0x2212)), scene.colors.text, scene.colors.background,
           map.clip_px);
}

void paintFinger(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  const FingerPosition& finger = *scene.finger;
  const QPointF at = map.inClip(map.toPixel(finger.displacement_mm, finger.force_N));
  const QColor tagColor = finger.stroke == Stroke::press ? scene.colors.press : scene.colors.release;
  painter.setPen(QPen(withAlpha(tagColor, 0.5), 1));
  painter.drawLine(QPointF(at.x(), map.clip_px.bottom()), at);
  painter.setPen(QPen(scene.colors.background, 2));
  painter.setBrush(tagColor);
  painter.drawEllipse(at, 7, 7);
}

// The selection rectangle.
void paintBand(QPainter& painter, const GraphScene& scene) {
  painter.setPen(QPen(scene.colors.selection, 1, Qt::DashLine));
  painter.setBrush(withAlpha(scene.colors.selection, 0.08));
  painter.drawRect(*scene.feedback.band_px);
}

void paintFeedback(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  for (const MarkId& mark : scene.selection) paintHighlight(painter, map, scene, mark, true);
  const auto& hovered = scene.feedback.hovered;
  if (hovered && std::find(scene.selection.begin(), scene.selection.end(), *hovered) == scene.selection.end())
    paintHighlight(painter, map, scene, *scene.feedback.hovered, false);
  if (scene.handlesShown) paintSlopeHandles(painter, map, scene);
  if (scene.feedback.band_px) paintBand(painter, scene);
  if (scene.feedback.proposal) paintProposal(painter, map, scene);
  if (scene.feedback.snap) paintSnap(painter, map, scene);
  if (scene.feedback.dragged) paintDragReadout(painter, map, scene);
  if (scene.feedback.measured) paintMeasurement(painter, map, scene);
  if (scene.feedback.refused) paintRefusal(painter, map, scene);
}

// Screen position of a note or pin on its curve; nullopt if this state has no such stroke.
template <class At>
std::optional<QPointF> onCurve(const At& at, const PlotMapping& map, const GraphScene& scene) {
  const bool there = at.stroke == Stroke::press || scene.state.graph.release();
  if (at.state != scene.stateIndex || !there) return {};
  const StrokeCurve& curve = scene.state.graph.curve(at.stroke);
  const double x = std::clamp(at.displacement_mm, curve.start_mm(), curve.end_mm());
  return map.toPixel(x, curve.force_N(x));
}

// A numbered flag at the curve; short texts are also shown beside the flag. Returns the boxes of the flags.
std::vector<QRectF> paintNotes(QPainter& painter, const PlotMapping& map, const GraphScene& scene,
                               const std::vector<QPointF>& strokes_px) {
  // distance of the flag from the curve, beyond the force label of a tactile point; half of the flag's width
  constexpr double flag_px = 46, half_px = 8;
  constexpr double beside_px = 34;  // the flag and the margins of the text box
  constexpr int longest = 32, outside = 1000;
  std::vector<QRectF> flags;
  for (std::size_t i = 0; i < scene.notes.size(); ++i) {
    const auto at = onCurve(scene.notes[i], map, scene);
    if (!at) continue;
    const QFontMetricsF metrics(painter.font());
    const QString text = shortened(QString::fromStdString(scene.notes[i].text).simplified(), longest);
    const double left_px = at->x() - map.clip_px.left(), right_px = map.clip_px.right() - at->x();
    const QString words = metrics.elidedText(text, Qt::ElideRight, std::max(left_px, right_px) - beside_px);
    const double halfWidth_px = metrics.horizontalAdvance(words) / 2 + half_px + 8;
    // Above and to the right, unless that leaves the plot or covers more of the strokes.
    QPointF flag, middle;
    int least = std::numeric_limits<int>::max();
    for (const double up : {-1.0, 1.0})
      for (const double side : {1.0, -1.0}) {
        const QPointF there = *at + QPointF(0, up * flag_px),
                      text_px = there + QPointF(side * halfWidth_px, 0);
        const QRectF box(text_px - QPointF(halfWidth_px, metrics.height() / 2),
                         QSizeF(2 * halfWidth_px, metrics.height()));
        const bool inside = map.clip_px.contains(box);
        const int covered = pointsIn(box, strokes_px) + (inside ? 0 : outside);
        if (covered >= least) continue;
        least = covered;
        flag = there;
        middle = text_px;
      }
    painter.setPen(QPen(scene.colors.text, 1));
    painter.drawLine(*at, flag);
    painter.setBrush(scene.colors.background);
    painter.drawEllipse(flag, half_px, half_px);
    const QRectF inside(flag - QPointF(half_px, half_px), 2 * QSizeF(half_px, half_px));
    painter.drawText(inside, Qt::AlignCenter, QString::number(i + 1));
    paintTag(painter, middle, words, scene.colors.text, scene.colors.background, map.clip_px);
    flags.push_back(inside);
  }
  return flags;
}

void paintPins(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  for (const PinnedPoint& pin : scene.pinned) {
    const auto at = onCurve(pin, map, scene);
    if (!at) continue;
    painter.setPen(QPen(scene.colors.text, 1.6));
    painter.setBrush(scene.colors.refused);
    painter.drawLine(*at, *at + QPointF(6, -11));
    painter.drawEllipse(*at + QPointF(8, -14), 4, 4);
  }
}

// Names the line styles and returns the box of the names; draws nothing for a single stroke.
std::optional<QRectF> paintLegend(QPainter& painter, const PlotMapping& map, const GraphScene& scene,
                                  const std::vector<QPointF>& strokes_px) {
  const std::vector<LegendEntry> entries = legendOf(painter, map, scene);
  if (entries.empty()) return {};
  const QFontMetricsF metrics(painter.font());
  painter.setPen(scene.colors.grid);  // with its border, the gridlines behind it are seen to go on
  painter.setBrush(withAlpha(scene.colors.background, 0.85));
  const QRectF box = legendBox(painter, map, entries, strokes_px);
  painter.drawRoundedRect(box.adjusted(-6, -3, 6, 3), 3, 3);
  QPointF at = box.topLeft() + QPointF(0, metrics.height() / 2 + 1);
  for (const LegendEntry& entry : entries) {
    painter.setPen(entry.pen);
    painter.drawLine(at, at + QPointF(28, 0));
    painter.setPen(scene.colors.text);
    painter.drawText(at + QPointF(legendText_px, metrics.ascent() / 2 - 1), entry.name);
    at += QPointF(0, metrics.height() + 2);
  }
  return box;
}

}  // namespace

void paintTag(QPainter& painter, QPointF at_px, const QString& text, const QColor& tagColor,
              const QColor& background, const QRectF& bounds_px) {
  paintTagIn(painter, tagBox(painter, at_px, text, bounds_px), text, tagColor, background);
}

QString speedText(double speed_mm_per_s) { return tr("%1 mm/s").arg(numberText(speed_mm_per_s, 4)); }

void paintRefusalReason(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  // Placed beside the legend.
  const QRectF free = map.clip_px.adjusted(std::min(110.0, 0.2 * map.clip_px.width()), 0, 0, 0);
  paintTag(painter, QPointF(free.center().x(), free.top()), scene.feedback.refused->why, scene.colors.refused,
           scene.colors.background, free);
}

void paintCurves(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  painter.save();
  painter.setClipRect(map.clip_px, Qt::IntersectClip);
  painter.setPen(Qt::NoPen);
  // The edges of the shaded areas are vertical, horizontal, or under a curve, so they need no antialiasing.
  painter.setRenderHint(QPainter::Antialiasing, false);
  shadePress(painter, map, scene);
  shadeJumpAreas(painter, map, scene, Stroke::press);
  if (scene.state.graph.release()) shadeJumpAreas(painter, map, scene, Stroke::release);
  painter.setRenderHint(QPainter::Antialiasing, true);
  paintBottomOut(painter, map, scene);
  if (scene.spread) paintSpread(painter, map, scene);
  if (scene.reference) paintReference(painter, map, scene);
  if (scene.otherState) paintGhost(painter, map, scene, scene.otherState->graph);
  if (scene.before) paintGhost(painter, map, scene, scene.before->graph);
  paintOtherSpeeds(painter, map, scene);
  if (!scene.tracedPress.empty())
    paintResiduals(painter, map, scene.state.graph.press(), scene.tracedPress, scene.colors.residual);
  if (!scene.tracedRelease.empty() && scene.state.graph.release())
    paintResiduals(painter, map, *scene.state.graph.release(), scene.tracedRelease, scene.colors.residual);
  paintStrokes(painter, map, scene);
  if (scene.preview) paintPreview(painter, map, scene);
  painter.restore();
}

void paintGraph(QPainter& painter, const PlotMapping& map, const GraphScene& scene) {
  paintCurves(painter, map, scene);
  const std::vector<QPointF> strokes_px = strokePoints_px(map, scene);
  std::vector<QRectF> kept;  // free of labels
  if (!scene.notes.empty() || (scene.handlesShown && !scene.pinned.empty())) {
    painter.save();
    painter.setClipRect(map.clip_px, Qt::IntersectClip);
    kept = paintNotes(painter, map, scene, strokes_px);
    if (scene.handlesShown) paintPins(painter, map, scene);
    painter.restore();
  }
  painter.save();
  painter.setClipRect(map.clip_px, Qt::IntersectClip);
  if (const auto legend = paintLegend(painter, map, scene, strokes_px)) kept.push_back(*legend);
  paintSpeedLabels(painter, map, scene);
  paintMarks(painter, map, scene, withSteepLines(strokes_px, map, scene), kept);
  paintFeedback(painter, map, scene);
  painter.restore();
  if (scene.finger) paintFinger(painter, map, scene);  // whole, also at the edge
}

}  // namespace detent::editor
