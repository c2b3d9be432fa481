// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/overlay/overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <opencv2/imgproc.hpp>

#include "importer/importer.h"
#include "importer/page/mirrored.h"
#include "model/sections.h"

namespace detent::importer {
namespace {

// Okabe & Ito's palette, for colour vision deficiencies. RGB order, as Raster.
const cv::Scalar leftOverColor(230, 159, 0), pressColor(213, 94, 0), releaseColor(0, 114, 178),
    frameColor(0, 158, 115), tickColor(204, 121, 167);

constexpr int subPixelBits = 4;
constexpr double subPixel = 1 << subPixelBits;
constexpr double keptContrast = 0.45;  // contrast that the page keeps

/// Draws in view pixels on a picture enlarged by `scale`. A graph that was traced mirrored is drawn as it
/// stands on the page.
class Canvas {
 public:
  Canvas(const PageView& view, double scale)
      : scale_(scale),
        mirrored_(mirroredBy(view.viewToPage)),
        last_px_{view.raster.width_px - 1.0, view.raster.height_px - 1.0} {
    const Raster& page = view.raster;
    const cv::Mat source(page.height_px, page.width_px, CV_8UC3, const_cast<std::uint8_t*>(page.rgb.data()));
    // The page is paled so that the drawing stands out; before the enlargement, while there are fewer pixels.
    cv::Mat pale;
    source.convertTo(pale, CV_8U, keptContrast, 255 * (1 - keptContrast));
    cv::resize(pale, picture_, {}, scale, scale, scale > 1 ? cv::INTER_CUBIC : cv::INTER_AREA);
    if (mirrored_.across) cv::flip(picture_, picture_, 1);
    if (mirrored_.upsideDown) cv::flip(picture_, picture_, 0);
  }

  void polyline(const std::vector<Point>& points_px, const cv::Scalar& color, int thickness) {
    for (std::size_t i = 1; i < points_px.size(); ++i) {
      cv::line(picture_, fine(points_px[i - 1]), fine(points_px[i]), color, thickness, cv::LINE_AA,
               subPixelBits);
    }
  }

  void dots(const std::vector<Point>& points_px, const cv::Scalar& color) {
    for (const Point& p : points_px) {
      cv::circle(picture_, fine(p), static_cast<int>(1.2 * subPixel), color, cv::FILLED, cv::LINE_AA,
                 subPixelBits);
    }
  }

  void ring(Point at_px, const cv::Scalar& color) {
    cv::circle(picture_, fine(at_px), static_cast<int>(7 * subPixel), color, 2, cv::LINE_AA, subPixelBits);
  }

  void text(Point at_px, const std::string& words, const cv::Scalar& color, double dx = 0, double dy = 0) {
    const Point shown = onPage(at_px);
    const cv::Point at(static_cast<int>(enlarged(shown.x) + dx), static_cast<int>(enlarged(shown.y) + dy));
    cv::putText(picture_, words, at, cv::FONT_HERSHEY_SIMPLEX, 0.42, cv::Scalar::all(255), 3, cv::LINE_AA);
    cv::putText(picture_, words, at, cv::FONT_HERSHEY_SIMPLEX, 0.42, color, 1, cv::LINE_AA);
  }

  Raster raster() const {
    Raster out{picture_.cols, picture_.rows, {}};
    out.rgb.assign(picture_.datastart, picture_.dataend);
    return out;
  }

 private:
  /// Pixel centres stay pixel centres when enlarged.
  double enlarged(double px) const { return (px + 0.5) * scale_ - 0.5; }
  Point onPage(Point p) const {
    return {mirrored_.across ? last_px_.x - p.x : p.x, mirrored_.upsideDown ? last_px_.y - p.y : p.y};
  }
  cv::Point fine(Point in_view) const {
    const Point p = onPage(in_view);
    const double limit = 30000;  // beyond this OpenCV's fixed-point lines overflow
    return {static_cast<int>(std::lround(std::clamp(enlarged(p.x), -limit, limit) * subPixel)),
            static_cast<int>(std::lround(std::clamp(enlarged(p.y), -limit, limit) * subPixel))};
  }

