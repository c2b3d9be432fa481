// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/mark_chains.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <opencv2/imgproc.hpp>

namespace detent::importer::trace {

namespace {

constexpr double kLeast_px = 4, kMostShare = 0.05;  // a marker's size; of the picture's smaller side
constexpr double kAlikeMarks = 0.4;                 // share of the first one's size
constexpr double kReach = 5;                        // sizes, from one to the next
constexpr double kFlattest = 1;                     // sideways for each step upwards
constexpr std::size_t kFewestMarks = 4;

struct Mark {
  Point at;
  double size_px = 0;
  int label = 0;
};

/// Marks that touch a curve are rims of its markers.
std::vector<bool> touching(const cv::Mat& labels, const cv::Mat& curves, int count) {
  std::vector<bool> touch(static_cast<std::size_t>(count));
  cv::Mat beside;
  cv::dilate(curves, beside, cv::getStructuringElement(cv::MORPH_RECT, {5, 5}));
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (beside.at<std::uint8_t>(y, x)) touch[static_cast<std::size_t>(labels.at<int>(y, x))] = true;
  return touch;
}

std::vector<Mark> marksOf(const cv::Mat& stats, const cv::Mat& middles, const std::vector<bool>& rims,
                          double most_px) {
  std::vector<Mark> marks;
  for (int k = 1; k < stats.rows; ++k) {
    const double size_px =
        std::max(stats.at<int>(k, cv::CC_STAT_WIDTH), stats.at<int>(k, cv::CC_STAT_HEIGHT));
    if (size_px < kLeast_px || size_px > most_px || rims[static_cast<std::size_t>(k)]) continue;
    marks.push_back({{middles.at<double>(k, 0), middles.at<double>(k, 1)}, size_px, k});
  }
  return marks;
}

/// The nearest similar marker above a place; end() if none is within reach.
auto nextAbove(const std::vector<Mark>& marks, Point from, double size_px) {
  auto best = marks.end();
  double nearest_px = kReach * size_px;
  for (auto mark = marks.begin(); mark != marks.end(); ++mark) {
    const Point way = mark->at - from;
    const bool isUp = way.y < -0.25 * size_px && std::abs(way.x) <= -kFlattest * way.y;
    if (!isUp || std::abs(mark->size_px - size_px) > kAlikeMarks * size_px || norm(way) >= nearest_px)
      continue;
    nearest_px = norm(way);
    best = mark;
  }
  return best;
}

/// Labels of the markers above a curve's end, of about the size of one of them.
std::vector<int> chainFrom(Point end, const std::vector<Mark>& marks, const Mark& like) {
  std::vector<int> labels;
  Point at = end;
  for (auto next = nextAbove(marks, at, like.size_px); next != marks.end();
       next = nextAbove(marks, at, like.size_px)) {
    labels.push_back(next->label);
    at = next->at;
  }
  return labels.size() >= kFewestMarks ? labels : std::vector<int>{};
}

std::vector<Point> pixelsOf(const std::vector<int>& chain, const cv::Mat& labels) {
  std::vector<Point> pixels;
  if (chain.empty()) return pixels;
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (std::ranges::find(chain, labels.at<int>(y, x)) != chain.end())
        pixels.push_back({static_cast<double>(x), static_cast<double>(y)});
  return pixels;
}

}  // namespace

std::vector<std::vector<Point>> marksUpFrom(const std::vector<Point>& ends, const cv::Mat& darkMarks,
                                            const cv::Mat& curves) {
  cv::Mat labels, stats, middles;
  const int count = cv::connectedComponentsWithStats(darkMarks, labels, stats, middles, 8, CV_32S);
  const std::vector<Mark> marks = marksOf(stats, middles, touching(labels, curves, count),
                                          kMostShare * std::min(darkMarks.cols, darkMarks.rows));
  std::vector<std::vector<Point>> all;
  for (const Point end : ends) {
    std::vector<int> longest;
    for (const Mark& like : marks) {
      if (distance(like.at, end) > kReach * like.size_px) continue;
      std::vector<int> chain = chainFrom(end, marks, like);
      if (chain.size() > longest.size()) longest = std::move(chain);
    }
    all.push_back(pixelsOf(longest, labels));
  }
  return all;
}

}  // namespace detent::importer::trace
