// SPDX-License-Identifier: GPL-3.0-or-later
// Components found by runs are the same as those found by a search from pixel to pixel.

#include "importer/page/pixel_components.h"

#include <random>
#include <set>
#include <utility>

#include <catch2/catch.hpp>

using namespace detent::importer;

namespace {

struct Mask {
  int width = 0, height = 0;
  std::size_t stride = 0;
  std::vector<std::uint8_t> bytes;

  bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height &&
           bytes[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)] != 0;
  }
};

/// Bytes beyond the width are marked and must not count.
Mask randomMask(int width, int height, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution inked(share);
  Mask mask{width, height, static_cast<std::size_t>(width + 3), {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width + 3; ++x) mask.bytes.push_back(x >= width || inked(random) ? 255 : 0);
  return mask;
}

using Pixels = std::set<std::pair<int, int>>;

Pixels pieceAround(const Mask& mask, int x, int y) {
  Pixels seen{{x, y}};
  std::vector<std::pair<int, int>> next{{x, y}};
  while (!next.empty()) {
    const auto [u, v] = next.back();
    next.pop_back();
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (mask.at(u + dx, v + dy) && seen.emplace(u + dx, v + dy).second) next.emplace_back(u + dx, v + dy);
  }
  return seen;
}

void requireSame(const PixelComponent& piece, const Pixels& pixels, const Mask& mask) {
  Box box{1e9, 1e9, -1e9, -1e9};
  int across = 0, down = 0;
  for (const auto& [x, y] : pixels) {
    box = box.joined({x + 0.0, y + 0.0, x + 1.0, y + 1.0});
    across += !mask.at(x - 1, y);
    down += !mask.at(x, y - 1);
  }
  REQUIRE(piece.box == box);
  REQUIRE(piece.area_px == static_cast<int>(pixels.size()));
  REQUIRE(piece.runsAcross == across);
  REQUIRE(piece.runsDown == down);
}

}  // namespace

TEST_CASE("Pieces of a mask", "[ink]") {
  const auto share = GENERATE(0.0, 0.02, 0.2, 0.4, 0.6, 1.0);
  const auto size = GENERATE(std::pair(1, 1), std::pair(7, 40), std::pair(61, 23));
  const Mask mask = randomMask(size.first, size.second, share, 5);
  const PixelComponents found = pixelComponentsOf(mask.bytes.data(), mask.width, mask.height, mask.stride);
  std::vector<Pixels> pixelsOf(found.all.size());
  for (const PixelRun& run : found.runs)
    for (int x = run.from; x < run.to; ++x) {
      REQUIRE(mask.at(x, run.y));
      pixelsOf[run.piece].emplace(x, run.y);
    }
  std::size_t all = 0;
  for (std::size_t i = 0; i < found.all.size(); ++i) {
    REQUIRE_FALSE(pixelsOf[i].empty());
    const auto [x, y] = *pixelsOf[i].begin();
    REQUIRE(pixelsOf[i] == pieceAround(mask, x, y));
    requireSame(found.all[i], pixelsOf[i], mask);
    all += pixelsOf[i].size();
  }
  std::size_t inked = 0;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) inked += mask.at(x, y);
  REQUIRE(all == inked);
}
