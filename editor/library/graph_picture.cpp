// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/graph_picture.h"

#include <algorithm>
#include <QPainter>
#include <QPainterPath>

#include "model/check.h"
#include "model/sampling.h"

namespace detent::editor {
namespace {

constexpr double margin_px = 6;

// From mm and N to the picture; force upwards, the axes through 0 where it is in range.
struct Plane {
  double fromX_mm = 0, toX_mm = 1, fromF_N = 0, toF_N = 1;
  QSizeF size_px;

  QPointF at(const CurvePoint& p) const {
    const double x = (p.displacement_mm - fromX_mm) / (toX_mm - fromX_mm);
    const double y = (p.force_N - fromF_N) / (toF_N - fromF_N);
    return {margin_px + x * (size_px.width() - 2 * margin_px),
            size_px.height() - margin_px - y * (size_px.height() - 2 * margin_px)};
  }
};

Plane planeFor(const Button& button, QSizeF size_px) {
  Plane plane;
  plane.size_px = size_px;
  plane.toX_mm = 0;
  plane.toF_N = 0;
  for (const ButtonState& state : button.states())
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const StrokeCurve& curve = state.graph.curve(stroke);
      const auto [low, high] = curve.forceRange_N();
      plane.toX_mm = std::max(plane.toX_mm, curve.end_mm());
      plane.fromF_N = std::min(plane.fromF_N, low);
      plane.toF_N = std::max(plane.toF_N, high);
    }
  if (!(plane.toF_N > plane.fromF_N)) plane.toF_N = plane.fromF_N + 1;  // all forces are 0
  return plane;
}

// The line through the points, without those within half a pixel of the previous one: a hundred pixels need
// no thousands of samples.
QPainterPath pathOf(const std::vector<CurvePoint>& points, const Plane& plane) {
  QPainterPath path;
  QPointF last;
  for (const CurvePoint& point : points) {
    const QPointF at = plane.at(point);
    if (path.elementCount() == 0)  // isEmpty() holds after a moveTo too
      path.moveTo(at);
    else if (std::abs(at.x() - last.x()) < 0.5 && std::abs(at.y() - last.y()) < 0.5)
      continue;
    else
      path.lineTo(at);
    last = at;
  }
  return path;
}

}  // namespace

QImage graphPicture(const Button& button, QSize size_px, double devicePixelRatio, const GraphColors& colors) {
  DETENT_CHECK(size_px.width() >= 16 && size_px.height() >= 16 && devicePixelRatio > 0,
               "a graph picture has room for its margins");
  QImage image(size_px * devicePixelRatio, QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(devicePixelRatio);
  image.fill(colors.background);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  const Plane plane = planeFor(button, QSizeF(size_px));
  painter.setPen(QPen(colors.grid, 1));
  painter.drawLine(plane.at({plane.fromX_mm, 0}), plane.at({plane.toX_mm, 0}));
  painter.drawLine(plane.at({plane.fromX_mm, plane.fromF_N}), plane.at({plane.fromX_mm, plane.toF_N}));
  for (const ButtonState& state : button.states()) {
    if (state.graph.release()) {
      painter.setPen(QPen(colors.release, 1.4, Qt::DashLine));
      painter.drawPath(pathOf(travelledSamples(state.graph, Stroke::release), plane));
    }
    painter.setPen(QPen(colors.press, 1.8));
    painter.drawPath(pathOf(travelledSamples(state.graph, Stroke::press), plane));
  }
  return image;
}

}  // namespace detent::editor
