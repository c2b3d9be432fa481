// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/even_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "importer/page/luma.h"
#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

constexpr int blocksAcross = 48;  // light changes slowly; a block of a plot is mostly paper
constexpr int smallestBlock_px = 16;
// grey level that paper gets: with room above it, so that noise is not clipped on one side
constexpr double paper = 240;
constexpr double darkest = 70;  // least level of paper in a sheet that is not dark itself
// a block is not paper if a neighbouring block is brighter by this ratio; light changes less from block to
// block
constexpr double noPaper = 1.15;
constexpr double sheetShare = 0.25;  // least share of the picture that is paper

using LightColor = std::array<double, 3>;

double brightness(const LightColor& c) { return luma(c[0], c[1], c[2]); }

/// Colours of the paper at the middles of square blocks.
struct Light {
  int block_px = 0, columns = 0, rows = 0;
  std::vector<LightColor> colors;

  LightColor& at(int column, int row) {
    return colors[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  }
  const LightColor& near(int column, int row) const {
    return colors[static_cast<std::size_t>(std::clamp(row, 0, rows - 1)) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(std::clamp(column, 0, columns - 1))];
  }
  LightColor between(int x, int y) const {
    const double u = (x + 0.5) / block_px - 0.5, v = (y + 0.5) / block_px - 0.5;
    const int column = static_cast<int>(std::floor(u)), row = static_cast<int>(std::floor(v));
    const double s = u - column, t = v - row;
    LightColor mixed;
    for (std::size_t c = 0; c < 3; ++c)
      mixed[c] = (1 - t) * ((1 - s) * near(column, row)[c] + s * near(column + 1, row)[c]) +
                 t * ((1 - s) * near(column, row + 1)[c] + s * near(column + 1, row + 1)[c]);
    return mixed;
  }
};

/// The lighter part of a block: the paper between its lines.
LightColor paperOf(const Raster& raster, int x0, int y0, int side_px) {
  std::array<std::vector<std::uint8_t>, 3> values;
  for (int y = y0; y < std::min(y0 + side_px, raster.height_px); ++y)
    for (int x = x0; x < std::min(x0 + side_px, raster.width_px); ++x)
      for (std::size_t c = 0; c < 3; ++c) values[c].push_back(raster.at(x, y)[c]);
  LightColor color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = quantileOf(values[c], 0.7);
  return color;
}

Light lightOn(const Raster& raster) {
  Light light;
  light.block_px = std::max(smallestBlock_px, std::max(raster.width_px, raster.height_px) / blocksAcross);
  light.columns = (raster.width_px + light.block_px - 1) / light.block_px;
  light.rows = (raster.height_px + light.block_px - 1) / light.block_px;
  for (int row = 0; row < light.rows; ++row)
    for (int column = 0; column < light.columns; ++column)
      light.colors.push_back(paperOf(raster, column * light.block_px, row * light.block_px, light.block_px));
  return light;
}

/// Blocks of dark print or beyond the paper's edge get the brightness of their lightest neighbour.
Light lightest(const Light& light) {
  Light out = light;
  for (int row = 0; row < light.rows; ++row)
    for (int column = 0; column < light.columns; ++column)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (const LightColor& other = light.near(column + dx, row + dy);
              brightness(other) >
              std::max(brightness(out.at(column, row)), noPaper * brightness(light.near(column, row))))
            out.at(column, row) = other;
  return out;
}

void smooth(Light& light) {
  cv::Mat colors(light.rows, light.columns, CV_64FC3, light.colors.data());
  cv::blur(colors.clone(), colors, {3, 3}, {-1, -1}, cv::BORDER_REPLICATE);
}

bool isOnLightPaper(const Light& light) {
  std::vector<double> all;
  for (const LightColor& color : light.colors) all.push_back(brightness(color));
  return quantileOf(all, 1 - sheetShare) >= darkest;
}

}  // namespace

Raster evenlyLit(Raster raster) {
  if (raster.empty()) return raster;
  const Light seen = lightOn(raster);
  if (!isOnLightPaper(seen)) return raster;
  Light light = lightest(seen);
  smooth(light);
  std::uint8_t* pixel = raster.rgb.data();
  for (int y = 0; y < raster.height_px; ++y)
    for (int x = 0; x < raster.width_px; ++x, pixel += 3) {
      const LightColor here = light.between(x, y);
      for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(
            std::lround(std::min(255.0, pixel[c] * paper / std::max(here[c], 0.5 * darkest))));
    }
  return raster;
}

}  // namespace detent::importer
