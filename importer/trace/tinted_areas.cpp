// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/tinted_areas.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace detent::importer::trace {

namespace {

constexpr int kAlikeTint = 20;         // levels per channel between neighbours in one area, after compression
constexpr float kTint = 8;             // colour levels from the paper; less is paper
constexpr float kAreaContrasts = 1.5;  // times an area's contrast; lines have more
constexpr float kBesideTint_px = 8;    // from an area's even pixels; farther lines are not drawn on it
constexpr int kSeam_px = 3;            // half the width of the seam between an area and the paper, at most

cv::Mat squaredColor(int side_px) { return cv::getStructuringElement(cv::MORPH_RECT, {side_px, side_px}); }

/// 255 where a pixel and its neighbours have the same colour.
cv::Mat evenPixels(const cv::Mat& rgb) {
  cv::Mat high, low, even;
  cv::dilate(rgb, high, squaredColor(3));
  cv::erode(rgb, low, squaredColor(3));
  cv::inRange(high - low, cv::Scalar::all(0), cv::Scalar::all(kAlikeTint), even);
  return even;
}

/// Set of colours with a tolerance of a few levels.
class Tints {
 public:
  Tints() : known_(kCells * kCells * kCells, 0) {}

  void add(Color3 c) {
    const std::size_t cell = cellOf(c);
    if (known_[cell] == kAdded) return;
    const auto r = cell / (kCells * kCells), g = cell / kCells % kCells, b = cell % kCells;
    const auto around = [](std::size_t i) {
      return std::pair(i - std::min<std::size_t>(i, 1), std::min(i + 1, kCells - 1));
    };
    for (auto [i, lastI] = around(r); i <= lastI; ++i)
      for (auto [j, lastJ] = around(g); j <= lastJ; ++j)
        for (auto [k, lastK] = around(b); k <= lastK; ++k) {
          char& near = known_[(i * kCells + j) * kCells + k];
          near = std::max(near, kNear);
        }
    known_[cell] = kAdded;
  }
  bool has(Color3 c) const { return known_[cellOf(c)] != 0; }

 private:
  static constexpr std::size_t kCells = 32;  // of eight levels
  static constexpr char kNear = 1, kAdded = 2;
  static std::size_t cellOf(Color3 c) {
    const Rgb levels = rgbOf(c);
    return ((levels.r >> 3U) * kCells + (levels.g >> 3U)) * kCells + (levels.b >> 3U);
  }
  std::vector<char> known_;
};

/// For each pixel the nearest pixel of an area.
class NearestArea {
 public:
  explicit NearestArea(const cv::Mat& mask) {
    cv::distanceTransform(~mask, distance_px_, labels_, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    double labels = 0;
    cv::minMaxLoc(labels_, nullptr, &labels);
    at_.resize(static_cast<std::size_t>(labels) + 1);
    for (int y = 0; y < mask.rows; ++y)
      for (int x = 0; x < mask.cols; ++x)
        if (mask.at<std::uint8_t>(y, x)) at_[labelOf(x, y)] = {x, y};
  }
  cv::Point nearest(int x, int y) const { return at_[labelOf(x, y)]; }
  float away_px(int x, int y) const { return distance_px_.at<float>(y, x); }

 private:
  std::size_t labelOf(int x, int y) const { return static_cast<std::size_t>(labels_.at<int>(y, x)); }
  cv::Mat distance_px_, labels_;
  std::vector<cv::Point> at_;
};

class TintedAreas {
 public:
  TintedAreas(Raster& raster, Color3 paper)
      : raster_(raster),
        paper_(paper),
        light_(isLight(paper)),
        rgb_(raster.height_px, raster.width_px, CV_8UC3, raster.rgb.data()),
        contrast_(rgb_.size(), CV_32F) {
    for (int y = 0; y < rgb_.rows; ++y)
      for (int x = 0; x < rgb_.cols; ++x) contrast_.at<float>(y, x) = norm(colorAt(raster, x, y) - paper_);
    even_ = evenPixels(rgb_);
  }

  bool lift(const std::function<Color3()>& lineDirection) {
    const cv::Mat large = largeAreas();
    if (cv::countNonZero(large) == 0) return false;
    lineDirection_ = lineDirection();
    liftWith(NearestArea(large | (even_ & (contrast_ > kTint) & inTheirTints(large))),
             NearestArea(even_ & (contrast_ <= kTint)));
    return true;
  }

