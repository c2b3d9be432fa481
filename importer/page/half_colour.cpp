// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/half_colour.h"

#include <algorithm>
#include <array>

#include <opencv2/imgproc.hpp>

namespace detent::importer {

namespace {

constexpr int kSmooth_blocks = 1;  // on either side: coding spreads colour over about three blocks
// on either side: range over which the relation of colour to brightness is constant
constexpr int kAround_blocks = 2;
constexpr int kReach_blocks = kSmooth_blocks + kAround_blocks;
constexpr int kBand_blocks = 128;  // rows of blocks processed at a time, to limit memory
// variance of brightness that rounding and coding cause on even paper
constexpr float kBrightNoise_levels2 = 4;
constexpr float kColourNoise_levels2 = 1;  // the same for colour: smaller variations need no explanation
/// Share of a block's colour that is kept although brightness does not explain it. Coding blurs colour, so
/// most is dropped where brightness explains the surroundings. If a third is unexplained, two colours meet
/// and all is kept.
constexpr float kKeptAlways = 0.3F, kKeptPerUnexplained = 2;
constexpr float kGrey_levels = 2;  // Cb and Cr of a band without colour

/// Brightness and colour of the blocks as stored: one row of floats for each row of blocks.
struct Stored {
  cv::Mat bright;
  std::array<cv::Mat, 2> colour;  ///< Cb, Cr about 0

  Stored() = default;
  Stored(int width, int height)
      : bright(height, width, CV_32F),
        colour{cv::Mat(height, width, CV_32F), cv::Mat(height, width, CV_32F)} {}
};

/// Colour of a pixel = `level` + `slope` x its brightness.
struct Relation {
  std::array<cv::Mat, 2> level, slope;
};

/// Mean over the existing neighbours within `reach`.
cv::Mat meanWithin(const cv::Mat& in, int reach) {
  const auto sum = [&](const cv::Mat& values) {
    cv::Mat out;
    cv::boxFilter(values, out, CV_32F, {2 * reach + 1, 2 * reach + 1}, {-1, -1}, false, cv::BORDER_CONSTANT);
    return out;
  };
  return sum(in) / sum(cv::Mat::ones(in.size(), CV_32F));
}

Relation relationOf(const Stored& stored) {
  const cv::Mat bright = meanWithin(stored.bright, kSmooth_blocks);
  const cv::Mat brightAround = meanWithin(bright, kAround_blocks);
  const cv::Mat spread =
      cv::max(meanWithin(bright.mul(bright), kAround_blocks) - brightAround.mul(brightAround), 0) +
      kBrightNoise_levels2;
  Relation out;
  cv::Mat varied = cv::Mat::zeros(bright.size(), CV_32F), explained = varied.clone();
  for (std::size_t c = 0; c < 2; ++c) {
    const cv::Mat colour = meanWithin(stored.colour[c], kSmooth_blocks);
    const cv::Mat around = meanWithin(colour, kAround_blocks);
    const cv::Mat together = meanWithin(bright.mul(colour), kAround_blocks) - brightAround.mul(around);
    out.slope[c] = together / spread;
    out.level[c] = colour;
    explained += together.mul(out.slope[c]);
    varied += cv::max(meanWithin(colour.mul(colour), kAround_blocks) - around.mul(around), 0);
  }
  cv::Mat share = cv::min(cv::max(explained / varied, 0), 1);
  share.setTo(1, varied <= kColourNoise_levels2);
  const cv::Mat kept = cv::min(kKeptAlways + kKeptPerUnexplained * (1 - share), 1);
  for (std::size_t c = 0; c < 2; ++c) {
    // Beside a black or grey line only a share of the change in brightness is a change in colour.
    out.slope[c] = out.slope[c].mul(share);
    const cv::Mat expected = out.level[c] + out.slope[c].mul(stored.bright - bright);
    out.level[c] += kept.mul(stored.colour[c] - expected) - out.slope[c].mul(bright);
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
  /// Reads the block rows from..to. Rows of the previous band are taken from it, because its pixels are
  /// already overwritten.
  void read(int from, int to) {
    Stored fresh(across_, to - from);
    const int known = std::clamp(from_ + stored_.bright.rows - from, 0, to - from);
    const auto keep = [&](const cv::Mat& old, const cv::Mat& now) {
      if (known > 0) old.rowRange(from - from_, from - from_ + known).copyTo(now.rowRange(0, known));
    };
    keep(stored_.bright, fresh.bright);
    for (std::size_t c = 0; c < 2; ++c) keep(stored_.colour[c], fresh.colour[c]);
    for (int y = from + known; y < to; ++y)
      for (int x = 0; x < across_; ++x) readBlock(x, y, fresh, y - from);
    stored_ = std::move(fresh);
    from_ = from;
  }

  void readBlock(int x, int y, Stored& to, int row) const {
    const int left = x * block_.across_px, top = y * block_.down_px;
    const int right = std::min(picture_.width_px, left + block_.across_px),
              bottom = std::min(picture_.height_px, top + block_.down_px);
    int sum = 0;
    for (int v = top; v < bottom; ++v)
      for (int u = left; u < right; ++u) sum += *picture_.at(u, v);
    const std::uint8_t* first = picture_.at(left, top);
    to.bright.at<float>(row, x) =
        static_cast<float>(sum) / static_cast<float>((right - left) * (bottom - top));
    for (std::size_t c = 0; c < 2; ++c)
      to.colour[c].at<float>(row, x) = static_cast<float>(first[c + 1]) - 128;
  }

  bool isGrey() const {
    return std::ranges::all_of(
        stored_.colour, [](const cv::Mat& values) { return cv::norm(values, cv::NORM_INF) <= kGrey_levels; });
  }

  void paint(int top, int bottom) {
    const bool grey = isGrey();
    const Relation relation = grey ? Relation{} : relationOf(stored_);
    for (int y = top * block_.down_px; y < std::min(picture_.height_px, bottom * block_.down_px); ++y) {
      std::uint8_t* p = picture_.row(y);
      for (int x = 0; x < picture_.width_px; ++x, p += 4) {
        const int column = x / block_.across_px, row = y / block_.down_px - from_;
        const float bright = *p;
        const auto colour = [&](std::size_t c) {
          return grey ? stored_.colour[c].at<float>(row, column)
                      : relation.level[c].at<float>(row, column) +
                            relation.slope[c].at<float>(row, column) * bright;
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
  int from_ = 0;       ///< first stored row of blocks
  Stored stored_;
};

}  // namespace

void colourByBrightness(StoredPicture& picture, ColourBlock block) { HalfColour(picture, block).run(); }

}  // namespace detent::importer
