// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/loop_plane.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace detent::importer::loop {

namespace {

Point project(const std::array<double, 9>& h, Point p) {
  const double w = h[6] * p.x + h[7] * p.y + h[8];
  return {(h[0] * p.x + h[1] * p.y + h[2]) / w, (h[3] * p.x + h[4] * p.y + h[5]) / w};
}

std::array<double, 9> toArray(const cv::Mat& m) {
  std::array<double, 9> out{};
  for (int i = 0; i < 9; ++i) out[static_cast<std::size_t>(i)] = m.at<double>(i / 3, i % 3);
  return out;
}

template <class At>
double bilinear(int width, int height, Point p, const At& at) {
  const double x = std::clamp(p.x, 0.0, width - 1.0), y = std::clamp(p.y, 0.0, height - 1.0);
  const int x0 = std::min(static_cast<int>(x), std::max(0, width - 2));
  const int y0 = std::min(static_cast<int>(y), std::max(0, height - 2));
  const int x1 = std::min(x0 + 1, width - 1), y1 = std::min(y0 + 1, height - 1);
  const double fx = x - x0, fy = y - y0;
  const double top = at(x0, y0) * (1 - fx) + at(x1, y0) * fx;
  const double bottom = at(x0, y1) * (1 - fx) + at(x1, y1) * fx;
  return top * (1 - fy) + bottom * fy;
}

double length(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// No edge leaves the axis direction by more than this over the frame: then the frame counts as
/// axis-parallel.
constexpr double kAxisParallel_px = 0.6;

bool isAxisParallel(const std::array<Point, 4>& c) {
  return std::abs(c[0].y - c[1].y) < kAxisParallel_px && std::abs(c[2].y - c[3].y) < kAxisParallel_px &&
         std::abs(c[0].x - c[3].x) < kAxisParallel_px && std::abs(c[1].x - c[2].x) < kAxisParallel_px;
}

/// Mean of factor x factor blocks starting at (left, top); blocks that leave the page see paper there.
Grid shrinkBlocks(const InkLayer& ink, int left, int top, int width, int height, int factor) {
  Grid out(width, height);
  const float share = 1.0F / static_cast<float>(factor * factor);
  for (int v = 0; v < height; ++v) {
    for (int dy = 0; dy < factor; ++dy) {
      const int y = top + v * factor + dy;
      if (y < 0 || y >= ink.height_px) continue;
      for (int u = 0; u < width; ++u) {
        const int x0 = std::max(0, left + u * factor), x1 = std::min(ink.width_px, left + (u + 1) * factor);
        float sum = 0;
        for (int x = x0; x < x1; ++x) sum += ink.at(x, y);
        out.at(u, v) += sum * share;
      }
    }
  }
  return out;
}

Plane shrinkUpright(const InkLayer& ink, const std::array<Point, 4>& c, int factor, double margin) {
  const double left = (c[0].x + c[3].x) / 2, right = (c[1].x + c[2].x) / 2;
  const double top = (c[0].y + c[1].y) / 2, bottom = (c[2].y + c[3].y) / 2;
  const int x0 = static_cast<int>(std::floor(left - margin * factor));
  const int y0 = static_cast<int>(std::floor(top - margin * factor));
  const int width = static_cast<int>(std::ceil((right + margin * factor - x0 + 1) / factor));
  const int height = static_cast<int>(std::ceil((bottom + margin * factor - y0 + 1) / factor));
  Plane plane;
  plane.ink = shrinkBlocks(ink, x0, y0, width, height, factor);
  const double centre = (factor - 1) / 2.0;
  plane.toView = {double(factor), 0, x0 + centre, 0, double(factor), y0 + centre, 0, 0, 1};
  plane.fromView = {
      1.0 / factor, 0, -(x0 + centre) / factor, 0, 1.0 / factor, -(y0 + centre) / factor, 0, 0, 1};
  plane.scale = factor;
  const Point a = plane.plane({left, top}), b = plane.plane({right, bottom});
  plane.frame = {a.x, a.y, b.x, b.y};
  return plane;
}

Plane warpUpright(const InkLayer& ink, const std::array<Point, 4>& c, double frameWidth, double frameHeight,
                  double scale, double margin) {
  const double w = frameWidth / scale, h = frameHeight / scale;
  const std::array<cv::Point2f, 4> to{
      cv::Point2f(float(margin), float(margin)), cv::Point2f(float(margin + w), float(margin)),
      cv::Point2f(float(margin + w), float(margin + h)), cv::Point2f(float(margin), float(margin + h))};
  std::array<cv::Point2f, 4> from;
  for (std::size_t i = 0; i < 4; ++i) from[i] = cv::Point2f(float(c[i].x), float(c[i].y));
  const cv::Mat map = cv::getPerspectiveTransform(to.data(), from.data());
  cv::Mat source(ink.height_px, ink.width_px, CV_32F, const_cast<float*>(ink.coverage.data()));
  if (scale > 1.5) {  // what the warp would step over must be averaged first
    cv::Mat blurred;
    cv::GaussianBlur(source, blurred, cv::Size(), 0.4 * scale);
    source = blurred;
  }
  const int width = static_cast<int>(std::ceil(w + 2 * margin)) + 1,
            height = static_cast<int>(std::ceil(h + 2 * margin)) + 1;
  cv::Mat warped;
  cv::warpPerspective(source, warped, map, cv::Size(width, height), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
  Plane plane;
  plane.ink = Grid(width, height);
  for (int y = 0; y < height; ++y) {
    const float* row = warped.ptr<float>(y);
    std::copy(row, row + width, &plane.ink.at(0, y));
  }
  plane.toView = toArray(map);
  plane.fromView = toArray(cv::Mat(map.inv()));
  plane.scale = scale;
  plane.frame = {margin, margin, margin + w, margin + h};
  return plane;
}

}  // namespace

double sampleAt(const Grid& grid, Point p) {
  return bilinear(grid.width, grid.height, p, [&](int x, int y) { return double(grid.at(x, y)); });
}

double sampleAt(const InkLayer& ink, Point p) {
  return bilinear(ink.width_px, ink.height_px, p, [&](int x, int y) { return double(ink.at(x, y)); });
}

Point Plane::view(Point plane_px) const { return project(toView, plane_px); }
Point Plane::plane(Point view_px) const { return project(fromView, view_px); }

Plane makePlane(const InkLayer& ink, const PlotFrame& frame, const PlaneOptions& options) {
  const std::array<Point, 4>& c = frame.corners;
  const double width = (length(c[0], c[1]) + length(c[3], c[2])) / 2;
  const double height = (length(c[0], c[3]) + length(c[1], c[2])) / 2;
  const double extent = std::max(width, height);
  const int factor = std::max(1, static_cast<int>(std::ceil(extent / options.maxWidth_px - 0.15)));
  if (isAxisParallel(c)) return shrinkUpright(ink, c, factor, options.margin_px);
  return warpUpright(ink, c, width, height, std::max(1.0, extent / options.maxWidth_px), options.margin_px);
}

}  // namespace detent::importer::loop
