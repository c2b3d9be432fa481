// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/darkness.h"

#include <algorithm>
#include <array>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace detent::importer {
cv::Mat luminanceOf(const Raster& raster) {
  const cv::Mat rgb(raster.height_px, raster.width_px, CV_8UC3, const_cast<std::uint8_t*>(raster.rgb.data()));
  cv::Mat grey;
  cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
  return grey;
}

namespace {

/// Most frequent luminance, in bins of four so that scanner noise does not split the peak.
int paperLuminance(const cv::Mat& grey) {
  // Pixels are counted in four histograms in turn. On blank paper, two additions in a row to one counter
  // would wait for each other.
  std::array<std::array<long, 256>, 4> counts{};
  for (int y = 0; y < grey.rows; ++y) {
    const auto* row = grey.ptr<std::uint8_t>(y);
    for (int x = 0; x < grey.cols; ++x) ++counts[static_cast<std::size_t>(x & 3)][row[x]];
  }
  std::array<long, 256> count{};
  for (const auto& part : counts)
    for (std::size_t v = 0; v < count.size(); ++v) count[v] += part[v];
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

/// Window size: wider than two strokes of the largest text and any line, so that most of it is paper; far
/// below a plot's size, so that it has one paper.
int windowOf(const cv::Mat& grey) {
  constexpr int smallest_px = 31, largest_px = 121, perSide = 14;
  return std::clamp(std::min(grey.cols, grey.rows) / perSide, smallest_px, largest_px) | 1;
}

cv::Mat squareOf(int side_px) { return cv::getStructuringElement(cv::MORPH_RECT, {side_px, side_px}); }

/// Returns 255 where `mask` is connected to a place that contains a square of `side_px`, else 0.
cv::Mat joinedToWide(const cv::Mat& mask, int side_px) {
  cv::Mat dilated, parts;
  cv::morphologyEx(mask, dilated, cv::MORPH_OPEN, squareOf(side_px));
  const int n = cv::connectedComponents(mask, parts, 8, CV_32S);
  std::vector<std::uint8_t> isWide(static_cast<std::size_t>(n), 0);
  for (int y = 0; y < parts.rows; ++y)
    for (int x = 0; x < parts.cols; ++x)
      if (dilated.at<std::uint8_t>(y, x)) isWide[static_cast<std::size_t>(parts.at<int>(y, x))] = 255;
  cv::Mat joined(mask.size(), CV_8U);
  for (int y = 0; y < parts.rows; ++y)
    for (int x = 0; x < parts.cols; ++x)
      joined.at<std::uint8_t>(y, x) = isWide[static_cast<std::size_t>(parts.at<int>(y, x))];
  return joined;
}

cv::Mat distanceTo(const cv::Mat& place) {
  cv::Mat distance;
  cv::distanceTransform(255 - place, distance, cv::DIST_L2, 3);
  return distance;
}

/// Corrects the paper beside a step between two papers, where the median takes the wrong one under nearby
/// text. There, pixels count as paper if they are connected to a wide area of their grey, which reaches
/// between letters. All other pixels are compared with the nearest such paper.
void settleBesideSteps(const cv::Mat& grey, const cv::Mat& paper, int window, cv::Mat& contrast) {
  constexpr int step = 48;                                  // grey levels between papers
  constexpr double likePaper = 0.35;                        // share of the step between the two papers
  constexpr float edge_px = 1.5;                            // px; a smoothed step is not print
  const int stroke_px = std::clamp(window / 3, 7, 25) | 1;  // wider than a stroke of text
  cv::Mat light, dark, apart, beside;
  cv::dilate(paper, light, squareOf(window));
  cv::erode(paper, dark, squareOf(window));
  cv::subtract(light, dark, apart);
  cv::threshold(apart, beside, step, 255, cv::THRESH_BINARY);
  if (cv::countNonZero(beside) == 0) return;
  cv::Mat offLight, offDark, near;
  cv::absdiff(grey, light, offLight);
  cv::absdiff(grey, dark, offDark);
  apart.convertTo(near, CV_8U, likePaper);
  const cv::Mat isLight = joinedToWide(offLight <= near, stroke_px),
                isDark = joinedToWide(offDark <= near, stroke_px);
  const cv::Mat toLight = distanceTo(isLight), toDark = distanceTo(isDark);
  cv::Mat own;
  offDark.copyTo(own);
  offLight.copyTo(own, toLight < toDark);
  own.setTo(0, (toLight <= edge_px) & (toDark <= edge_px));
  own.copyTo(contrast, beside);
}

cv::Mat contrastByRegion(const cv::Mat& grey) {
  const int window = windowOf(grey);
  cv::Mat paper, contrast;
  cv::medianBlur(grey, paper, window);
  cv::absdiff(grey, paper, contrast);
  settleBesideSteps(grey, paper, window, contrast);
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

}  // namespace detent::importer
