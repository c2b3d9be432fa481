// SPDX-License-Identifier: GPL-3.0-or-later
// Lines stored with colour at half resolution keep their colour, and the paper beside them has none.

#include "importer/page/half_colour.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "importer/page/document.h"
#include "importer/page/luma.h"

using namespace detent;
using namespace detent::importer;

namespace {

constexpr int width = 160, height = 120;
constexpr double thickness_px = 2, apart_px = 30;
constexpr Rgb navy{20, 30, 110}, ochre{170, 125, 20};

double offLine(int x, int y, double from) { return std::abs(y - from - 0.21 * x) / std::hypot(1, 0.21); }

/// A navy and an ochre line on paper, `apart_px` apart.
cv::Mat twoLines(double paper) {
  cv::Mat mat(height, width, CV_8UC3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double rgb[3] = {paper, paper, paper};
      for (const auto& [from, lineColour] : {std::pair(25.3, navy), std::pair(25.3 + apart_px, ochre)}) {
        const double cover = std::clamp(thickness_px / 2 + 0.5 - offLine(x, y, from), 0.0, 1.0);
        const double full[3] = {double(lineColour.r), double(lineColour.g), double(lineColour.b)};
        for (int c = 0; c < 3; ++c) rgb[c] += cover * (full[c] - rgb[c]);
      }
      for (int c = 0; c < 3; ++c)
        mat.at<cv::Vec3b>(y, x)[2 - c] = static_cast<unsigned char>(std::lround(rgb[c]));
    }
  return mat;
}

Raster stored(const cv::Mat& mat, const std::string& extension, int quality) {
  std::vector<unsigned char> bytes;
  const int key = extension == ".webp" ? cv::IMWRITE_WEBP_QUALITY : cv::IMWRITE_JPEG_QUALITY;
  REQUIRE(cv::imencode(extension, mat, bytes, {key, quality}));
  const auto document = Document::fromBytes(bytes, "plot");
  REQUIRE(document.ok());
  auto page = document->page(1);
  REQUIRE(page.ok());
  return std::move(page).value().overview;
}

/// Cb and Cr.
Point colourOf(Rgb c) {
  const double bright = luma(c.r, c.g, c.b);
  return {0.564 * (c.b - bright), 0.713 * (c.r - bright)};
}

}  // namespace

TEST_CASE("A line stored with colour at half resolution keeps its colour, and the paper has none",
          "[half_colour]") {
  for (const auto& [extension, quality] :
       {std::pair(".jpg", 90), std::pair(".jpg", 75), std::pair(".webp", 75)})
    for (const double paper : {255.0, 225.0}) {
      INFO(extension << ", quality " << quality << ", paper " << paper);
      const Raster raster = stored(twoLines(paper), extension, quality);
      double onNavy = 0, onOchre = 0, beside = 0;
      int navyPixels = 0, ochrePixels = 0, besidePixels = 0;
      for (int y = 4; y < height - 4; ++y)
        for (int x = 4; x < width - 4; ++x) {
          const std::uint8_t* p = raster.at(x, y);
          const Point colour = colourOf({p[0], p[1], p[2]});
          const double toNavy = offLine(x, y, 25.3), toOchre = offLine(x, y, 25.3 + apart_px);
          if (toNavy < 0.5)
            onNavy += dot(colour, colourOf(navy)) / dot(colourOf(navy), colourOf(navy)), ++navyPixels;
          if (toOchre < 0.5)
            onOchre += dot(colour, colourOf(ochre)) / dot(colourOf(ochre), colourOf(ochre)), ++ochrePixels;
          const double nearest = std::min(toNavy, toOchre);
          if (nearest > 2 && nearest < 5) beside += norm(colour), ++besidePixels;
        }
      CHECK(onNavy / navyPixels > 0.85);  // a decoder's own smoothing leaves about 0.6
      CHECK(onNavy / navyPixels < 1.15);
      CHECK(onOchre / ochrePixels > 0.85);
      CHECK(onOchre / ochrePixels < 1.15);
      CHECK(beside / besidePixels < 4);
    }
}

TEST_CASE("Colour at half resolution is the same at every height of a picture", "[half_colour]") {
  const int tall = 1100, cut = 190, margin = 6;
  const auto drawn = [](int from, int rows) {
    StoredPicture picture(41, rows);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < picture.width_px; ++x) {
        std::uint8_t* p = picture.row(y) + 4 * x;
        const int block = (y + from) / 2 * 37 + x / 2 * 11;
        p[0] = static_cast<std::uint8_t>(60 + ((y + from) * 13 + x * 29) % 190);
        p[1] = static_cast<std::uint8_t>(90 + block % 70), p[2] = static_cast<std::uint8_t>(100 + block % 53);
      }
    colourByBrightness(picture, {2, 2});
    return picture;
  };
  const StoredPicture whole = drawn(0, tall), part = drawn(cut, tall - cut);
  int different = 0;
  for (int y = margin; y < tall - cut; ++y)
    for (int x = 0; x < whole.width_px; ++x)
      for (int c = 0; c < 3; ++c) different += std::abs(whole.at(x, y + cut)[c] - part.at(x, y)[c]) > 1;
  CHECK(different == 0);
}

TEST_CASE("Brightness without colour stays grey", "[half_colour]") {
  for (const auto& [w, h] : {std::pair(1, 1), std::pair(7, 3), std::pair(2, 300)}) {
    StoredPicture picture(w, h);
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        std::uint8_t* p = picture.row(y) + 4 * x;
        p[0] = static_cast<std::uint8_t>(17 * x + y % 100), p[1] = p[2] = 128;
      }
    colourByBrightness(picture, {2, 2});
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x)
        for (int c = 0; c < 3; ++c) REQUIRE(picture.at(x, y)[c] == 17 * x + y % 100);
  }
}
