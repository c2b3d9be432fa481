// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/half_colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace detent::importer {

namespace {

constexpr int kSmooth_blocks = 1;  // to either side: coding spreads colour over about three blocks
constexpr int kAround_blocks = 2;  // to either side: how far the relation of colour to brightness is the same
constexpr int kReach_blocks = kSmooth_blocks + kAround_blocks;
constexpr int kBand_blocks = 128;          // rows of blocks at a time, for the memory's sake
constexpr float kBrightNoise_levels2 = 4;  // variance that rounding and coding leave on even paper
constexpr float kColourNoise_levels2 = 1;  // the same of colour: what varies less needs no explanation
/// Of a block's colour that brightness does not tell, the share kept. Coding blurs colour, so most is dropped where brightness
/// explains all around; where it leaves a third unexplained two inks meet, and all is kept.
constexpr float kKeptAlways = 0.3F, kKeptPerUnexplained = 2;
constexpr float kGrey_levels = 2;  // Cb and Cr of a band without colour

using Values = std::vector<float>;

/// Values per block, some rows of them.
struct Band {
  int width = 0, height = 0;

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }

  /// Mean over the neighbours within `reach` along one direction: `count` values, `step` apart, from `first`.
  static void meanAlong(const Values& in, Values& out, std::size_t first, std::size_t step, int count,
                        int reach) {
    const auto at = [&](int k) { return first + static_cast<std::size_t>(k) * step; };
    float sum = 0;
    int n = 0;
    for (int k = 0; k < std::min(reach, count); ++k) sum += in[at(k)], ++n;
    for (int k = 0; k < count; ++k) {
      if (k + reach < count) sum += in[at(k + reach)], ++n;
      if (k - reach > 0) sum -= in[at(k - reach - 1)], --n;
      out[at(k)] = sum / static_cast<float>(n);
    }
  }

  Values mean(const Values& in, int reach) const {
    Values rows(size()), both(size());
    for (int y = 0; y < height; ++y) meanAlong(in, rows, index(0, y), 1, width, reach);
    for (int x = 0; x < width; ++x)
      meanAlong(rows, both, index(x, 0), static_cast<std::size_t>(width), height, reach);
    return both;
  }

  Values meanOfProduct(const Values& a, const Values& b, int reach) const {
    Values product(size());
    for (std::size_t i = 0; i < size(); ++i) product[i] = a[i] * b[i];
    return mean(product, reach);
  }
};

/// Brightness and colour of a band's blocks, as stored.
struct Stored {
  Values bright;
  std::array<Values, 2> colour;  ///< Cb, Cr about 0
};

/// Colour of a pixel = `level` + `slope` x its brightness.
struct Relation {
  std::array<Values, 2> level, slope;
};