 private:
  /// 255 in even areas that are wider than any line, longer than any marker, and have lines on or beside
  /// them.
  cv::Mat largeAreas() {
    constexpr double leastWidth = 0.02, leastLength = 0.08;  // share of the smaller side
    constexpr int leastWidth_px = 7;
    const int side_px = std::min(rgb_.rows, rgb_.cols);
    const int width_px = std::max(leastWidth_px, static_cast<int>(leastWidth * side_px));
    cv::Mat dilated, labels, stats, centroids;
    cv::morphologyEx(even_ & (contrast_ > kTint), dilated, cv::MORPH_OPEN, squaredColor(width_px - 2));
    const int count = cv::connectedComponentsWithStats(dilated, labels, stats, centroids, 4, CV_32S);
    cv::Mat areas(rgb_.size(), CV_8U, cv::Scalar(0));
    for (int i = 1; i < count; ++i) {
      const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                         stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
      if (std::max(box.width, box.height) < leastLength * side_px) continue;
      const cv::Mat area = labels == i;
      const cv::Scalar mean = cv::mean(rgb_, area);
      const Color3 tint{static_cast<float>(mean[0]), static_cast<float>(mean[1]),
                        static_cast<float>(mean[2])};
      if (!isFilm(tint) || !hasLines(area, box, tint)) continue;
      areas |= area;
      means_.push_back(tint);
    }
    return areas;
  }

  /// Returns true if enough of the paper's light passes.
  bool isFilm(Color3 tint) const {
    constexpr float leastPassed = 0.25;  // in any channel
    const Color3 black, white{255, 255, 255};
    const Color3 from = light_ ? paper_ - black : white - paper_, left = light_ ? tint - black : white - tint;
    return left.r >= leastPassed * from.r && left.g >= leastPassed * from.g && left.b >= leastPassed * from.b;
  }

  /// Returns true if lines cover at least half of an area's length, over it or beside it.
  bool hasLines(const cv::Mat& area, const cv::Rect& box, Color3 tint) const {
    constexpr double leastOfLength = 0.5;  // of the longer side of an area, px of the line per px
    constexpr int beside_px = 6;
    const cv::Rect around =
        ((box + cv::Size(2 * beside_px, 2 * beside_px)) - cv::Point(beside_px, beside_px)) &
        cv::Rect({0, 0}, rgb_.size());
    cv::Mat near;
    cv::dilate(area(around), near, squaredColor(2 * beside_px + 1));
    int inked = 0;
    for (int y = 0; y < near.rows; ++y)
      for (int x = 0; x < near.cols; ++x)
        inked += near.at<std::uint8_t>(y, x) && isMark(colorAt(raster_, around.x + x, around.y + y), tint);
    return inked >= leastOfLength * std::max(box.width, box.height);
  }

  /// 255 where a pixel has about the colour of the found areas, or of two that overlap.
  cv::Mat inTheirTints(const cv::Mat& areas) const {
    constexpr std::size_t mostOverlapping = 12;
    Tints tints;
    for (int y = 0; y < rgb_.rows; ++y)
      for (int x = 0; x < rgb_.cols; ++x)
        if (areas.at<std::uint8_t>(y, x)) tints.add(colorAt(raster_, x, y));
    if (means_.size() <= mostOverlapping)
      for (const Color3& over : means_)
        for (const Color3& under : means_) tints.add(underFilm(under, over));
    cv::Mat alike(rgb_.size(), CV_8U, cv::Scalar(0));
    for (int y = 0; y < rgb_.rows; ++y)
      for (int x = 0; x < rgb_.cols; ++x)
        if (tints.has(colorAt(raster_, x, y))) alike.at<std::uint8_t>(y, x) = 255;
    return alike;
  }

  void liftWith(const NearestArea& tinted, const NearestArea& paper) {
    const Raster before = raster_;
    const auto tintAt = [&](int x, int y) {
      const cv::Point at = tinted.nearest(x, y);
      return colorAt(before, at.x, at.y);
    };
    cv::Mat inked(rgb_.size(), CV_8U, cv::Scalar(0));
    for (int y = 0; y < rgb_.rows; ++y)
      for (int x = 0; x < rgb_.cols; ++x)
        if (isMark(colorAt(before, x, y), tintAt(x, y))) inked.at<std::uint8_t>(y, x) = 255;
    cv::dilate(inked, inked, squaredColor(2 * kSeam_px - 1));
    for (int y = 0; y < rgb_.rows; ++y)
      for (int x = 0; x < rgb_.cols; ++x) {
        const float away_px = tinted.away_px(x, y), fromPaper_px = paper.away_px(x, y);
        if (away_px > kBesideTint_px) continue;
        const Color3 pixel = colorAt(before, x, y), tint = tintAt(x, y);
        const bool seam = !inked.at<std::uint8_t>(y, x) && std::max(away_px, fromPaper_px) <= kSeam_px;
        if (seam && isRim(pixel, tint))
          put(x, y, paper_);
        else if (away_px <= fromPaper_px)
          put(x, y, onPaper(pixel, tint, coreOfLine(before, x, y, tint)));
      }
  }

