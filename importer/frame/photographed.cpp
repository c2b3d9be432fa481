// SPDX-License-Identifier: GPL-3.0-or-later
// Photographed sheets: parallel lines of the sheet meet in a vanishing point. The two vanishing points, of
// lines along and up the plot, give the map to the level sheet except for its two scales, which the axes
// provide.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "importer/frame/darkness.h"
#include "importer/frame/plot_frame.h"

namespace detent::importer {
namespace {

constexpr int photoLargestSide_px = 1400;
constexpr double detectorScale = 0.5;     // at full scale noise breaks long edges
constexpr double shortest_share = 0.035;  // share of the larger side; letters are shorter
constexpr double farthestLean_deg = 32;   // tilt and rotation together
constexpr double agrees_deg = 0.8;        // deviation of lines on a sagging sheet
// number of the longest segments that are used; each pair proposes a point
constexpr std::size_t mostSeeds = 70;
constexpr double leastSupport = 1.5;  // share of the larger side, total length of agreeing segments
// Largest to smallest scale over the page; 1 for a level or rotated picture.
constexpr double leastForeshortened = 1.015, mostForeshortened = 1.8;

/// A straight piece of an edge. Coordinates: the picture's middle is 0, half its larger side 1.
struct Segment {
  cv::Vec3d line;  ///< a x + b y + c = 0, (a, b) of length 1
  Point middle, along;
  double length = 0;
};

struct Segments {
  std::vector<Segment> level, plumb;  ///< longest first
};

Segments segmentsOf(const cv::Mat& grey) {
  std::vector<cv::Vec4f> found;
  cv::createLineSegmentDetector(cv::LSD_REFINE_NONE, detectorScale)->detect(grey, found);
  const double half = 0.5 * std::max(grey.cols, grey.rows);
  const Point middle{0.5 * (grey.cols - 1), 0.5 * (grey.rows - 1)};
  Segments segments;
  for (const cv::Vec4f& s : found) {
    const Point a = (1 / half) * (Point{s[0], s[1]} - middle), b = (1 / half) * (Point{s[2], s[3]} - middle);
    Segment segment;
    segment.length = distance(a, b);
    if (segment.length < 2 * shortest_share) continue;
    segment.along = (1 / segment.length) * (b - a);
    segment.middle = 0.5 * (a + b);
    segment.line = {-segment.along.y, segment.along.x, cross(a, b) / segment.length};
    const double steep_deg = std::atan2(std::abs(segment.along.y), std::abs(segment.along.x)) * 180 / CV_PI;
    if (steep_deg <= farthestLean_deg) segments.level.push_back(segment);
    if (steep_deg >= 90 - farthestLean_deg) segments.plumb.push_back(segment);
  }
  const auto longer = [](const Segment& a, const Segment& b) { return a.length > b.length; };
  std::sort(segments.level.begin(), segments.level.end(), longer);
  std::sort(segments.plumb.begin(), segments.plumb.end(), longer);
  return segments;
}

/// Agreement of a segment with a vanishing point: 1 exactly, 0 from `agrees_deg` on.
double agreement(const Segment& segment, const cv::Vec3d& point) {
  const Point towards{point[0] - point[2] * segment.middle.x, point[1] - point[2] * segment.middle.y};
  const double off_deg =
      std::asin(std::min(1.0, std::abs(cross(segment.along, towards)) / norm(towards))) * 180 / CV_PI;
  return std::max(0.0, 1 - off_deg / agrees_deg);
}

double supportOf(const std::vector<Segment>& segments, const cv::Vec3d& point) {
  double sum = 0;
  for (const Segment& segment : segments) sum += segment.length * agreement(segment, point);
  return sum;
}

/// The point nearest to all lines that agree with the first estimate.
cv::Vec3d refined(const std::vector<Segment>& segments, cv::Vec3d point) {
  constexpr int rounds = 5;
  for (int round = 0; round < rounds; ++round) {
    cv::Matx33d scatter = cv::Matx33d::zeros();
    for (const Segment& segment : segments)
      scatter += segment.length * agreement(segment, point) * segment.line * segment.line.t();
    cv::Matx31d values;
    cv::Matx33d vectors;
    cv::eigen(scatter, values, vectors);  // largest first
    point = {vectors(2, 0), vectors(2, 1), vectors(2, 2)};
  }
  return point;
}

/// The point to which most lines run, homogeneous; nullopt if too few agree.
std::optional<cv::Vec3d> vanishingPoint(const std::vector<Segment>& segments) {
  constexpr double nearest = 2;  // half sides from the middle; a nearer point needs a tilt above 45 degrees
  const std::size_t seeds = std::min(segments.size(), mostSeeds);
  cv::Vec3d best;
  double most = 0;
  for (std::size_t i = 0; i < seeds; ++i)
    for (std::size_t j = i + 1; j < seeds; ++j) {
      const cv::Vec3d point = segments[i].line.cross(segments[j].line);
      const double away = std::hypot(point[0], point[1]);
      if (away == 0 || away < nearest * std::abs(point[2])) continue;
      if (const double support = supportOf(segments, point); support > most) most = support, best = point;
    }
  if (most < 2 * leastSupport) return {};
  return refined(segments, best);
}

/// The map whose axes run to the two points; middle and its scale are kept.
std::optional<Homography> mapTowards(cv::Vec3d level, cv::Vec3d plumb) {
  const double across = std::hypot(level[0], level[1]), up = std::hypot(plumb[0], plumb[1]);
  if (across == 0 || up == 0) return {};
  level *= (level[0] < 0 ? -1 : 1) / across;
  plumb *= (plumb[1] < 0 ? -1 : 1) / up;
  return Homography{{level[0], plumb[0], 0, level[1], plumb[1], 0, level[2], plumb[2], 1}};
}

/// Largest to smallest scale over the page; infinite if a part lies behind the camera.
double foreshortening(const Homography& levelToPage, const Page& page) {
  const Homography toLevel = levelToPage.inverse();
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (const Point corner :
       {Point{}, Point{page.width, 0}, Point{page.width, page.height}, Point{0, page.height}}) {
    const double w = toLevel.m[6] * corner.x + toLevel.m[7] * corner.y + toLevel.m[8];
    if (w <= 0) return std::numeric_limits<double>::infinity();
    least = std::min(least, w), largest = std::max(largest, w);
  }
  return largest / least;
}

}  // namespace

std::optional<Homography> photographedSheet(const Page& page) {
  if (page.unit != PageUnit::pixel || page.overview.width_px < 64 || page.overview.height_px < 64) return {};
  cv::Mat grey = luminanceOf(page.overview);
  const double shrink = std::max(1.0, double(std::max(grey.cols, grey.rows)) / photoLargestSide_px);
  if (shrink > 1) cv::resize(grey, grey, {}, 1 / shrink, 1 / shrink, cv::INTER_AREA);
  const Segments segments = segmentsOf(grey);
  const auto level = vanishingPoint(segments.level), plumb = vanishingPoint(segments.plumb);
  if (!level || !plumb) return {};
  const auto map = mapTowards(*level, *plumb);
  if (!map) return {};
  const double half = 0.5 * std::max(page.width, page.height);
  const Affine toPage{half, 0, 0, half, 0.5 * (page.width - 1), 0.5 * (page.height - 1)};
  const Homography levelToPage = Homography(toPage).after(map->after(toPage.inverse()));
  const double seen = foreshortening(levelToPage, page);
  return seen >= leastForeshortened && seen <= mostForeshortened ? std::optional(levelToPage) : std::nullopt;
}

std::optional<Homography> sheetOfCorners(const std::vector<Point>& corners, const Page& page) {
  constexpr double leastLean = 0.01;  // slope; less tilt is left as it is
  if (page.unit != PageUnit::pixel) return {};
  const double width = 0.5 * (distance(corners[0], corners[1]) + distance(corners[3], corners[2])),
               height = 0.5 * (distance(corners[0], corners[3]) + distance(corners[1], corners[2]));
  const double off = std::max(
      {std::abs(corners[1].y - corners[0].y) / width, std::abs(corners[2].y - corners[3].y) / width,
       std::abs(corners[3].x - corners[0].x) / height, std::abs(corners[2].x - corners[1].x) / height});
  if (off < leastLean) return {};
  const Point middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  std::vector<cv::Point2f> level, onPage;
  for (const Point& sign : {Point{-1, -1}, Point{1, -1}, Point{1, 1}, Point{-1, 1}})
    level.emplace_back(static_cast<float>(middle.x + 0.5 * sign.x * width),
                       static_cast<float>(middle.y + 0.5 * sign.y * height));
  for (const Point& corner : corners)
    onPage.emplace_back(static_cast<float>(corner.x), static_cast<float>(corner.y));
  const cv::Matx33d map = cv::getPerspectiveTransform(level, onPage);
  Homography levelToPage;
  std::copy(map.val, map.val + 9, levelToPage.m.begin());
  return foreshortening(levelToPage, page) <= mostForeshortened ? std::optional(levelToPage) : std::nullopt;
}

}  // namespace detent::importer
