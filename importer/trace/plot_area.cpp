// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/plot_area.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "importer/page/crop.h"

namespace detent::importer::trace {

namespace {

// a frame with less skew is cropped, because resampling would cost more accuracy
constexpr double kSkewKept_px = 1.5;
constexpr double kMaxPixels =
    2.2e6;  // px; larger areas are reduced by a whole factor, their lines are thick enough

double skewOf(const PlotFrame& frame) {
  const auto& c = frame.corners;
  return std::max({std::abs(c[0].y - c[1].y), std::abs(c[3].y - c[2].y), std::abs(c[0].x - c[3].x),
                   std::abs(c[1].x - c[2].x)});
}

PlotArea cropped(const Raster& view, const Box& frame) {
  PlotArea area;
  const double pixels = std::max(0.0, frame.width()) * std::max(0.0, frame.height());
  const int factor = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMaxPixels))));
  const int margin = PlotArea::marginPx * factor;
  const int x0 = std::max(0, static_cast<int>(std::floor(frame.x0)) - margin);
  const int y0 = std::max(0, static_cast<int>(std::floor(frame.y0)) - margin);
  const int x1 = std::min(view.width_px - 1, static_cast<int>(std::ceil(frame.x1)) + margin);
  const int y1 = std::min(view.height_px - 1, static_cast<int>(std::ceil(frame.y1)) + margin);
  if (x1 - x0 + 1 < factor || y1 - y0 + 1 < factor) return area;
  const auto whole = [factor](int size_px) { return size_px / factor * factor; };
  area.raster = reducedCrop(view, {x0, y0, whole(x1 - x0 + 1), whole(y1 - y0 + 1)}, factor);
  const double half = 0.5 * (factor - 1), f = factor;
  area.toView = {{f, 0, x0 + half, 0, f, y0 + half, 0, 0, 1}};
  area.frame = {(frame.x0 - x0 - half) / f, (frame.y0 - y0 - half) / f, (frame.x1 - x0 - half) / f,
                (frame.y1 - y0 - half) / f};
  return area;
}

PlotArea warped(const Raster& view, const PlotFrame& frame) {
  const auto& c = frame.corners;
  const double width = std::max(distance(c[0], c[1]), distance(c[3], c[2]));
  const double height = std::max(distance(c[0], c[3]), distance(c[1], c[2]));
  PlotArea area;
  if (!(width >= 1 && height >= 1 && width < 32768 && height < 32768)) return area;
  const double m = PlotArea::marginPx;
  area.frame = {m, m, m + width, m + height};
  const cv::Point2f from[4] = {{static_cast<float>(area.frame.x0), static_cast<float>(area.frame.y0)},
                               {static_cast<float>(area.frame.x1), static_cast<float>(area.frame.y0)},
                               {static_cast<float>(area.frame.x1), static_cast<float>(area.frame.y1)},
                               {static_cast<float>(area.frame.x0), static_cast<float>(area.frame.y1)}};
  cv::Point2f to[4];
  for (std::size_t i = 0; i < 4; ++i) to[i] = {static_cast<float>(c[i].x), static_cast<float>(c[i].y)};
  const cv::Mat map = cv::getPerspectiveTransform(from, to);
  for (int i = 0; i < 9; ++i) area.toView.m[static_cast<std::size_t>(i)] = map.at<double>(i / 3, i % 3);
  area.raster.width_px = static_cast<int>(std::ceil(width + 2 * m)) + 1;
  area.raster.height_px = static_cast<int>(std::ceil(height + 2 * m)) + 1;
  area.raster.rgb.resize(3 * static_cast<std::size_t>(area.raster.width_px) *
                         static_cast<std::size_t>(area.raster.height_px));
  const cv::Mat source(view.height_px, view.width_px, CV_8UC3, const_cast<std::uint8_t*>(view.rgb.data()));
  cv::Mat target(area.raster.height_px, area.raster.width_px, CV_8UC3, area.raster.rgb.data());
  cv::warpPerspective(source, target, map, target.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                      cv::BORDER_REPLICATE);
  return area;
}

Mask maskOf(const std::vector<Box>& masks_px, const PlotArea& area) {
  if (masks_px.empty()) return {};
  const int width = area.raster.width_px, height = area.raster.height_px;
  Mask mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  for (const Box& given : masks_px) {
    const Box box = area.fromView.boxOf(given);
    for (int y = std::max(0, static_cast<int>(box.y0)); y <= std::min(height - 1, static_cast<int>(box.y1));
         ++y)
      for (int x = std::max(0, static_cast<int>(box.x0)); x <= std::min(width - 1, static_cast<int>(box.x1));
           ++x)
        mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = 1;
  }
  return mask;
}

std::vector<double> linePositions(const std::vector<GridLine>& lines, const PlotArea& area, bool vertical) {
  std::vector<double> positions = vertical ? std::vector<double>{area.frame.x0, area.frame.x1}
                                           : std::vector<double>{area.frame.y0, area.frame.y1};
  const Point corner = area.toView({area.frame.x0, area.frame.y1});
  for (const GridLine& line : lines) {
    if (!line.spansFrame) continue;
    const Point p =
        area.fromView(vertical ? Point{line.position_px, corner.y} : Point{corner.x, line.position_px});
    positions.push_back(vertical ? p.x : p.y);
  }
  return positions;
}

}  // namespace

cv::Mat matOf(const Plane& plane) {
  return {plane.height, plane.width, CV_32F, const_cast<float*>(plane.values.data())};
}

float Plane::sample(double x, double y) const {
  const auto below = [](double v) { return static_cast<int>(v) - (v < static_cast<int>(v) ? 1 : 0); };
  const int x0 = below(x), y0 = below(y);
  const float fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
  if (x0 >= 0 && y0 >= 0 && x0 + 1 < width && y0 + 1 < height) {
    const float *above = &values[index(x0, y0)], *under = above + width;
    return (above[0] * (1 - fx) + above[1] * fx) * (1 - fy) + (under[0] * (1 - fx) + under[1] * fx) * fy;
  }
  const auto value = [this](int px, int py) { return inside(px, py) ? at(px, py) : 0.0F; };
  const float top = value(x0, y0) * (1 - fx) + value(x0 + 1, y0) * fx;
  const float bottom = value(x0, y0 + 1) * (1 - fx) + value(x0 + 1, y0 + 1) * fx;
  return top * (1 - fy) + bottom * fy;
}

PlotArea makePlotArea(const Raster& view, const PlotFrame& frame, const std::vector<SeenText>& texts,
                      const std::vector<Box>& masks_px) {
  if (view.empty()) return {};
  PlotArea area = skewOf(frame) <= kSkewKept_px ? cropped(view, frame.box()) : warped(view, frame);
  if (area.raster.empty()) return area;
  area.fromView = area.toView.inverse();
  area.columns_px = linePositions(frame.xLines, area, true);
  area.rows_px = linePositions(frame.yLines, area, false);
  for (const SeenText& text : texts)
    if (const Box box = area.fromView.boxOf(text.box); box.touches(area.frame)) area.words.push_back(box);
  area.masked = maskOf(masks_px, area);
  return area;
}

}  // namespace detent::importer::trace
