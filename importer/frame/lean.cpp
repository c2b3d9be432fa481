// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/lean.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace detent::importer {
namespace {

constexpr double farthest_deg = 15, least_deg = 0.4;
constexpr double coarse_deg = 0.25, fine_deg = 0.02;
constexpr double standsOut = 1.5;  // times the score without tilt; a curve's slope does not reach it
constexpr int leanLargestSide_px = 1400;
constexpr int leanMinContrast = 12;  // grey levels of a line above both sides

/// Crests of nearly horizontal lines, as (along, across).
std::vector<cv::Point> levelCrests(const cv::Mat& darkness) {
  std::vector<cv::Point> crests;
  for (int y = 3; y < darkness.rows - 3; ++y) {
    const auto *c = darkness.ptr<std::uint8_t>(y), *above = darkness.ptr<std::uint8_t>(y - 1),
               *below = darkness.ptr<std::uint8_t>(y + 1), *farAbove = darkness.ptr<std::uint8_t>(y - 3),
               *farBelow = darkness.ptr<std::uint8_t>(y + 3);
    for (int x = 0; x < darkness.cols; ++x)
      if (c[x] - std::max(farAbove[x], farBelow[x]) >= leanMinContrast && c[x] >= above[x] && c[x] > below[x])
        crests.emplace_back(x, y);
  }
  return crests;
}

/// Sharpness of the horizontal rows of points after removing the tilt.
double rowScore(const std::vector<cv::Point>& points, double slope, int size, std::vector<int>& rows) {
  const int room = static_cast<int>(std::abs(slope) * size) + 2;
  rows.assign(static_cast<std::size_t>(size + 2 * room + 2), 0);
  const double nearest = room + 0.5;  // all rows are above zero, so truncation rounds
  for (const cv::Point& p : points) ++rows[static_cast<std::size_t>(p.y - slope * p.x + nearest)];
  double sum = 0;
  for (const int n : rows) sum += static_cast<double>(n) * n;
  return sum;
}

class Directions {
 public:
  explicit Directions(const cv::Mat& darkness)
      : level_(levelCrests(darkness)),
        plumb_(levelCrests(darkness.t())),
        size_(std::max(darkness.cols, darkness.rows)) {}

  /// Lines tilted down to the right by `deg` go with vertical lines tilted to the left by the same angle.
  double score(double deg) {
    const double slope = std::tan(deg * CV_PI / 180);
    return rowScore(level_, slope, size_, rows_) + rowScore(plumb_, -slope, size_, rows_);
  }
  double best(double from_deg, double to_deg, double step_deg) {
    double at = from_deg, most = -1;
    for (double deg = from_deg; deg <= to_deg + 1e-9; deg += step_deg)
      if (const double s = score(deg); s > most) most = s, at = deg;
    return at;
  }

 private:
  std::vector<cv::Point> level_, plumb_;
  int size_;
  std::vector<int> rows_;
};

}  // namespace

double leanOf(const cv::Mat& darkness) {
  if (darkness.rows < 32 || darkness.cols < 32) return 0;
  cv::Mat plane = darkness;
  while (std::max(plane.cols, plane.rows) > leanLargestSide_px) {
    cv::Mat half;
    cv::resize(plane, half, {plane.cols / 2, plane.rows / 2}, 0, 0, cv::INTER_AREA);
    plane = half;
  }
  Directions directions(plane);
  const double coarse = directions.best(-farthest_deg, farthest_deg, coarse_deg);
  if (std::abs(coarse) < least_deg - coarse_deg) return 0;
  const double lean = directions.best(coarse - coarse_deg, coarse + coarse_deg, fine_deg);
  if (std::abs(lean) < least_deg || directions.score(lean) < standsOut * directions.score(0)) return 0;
  return lean;
}

Affine turnedToPage(const Page& page, double lean_deg) {
  if (lean_deg == 0) return {};
  const double angle = lean_deg * CV_PI / 180, c = std::cos(angle), s = std::sin(angle);
  const Point middle{0.5 * (page.width - 1), 0.5 * (page.height - 1)};
  return {c, s, -s, c, middle.x - c * middle.x + s * middle.y, middle.y - s * middle.x - c * middle.y};
}

}  // namespace detent::importer