  double scale_;
  Mirrored mirrored_;
  Point last_px_;  // last point, in view pixels
  cv::Mat picture_;
};

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// The fitted curve in view pixels: every piece sampled, vertical rises included.
std::vector<Point> curveInView(const StrokeCurve& curve, const AxisCalibration& calibration) {
  constexpr int samplesPerPiece = 24;
  std::vector<Point> points_px;
  const auto& knots = curve.knots();
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    points_px.push_back(calibration.toView({knots[i].displacement_mm, knots[i].force_N}));
    const double width_mm = knots[i + 1].displacement_mm - knots[i].displacement_mm;
    for (int s = 1; s < samplesPerPiece && width_mm > 0; ++s) {
      const double x_mm = knots[i].displacement_mm + width_mm * s / samplesPerPiece;
      points_px.push_back(calibration.toView({x_mm, curve.force_N(x_mm)}));
    }
  }
  points_px.push_back(calibration.toView({knots.back().displacement_mm, knots.back().force_N}));
  return points_px;
}

void drawAxes(Canvas& canvas, const PlotFrame& frame, const AxisCalibration& calibration) {
  std::vector<Point> outline(frame.corners.begin(), frame.corners.end());
  outline.push_back(outline.front());
  canvas.polyline(outline, frameColor, 1);
  const Point bottomLeft = frame.corners[3];
  for (const TickLabel& tick : calibration.x.ticks) {
    const Point at{tick.position_px, bottomLeft.y};
    canvas.polyline({{at.x, at.y - 4}, {at.x, at.y + 4}}, tickColor, 1);
    canvas.text(at, (tick.used ? "" : "x ") + shortNumber(tick.value), tickColor, 3, -5);
  }
  for (const TickLabel& tick : calibration.y.ticks) {
    const Point at{bottomLeft.x, tick.position_px};
    canvas.polyline({{at.x - 4, at.y}, {at.x + 4, at.y}}, tickColor, 1);
    canvas.text(at, (tick.used ? "" : "x ") + shortNumber(tick.value), tickColor, 6, 12);
  }
  canvas.text(bottomLeft, calibration.x.unit + " / " + calibration.y.unit, frameColor, 8, -20);
}

void drawStroke(Canvas& canvas, const StrokeCurve& curve, Stroke stroke, const StrokePoints& traced,
                const AxisCalibration& calibration) {
  const cv::Scalar& color = stroke == Stroke::press ? pressColor : releaseColor;
  canvas.dots(traced.points_px, cv::Scalar::all(90));
  canvas.polyline(curveInView(curve, calibration), color, 1);
  for (const TactilePoint& point : tactilePoints(curve, stroke)) {
    const Point at = calibration.toView({point.displacement_mm, point.force_N});
    canvas.ring(at, color);
    char label[64];
    std::snprintf(label, sizeof label, "%.3f mm %.4g N", point.displacement_mm, point.force_N);
    canvas.text(at, label, color, 10, stroke == Stroke::press ? -8 : 16);
  }
}

/// The page with the findings of every import, even of a refused one.
Canvas canvasOf(const GraphEvidence& evidence) {
  // Small pictures are enlarged; huge ones keep their size.
  const double width = evidence.view.raster.width_px;
  const double scale = std::clamp(std::round(1800 / std::max(width, 1.0)), 1.0, 4.0);
  Canvas canvas(evidence.view, scale);
  drawAxes(canvas, evidence.frame, evidence.axes.calibration.value);
  for (const Remainder& left : evidence.explanation.left) canvas.dots(left.pixels_px, leftOverColor);
  for (const TraceJump& jump : evidence.explanation.jumps)
    canvas.polyline({jump.from_px, jump.to_px}, leftOverColor, 4);
  return canvas;
}

}  // namespace

Raster drawOverlay(const GraphEvidence& evidence, const StrokePair& strokes, const Button& button) {
  Canvas canvas = canvasOf(evidence);
  const AxisCalibration& calibration = evidence.axes.calibration.value;
  const ForceGraph& graph = button.states().front().graph;
  if (graph.release() && strokes.release) {
    drawStroke(canvas, *graph.release(), Stroke::release, *strokes.release, calibration);
  }
  drawStroke(canvas, graph.press(), Stroke::press, strokes.press, calibration);
  return canvas.raster();
}

Raster drawOverlay(const GraphEvidence& evidence) {
  Canvas canvas = canvasOf(evidence);
  for (const CurveTrace& trace : evidence.traces)
    canvas.polyline(trace.points_px, trace.stroke == Stroke::release ? releaseColor : pressColor, 1);
  return canvas.raster();
}

}  // namespace detent::importer