  /// Position of a colour on the way from the paper to a tint, and its distance from that way, colour levels.
  struct OnTheWay {
    float share = 0, off = 0;
  };
  OnTheWay onTheWay(Color3 pixel, Color3 tint) const {
    const Color3 along = tint - paper_, offset = pixel - paper_;
    const float share = dot(offset, along) / std::max(1.0F, dot(along, along));
    return {share, norm(offset - share * along)};
  }
  /// Returns true for the rim of an area, including its own edge line.
  bool isRim(Color3 pixel, Color3 tint) const {
    const OnTheWay at = onTheWay(pixel, tint);
    return at.share >= -0.1F && at.share <= kAreaContrasts && at.off <= kTint;
  }
  /// Returns true for marks on an area: far beyond its tint, or of another hue and no paler.
  bool isMark(Color3 pixel, Color3 tint) const {
    constexpr float otherHue = 24;  // colour levels
    const float contrast = norm(pixel - paper_), offset = norm(tint - paper_);
    return contrast > kAreaContrasts * offset || (contrast > offset && onTheWay(pixel, tint).off > otherHue);
  }

  /// Returns the colour near the pixel that differs most from the tint in the pixel's direction: the core of
  /// the line on whose pale rim the pixel lies. Returns the pixel's own colour if there is none.
  static Color3 coreOfLine(const Raster& picture, int x, int y, Color3 tint) {
    constexpr int reach_px = 2;
    constexpr float sameColour = 0.9F;  // cosine between differences to the tint
    const Color3 offset = colorAt(picture, x, y);
    Color3 core = offset;
    for (int v = std::max(0, y - reach_px); v <= std::min(picture.height_px - 1, y + reach_px); ++v)
      for (int u = std::max(0, x - reach_px); u <= std::min(picture.width_px - 1, x + reach_px); ++u) {
        const Color3 near = colorAt(picture, u, v);
        if (norm(near - tint) > norm(core - tint) &&
            dot(near - tint, offset - tint) >= sameColour * norm(near - tint) * norm(offset - tint))
          core = near;
      }
    return core;
  }
  /// Colour of an area's pixel as it would be on paper: marks cover area and paper alike; the plot's lines
  /// and everything else show through the area.
  Color3 onPaper(Color3 pixel, Color3 tint, Color3 core) const {
    constexpr float alongLines = 0.97F;  // cosine
    const Color3 under = withoutFilm(core, tint) - paper_;
    if (!isMark(core, tint) || dot(under, lineDirection_) > alongLines * norm(under))
      return withoutFilm(pixel, tint);
    const float share = norm(pixel - tint) / std::max(1.0F, norm(core - tint));
    return paper_ + share * (core - paper_);
  }

  /// Colour without a film of this tint over the paper.
  Color3 withoutFilm(Color3 pixel, Color3 tint) const { return onOtherBackground(pixel, tint, paper_); }
  /// Colour under such a film.
  Color3 underFilm(Color3 pixel, Color3 tint) const { return onOtherBackground(pixel, paper_, tint); }

  /// Colour over another background: a light background shines through, a dark one adds its light.
  Color3 onOtherBackground(Color3 pixel, Color3 from, Color3 to) const {
    const auto channel = [this](float p, float offset, float other) {
      return light_ ? p * other / std::max(1.0F, offset)
                    : 255 - (255 - p) * (255 - other) / std::max(1.0F, 255 - offset);
    };
    return {channel(pixel.r, from.r, to.r), channel(pixel.g, from.g, to.g), channel(pixel.b, from.b, to.b)};
  }

  void put(int x, int y, Color3 c) {
    const Rgb levels = rgbOf(c);
    rgb_.at<cv::Vec3b>(y, x) = {levels.r, levels.g, levels.b};
  }

  Raster& raster_;
  Color3 paper_;
  bool light_;        ///< light paper with darker marks
  cv::Mat rgb_;       ///< the raster's own pixels
  cv::Mat contrast_;  ///< distance from the paper, colour levels
  cv::Mat even_;
  std::vector<Color3> means_;  ///< of the large areas
  Color3 lineDirection_;
};

}  // namespace

bool liftTintedAreas(Raster& raster, Color3 paper, const std::function<Color3()>& lineDirection) {
  return TintedAreas(raster, paper).lift(lineDirection);
}

}  // namespace detent::importer::trace
