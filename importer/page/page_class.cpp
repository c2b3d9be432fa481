// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/page_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <vector>

#include "importer/page/luma.h"
#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

constexpr int tile_px = 8;

// Of 255 levels. Drawn pictures, including JPEGs, have neither grain nor uneven paper (0 in all 150 pictures
// of the corpus); scans have grain of 2 to 28 and unevenness of 8 to 11, photos 6 to 12 and 64 to 104.
constexpr int leastGrain = 2, leastUneven = 4, unevenOfPhoto = 25;
constexpr int nearPaper = 60;

struct Tile {
  int level = 0, range = 0;
};

int lumaAt(const Raster& raster, int x, int y) {
  const std::uint8_t* p = raster.at(x, y);
  return static_cast<int>(std::lround(luma(p[0], p[1], p[2])));
}

Tile tileAt(const Raster& raster, int x0, int y0) {
  std::vector<int> levels(static_cast<std::size_t>(tile_px * tile_px));
  for (int y = 0, k = 0; y < tile_px; ++y)
    for (int x = 0; x < tile_px; ++x, ++k)
      levels[static_cast<std::size_t>(k)] = lumaAt(raster, x0 + x, y0 + y);
  const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
  const int range = *high - *low;
  return {medianOf(std::move(levels)), range};
}

/// A few thousand tiles, spread evenly.
std::vector<Tile> tilesOf(const Raster& raster) {
  constexpr double most = 4000;  // largest number of tiles
  const int across = raster.width_px / tile_px, down = raster.height_px / tile_px;
  const int step = std::max(1, static_cast<int>(std::sqrt(across * static_cast<double>(down) / most)));
  std::vector<Tile> tiles;
  for (int row = 0; row < down; row += step)
    for (int column = 0; column < across; column += step)
      tiles.push_back(tileAt(raster, tile_px * column, tile_px * row));
  return tiles;
}

/// Returns true if almost all pixels are black or white, as from a fax machine or a scanner in text mode.
bool isBilevel(const Raster& raster) {
  constexpr double mostBetween_share = 0.001, leastDark_share = 0.002;
  const double all = static_cast<double>(raster.width_px) * raster.height_px;
  std::size_t between = 0, dark = 0;
  for (int y = 0; y < raster.height_px; ++y) {
    if (static_cast<double>(between) >= mostBetween_share * all) return false;
    for (int x = 0; x < raster.width_px; ++x) {
      const std::uint8_t* p = raster.at(x, y);
      const auto [low, high] = std::minmax({p[0], p[1], p[2]});
      between += low > 16 && high < 239;
      between += high - low > 64;  // coloured pixels are neither black nor white
      dark += high <= 16;
    }
  }
  return static_cast<double>(between)<mostBetween_share * all&& static_cast<double>(dark)> leastDark_share *
         all;
}

/// Returns true if blank paper has exactly one of a few levels, as in windows and plots that programs fill.
/// Scanned or photographed paper varies.
bool isFilledEvenly(const std::vector<Tile>& paper) {
  constexpr std::size_t mostLevels = 3, fewestTiles = 50;
  // share of the tiles that must be blank; share of the blank tiles that must have exact levels
  constexpr double leastBare = 0.6, leastShare = 0.95;
  std::array<std::size_t, 256> counts{};
  for (const Tile& tile : paper)
    if (tile.range == 0) ++counts[static_cast<std::size_t>(std::clamp(tile.level, 0, 255))];
  const auto bare = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
  std::ranges::sort(counts, std::greater<>{});
  const auto filled = std::accumulate(counts.begin(), counts.begin() + mostLevels, std::size_t{0});
  return paper.size() >= fewestTiles && bare >= leastBare * static_cast<double>(paper.size()) &&
         static_cast<double>(filled) >= leastShare * bare;
}

}  // namespace

std::string_view nameOf(PageClass pageClass) {
  constexpr std::string_view names[] = {"vector", "picture", "scan", "photo"};
  return names[static_cast<std::size_t>(pageClass)];
}

PageClass classOfPixels(const Raster& raster) {
  const std::vector<Tile> tiles = tilesOf(raster);
  if (tiles.empty()) return PageClass::picture;
  std::vector<int> levels, ranges, paper;
  for (const Tile& tile : tiles) levels.push_back(tile.level);
  const int level = medianOf(std::move(levels));
  const auto isPaper = [&](const Tile& tile) { return std::abs(tile.level - level) < nearPaper; };
  std::vector<Tile> nearby;
  std::ranges::copy_if(tiles, std::back_inserter(nearby), isPaper);
  if (isFilledEvenly(nearby)) return isBilevel(raster) ? PageClass::scan : PageClass::picture;
  for (const Tile& tile : nearby) ranges.push_back(tile.range);
  const int grain = medianOf(std::move(ranges));
  for (const Tile& tile : nearby)
    if (tile.range <= grain) paper.push_back(tile.level);
  const int uneven = quantileOf(paper, 0.95) - quantileOf(paper, 0.05);
  if (uneven >= unevenOfPhoto) return PageClass::photo;
  if (uneven >= leastUneven || grain >= leastGrain || isBilevel(raster)) return PageClass::scan;
  return PageClass::picture;
}

}  // namespace detent::importer
