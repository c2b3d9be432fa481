// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/darkness.h"

#include <algorithm>
#include <array>

#include <opencv2/imgproc.hpp>

namespace detent::importer {
namespace {

cv::Mat luminanceOf(const Raster& raster) {
  const cv::Mat rgb(raster.height_px, raster.width_px, CV_8UC3, const_cast<std::uint8_t*>(raster.rgb.data()));
  cv::Mat grey;
  cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
  return grey;
}

/// Most frequent luminance, over bins of four so that scanner noise does not split the peak.
int paperLuminance(const cv::Mat& grey) {
  std::array<long, 256> count{};
  for (int y = 0; y < grey.rows; ++y) {
    const auto* row = grey.ptr<std::uint8_t>(y);
    for (int x = 0; x < grey.cols; ++x) ++count[row[x]];
  }
  int best = 255;
  long bestCount = -1;
  for (int v = 0; v < 256; ++v) {
    long sum = 0;
    for (int k = std::max(0, v - 2); k <= std::min(255, v + 2); ++k)
      sum += count[static_cast<std::size_t>(k)];
    if (sum > bestCount ||
        (sum == bestCount && count[static_cast<std::size_t>(v)] > count[static_cast<std::size_t>(best)])) {
      bestCount = sum;
      best = v;
    }
  }
  return best;
}

/// Wider than two strokes of the largest writing and any line, so that most of a window is paper; far below a plot's
/// size, so that it is one paper.
int windowOf(const cv::Mat& grey) {
  constexpr int smallest_px = 31, largest_px = 121, perSide = 14;
  return std::clamp(std::min(grey.cols, grey.rows) / perSide, smallest_px, largest_px) | 1;
}

/// Beside a step between papers the median takes the wrong one under writing that stands close to it. There strokes are
/// what a small window does not see: thin light things on dark, thin dark ones on light.
void standOutBesideSteps(const cv::Mat& grey, const cv::Mat& paper, int window, cv::Mat& contrast) {
  constexpr int step = 48;  // grey levels between papers
  const auto square = [](int side) { return cv::getStructuringElement(cv::MORPH_RECT, {side, side}); };
  cv::Mat beside, light, dark;
  cv::morphologyEx(paper, beside, cv::MORPH_GRADIENT, square(3));
  cv::threshold(beside, beside, step, 255, cv::THRESH_BINARY);
  if (cv::countNonZero(beside) == 0) return;
  cv::dilate(beside, beside, square(window / 2 * 2 + 1));
  const int strokes = std::clamp(window / 3, 7, 25) | 1;
  cv::morphologyEx(grey, light, cv::MORPH_TOPHAT, square(strokes));
  cv::morphologyEx(grey, dark, cv::MORPH_BLACKHAT, square(strokes));
  cv::max(light, dark, light);
  light.copyTo(contrast, beside);
}

cv::Mat contrastByRegion(const cv::Mat& grey) {
  const int window = windowOf(grey);
  cv::Mat paper, contrast;
  cv::medianBlur(grey, paper, window);
  cv::absdiff(grey, paper, contrast);
  standOutBesideSteps(grey, paper, window, contrast);
  return contrast;
}

}  // namespace

cv::Mat darknessOf(const Raster& raster, PaperBy by) {
  const cv::Mat grey = luminanceOf(raster);
  if (by == PaperBy::region) return contrastByRegion(grey);
  const int paper = paperLuminance(grey);
  cv::Mat darkness;
  if (paper >= 128) {
    cv::subtract(cv::Scalar(paper), grey, darkness, cv::noArray(), CV_8U);
  } else {
    cv::subtract(grey, cv::Scalar(paper), darkness, cv::noArray(), CV_8U);
  }
  return darkness;
}

bool hasDarkPaper(const Raster& raster) {
  return !raster.empty() && paperLuminance(luminanceOf(raster)) < 128;
}

}  // namespace detent::importer
