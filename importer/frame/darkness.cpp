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

}  // namespace

cv::Mat darknessOf(const Raster& raster) {
  const cv::Mat grey = luminanceOf(raster);
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
