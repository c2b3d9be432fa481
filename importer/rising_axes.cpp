// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/rising_axes.h"

#include <algorithm>
#include <utility>

namespace detent::importer {
namespace {

/// A mirror of a picture's pixels; it is its own inverse.
struct Mirror {
  bool across = false, upsideDown = false;
  int width_px = 0, height_px = 0;

  Point operator()(Point p) const {
    return {across ? width_px - 1 - p.x : p.x, upsideDown ? height_px - 1 - p.y : p.y};
  }
  Box operator()(const Box& box) const {
    if (box.empty()) return box;
    const Point a = (*this)(Point{box.x0, box.y0}), b = (*this)(Point{box.x1, box.y1});
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
  }
  Homography map() const {
    const double sx = across ? -1 : 1, sy = upsideDown ? -1 : 1;
    return {{sx, 0, across ? width_px - 1.0 : 0, 0, sy, upsideDown ? height_px - 1.0 : 0, 0, 0, 1}};
  }
};

Raster seenIn(const Mirror& mirror, const Raster& picture) {
  Raster out = picture;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      const Point from = mirror(Point{double(x), double(y)});
      const std::uint8_t* const p = picture.at(static_cast<int>(from.x), static_cast<int>(from.y));
      std::copy(p, p + 3, out.rgb.data() + (out.at(x, y) - out.rgb.data()));
    }
  return out;
}

template <class Texts>
void mirrorBoxes(const Mirror& mirror, Texts& texts) {
  for (auto& text : texts) text.box = mirror(text.box);
}

void mirrorView(const Mirror& mirror, PageView& view) {
  view.raster = seenIn(mirror, view.raster);
  view.viewToPage = view.viewToPage.after(mirror.map());
  mirrorBoxes(mirror, view.texts);
  for (VectorPath& path : view.paths) {
    for (auto& line : path.polylines)
      for (Point& p : line) p = mirror(p);
    path.box = mirror(path.box);
    if (path.clip) path.clip = mirror(*path.clip);
  }
}

void mirrorLines(const Mirror& mirror, bool plumb, std::vector<GridLine>& lines) {
  for (GridLine& line : lines)
    line.position_px = plumb ? mirror(Point{line.position_px, 0}).x : mirror(Point{0, line.position_px}).y;
  if (plumb ? mirror.across : mirror.upsideDown) std::ranges::reverse(lines);
}

void mirrorFrame(const Mirror& mirror, PlotFrame& frame) {
  auto& [topLeft, topRight, bottomRight, bottomLeft] = frame.corners;
  for (Point& corner : frame.corners) corner = mirror(corner);
  if (mirror.across) std::swap(topLeft, topRight), std::swap(bottomLeft, bottomRight);
  if (mirror.upsideDown) std::swap(topLeft, bottomLeft), std::swap(topRight, bottomRight);
  mirrorLines(mirror, true, frame.xLines);
  mirrorLines(mirror, false, frame.yLines);
  if (mirror.across) frame.drawnOffset_px.x *= -1;
  if (mirror.upsideDown) frame.drawnOffset_px.y *= -1;
}

void mirrorAxis(const Mirror& mirror, bool plumb, AxisReading& axis) {
  for (TickLabel& tick : axis.ticks)
    tick.position_px = plumb ? mirror(Point{0, tick.position_px}).y : mirror(Point{tick.position_px, 0}).x;
  mirrorBoxes(mirror, axis.ticks);
  if (plumb ? mirror.upsideDown : mirror.across) std::swap(axis.min, axis.max);
}

}  // namespace

std::optional<LocatedGraph> mirroredToRise(const LocatedGraph& graph) {
  const AxisCalibration& axes = graph.axes.calibration.value;
  const Mirror mirror{axes.x.max < axes.x.min, axes.y.max < axes.y.min, graph.view.raster.width_px,
                      graph.view.raster.height_px};
  const bool turned = graph.candidate.value.quarterTurns != 0 || !graph.view.viewToPage.isAffine();
  if (mirror.across == mirror.upsideDown || turned || graph.view.raster.empty() || axes.bend) return {};
  LocatedGraph rising = graph;
  mirrorView(mirror, rising.view);
  mirrorFrame(mirror, rising.frame.value);
  AxisCalibration& mirrored = rising.axes.calibration.value;
  mirrored.viewToUnits = mirrored.viewToUnits.after(mirror.map());
  mirrorAxis(mirror, false, mirrored.x);
  mirrorAxis(mirror, true, mirrored.y);
  mirrorBoxes(mirror, rising.axes.texts);
  mirrorBoxes(mirror, rising.axes.otherLines);
  return rising;
}

}  // namespace detent::importer