Relation relationOf(const Band& band, const Stored& stored) {
  const std::size_t size = band.size();
  const Values bright = band.mean(stored.bright, kSmooth_blocks);
  const Values brightAround = band.mean(bright, kAround_blocks);
  Values spread = band.meanOfProduct(bright, bright, kAround_blocks);
  for (std::size_t i = 0; i < size; ++i)
    spread[i] = std::max(0.0F, spread[i] - brightAround[i] * brightAround[i]) + kBrightNoise_levels2;
  Relation out;
  Values varied(size, 0), explained(size, 0);
  for (std::size_t c = 0; c < 2; ++c) {
    const Values colour = band.mean(stored.colour[c], kSmooth_blocks);
    const Values around = band.mean(colour, kAround_blocks);
    const Values square = band.meanOfProduct(colour, colour, kAround_blocks);
    out.slope[c] = band.meanOfProduct(bright, colour, kAround_blocks);
    out.level[c] = colour;
    for (std::size_t i = 0; i < size; ++i) {
      const float together = out.slope[c][i] - brightAround[i] * around[i];
      out.slope[c][i] = together / spread[i];
      explained[i] += together * out.slope[c][i];
      varied[i] += std::max(0.0F, square[i] - around[i] * around[i]);
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    const float share =
        varied[i] > kColourNoise_levels2 ? std::clamp(explained[i] / varied[i], 0.0F, 1.0F) : 1;
    const float kept = std::min(1.0F, kKeptAlways + kKeptPerUnexplained * (1 - share));
    for (std::size_t c = 0; c < 2; ++c) {
      // Beside a black or grey line only a share of what changes in brightness changes in colour.
      out.slope[c][i] *= share;
      const float expected = out.level[c][i] + out.slope[c][i] * (stored.bright[i] - bright[i]);
      out.level[c][i] += kept * (stored.colour[c][i] - expected) - out.slope[c][i] * bright[i];
    }
  }
  return out;
}

class HalfColour {
 public:
  HalfColour(StoredPicture& picture, ColourBlock block)
      : picture_(picture),
        block_(block),
        across_((picture.width_px + block.across_px - 1) / block.across_px),
        down_((picture.height_px + block.down_px - 1) / block.down_px) {}

  void run() {
    for (int top = 0; top < down_; top += kBand_blocks) {
      const int bottom = std::min(down_, top + kBand_blocks);
      read(std::max(0, top - kReach_blocks), std::min(down_, bottom + kReach_blocks));
      paint(top, bottom);
    }
  }

 private:
  /// Values of the block rows from..to; those the last band had are taken from it, for its pixels are painted by now.
  void read(int from, int to) {
    const Band next{across_, to - from};
    Stored fresh{Values(next.size()), {Values(next.size()), Values(next.size())}};
    const int known = std::clamp(from_ + band_.height - from, 0, next.height);
    const auto keep = [&](const Values& old, Values& now) {
      if (known > 0)
        std::copy_n(old.begin() + static_cast<std::ptrdiff_t>(band_.index(0, from - from_)),
                    next.index(0, known), now.begin());
    };
    keep(stored_.bright, fresh.bright);
    for (std::size_t c = 0; c < 2; ++c) keep(stored_.colour[c], fresh.colour[c]);
    for (int y = known; y < next.height; ++y)
      for (int x = 0; x < across_; ++x) readBlock(x, from + y, fresh, next.index(x, y));
    stored_ = std::move(fresh);
    band_ = next;
    from_ = from;
  }

  void readBlock(int x, int y, Stored& to, std::size_t i) const {
    const int left = x * block_.across_px, top = y * block_.down_px;
    const int right = std::min(picture_.width_px, left + block_.across_px),
              bottom = std::min(picture_.height_px, top + block_.down_px);
    int sum = 0;
    for (int v = top; v < bottom; ++v)
      for (int u = left; u < right; ++u) sum += *picture_.at(u, v);
    const std::uint8_t* first = picture_.at(left, top);
    to.bright[i] = static_cast<float>(sum) / static_cast<float>((right - left) * (bottom - top));
    for (std::size_t c = 0; c < 2; ++c) to.colour[c][i] = static_cast<float>(first[c + 1]) - 128;
  }

  bool isGrey() const {
    return std::ranges::all_of(stored_.colour, [](const Values& values) {
      return std::ranges::all_of(values, [](float v) { return std::abs(v) <= kGrey_levels; });
    });
  }

  void paint(int top, int bottom) {
    const bool grey = isGrey();
    const Relation relation = grey ? Relation{} : relationOf(band_, stored_);
    for (int y = top * block_.down_px; y < std::min(picture_.height_px, bottom * block_.down_px); ++y) {
      std::uint8_t* p = picture_.row(y);
      for (int x = 0; x < picture_.width_px; ++x, p += 4) {
        const std::size_t i = band_.index(x / block_.across_px, y / block_.down_px - from_);
        const float bright = *p;
        const auto colour = [&](std::size_t c) {
          return grey ? stored_.colour[c][i] : relation.level[c][i] + relation.slope[c][i] * bright;
        };
        toRgb(p, bright, colour(0), colour(1));
      }
    }
  }

  /// JFIF 1.02: the inverse of BT.601's Y, Cb, Cr at full range.
  static void toRgb(std::uint8_t* p, float bright, float cb, float cr) {
    const auto level = [](float v) { return static_cast<std::uint8_t>(std::clamp(v + 0.5F, 0.0F, 255.0F)); };
    p[0] = level(bright + 1.402F * cr);
    p[1] = level(bright - 0.344136F * cb - 0.714136F * cr);
    p[2] = level(bright + 1.772F * cb);
  }

  StoredPicture& picture_;
  ColourBlock block_;
  int across_, down_;  ///< blocks
  Band band_;
  int from_ = 0;  ///< the band's first row of blocks
  Stored stored_;
};

}  // namespace

void colourByBrightness(StoredPicture& picture, ColourBlock block) { HalfColour(picture, block).run(); }

}  // namespace detent::importer
