#include "importer/frame/glyph_marks.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace detent::importer {
namespace {

constexpr int inkThreshold =
    48;  // grey levels above paper; light grids stay below or are too long to be letters

bool besides(const Box& left, const Box& right, double gapInHeights) {
  const double height = std::max(left.height(), right.height());
  const double overlap = std::min(left.y1, right.y1) - std::max(left.y0, right.y0);
  return overlap >= 0.4 * std::min(left.height(), right.height()) &&
         right.x0 - left.x1 <= gapInHeights * height;
}

}  // namespace

std::vector<Box> glyphBoxes(const cv::Mat& darkness, double minSize_px, double maxSize_px) {
  cv::Mat ink, labels, stats, centroids;
  cv::threshold(darkness, ink, inkThreshold, 255, cv::THRESH_BINARY);
  const int n = cv::connectedComponentsWithStats(ink, labels, stats, centroids, 8, CV_32S);
  std::vector<Box> boxes;
  for (int k = 1; k < n; ++k) {
    const double x = stats.at<int>(k, cv::CC_STAT_LEFT), y = stats.at<int>(k, cv::CC_STAT_TOP);
    const double w = stats.at<int>(k, cv::CC_STAT_WIDTH), h = stats.at<int>(k, cv::CC_STAT_HEIGHT);
    if (std::max(w, h) < minSize_px || std::max(w, h) > maxSize_px) continue;
    boxes.push_back({x - 0.5, y - 0.5, x + w - 0.5, y + h - 0.5});
  }
  return boxes;
}

std::vector<Box> wordBoxes(std::vector<Box> glyphs, double gapInHeights) {
  std::sort(glyphs.begin(), glyphs.end(), [](const Box& a, const Box& b) { return a.x0 < b.x0; });
  std::vector<Box> words;
  for (const auto& glyph : glyphs) {
    const auto word = std::find_if(words.rbegin(), words.rend(),
                                   [&](const Box& w) { return besides(w, glyph, gapInHeights); });
    if (word == words.rend()) {
      words.push_back(glyph);
      continue;
    }
    *word = {std::min(word->x0, glyph.x0), std::min(word->y0, glyph.y0), std::max(word->x1, glyph.x1),
             std::max(word->y1, glyph.y1)};
  }
  return words;
}

Box turned(const Box& box, int quarterTurns) {
  switch (quarterTurns & 3) {
    case 1:
      return {-box.y1, box.x0, -box.y0, box.x1};
    case 2:
      return {-box.x1, -box.y1, -box.x0, -box.y0};
    case 3:
      return {box.y0, -box.x1, box.y1, -box.x0};
    default:
      return box;
  }
}

}  // namespace detent::importer
