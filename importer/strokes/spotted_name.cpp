// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/spotted_name.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <opencv2/imgproc.hpp>

#include "importer/page/drawn_words.h"
#include "importer/page/same_colour.h"

namespace detent::importer {
namespace {

constexpr double kLeastLike = 0.72;   // least correlation of a name with the picture
constexpr double kLeastApart = 0.03;  // least difference to the best place of any other switch
constexpr double kBlur_px = 0.7;      // tolerance for the different strokes of two typefaces

Rgb rgbAt(const Raster& picture, int x, int y) {
  const std::uint8_t* const p = picture.at(x, y);
  return {p[0], p[1], p[2]};
}

/// The most frequent colour, in steps of sixteen levels.
Rgb paperOf(const Raster& picture) {
  std::vector<int> seen(4096, 0);
  const auto shade = [](Rgb c) { return (c.r >> 4) << 8 | (c.g >> 4) << 4 | c.b >> 4; };
  for (int y = 0; y < picture.height_px; y += 2)
    for (int x = 0; x < picture.width_px; x += 2)
      ++seen[static_cast<std::size_t>(shade(rgbAt(picture, x, y)))];
  const int most = static_cast<int>(std::ranges::max_element(seen) - seen.begin());
  const auto level = [&](int shift) { return static_cast<std::uint8_t>((most >> shift & 15) * 16 + 8); };
  return {level(8), level(4), level(0)};
}

/// Distance of each pixel from the paper, in colour levels.
cv::Mat darkMaskOf(const Raster& picture) {
  const Rgb paper = paperOf(picture);
  cv::Mat marks(picture.height_px, picture.width_px, CV_32F);
  for (int y = 0; y < marks.rows; ++y)
    for (int x = 0; x < marks.cols; ++x)
      marks.at<float>(y, x) = static_cast<float>(colorDistance(rgbAt(picture, x, y), paper));
  return marks;
}

/// The picture cut to the bounding box of its dark pixels; empty without any.
cv::Mat cutToMarks(const cv::Mat& marks) {
  const cv::Rect at = cv::boundingRect(cv::Mat(marks > 100));
  return at.empty() ? cv::Mat{} : marks(at).clone();
}

struct Place {
  Box box;
  double like = -1;
};

/// Places on a picture where a name may stand, the most similar one first, without overlaps.
std::vector<Place> placesOf(const cv::Mat& name, const cv::Mat& marks) {
  constexpr int least_px = 8, most_px = 40;  // height of the writing
  constexpr int eachSize = 4;                // places kept per size
  std::vector<Place> all;
  cv::Mat page;
  cv::GaussianBlur(marks, page, {}, kBlur_px);
  for (int height = least_px; height <= most_px; height += std::max(1, height / 12)) {
    const int width = static_cast<int>(std::lround(static_cast<double>(name.cols) / name.rows * height));
    if (width < 4 || width >= page.cols - 4 || height >= page.rows - 4) continue;
    constexpr int rim = 1;  // paper around the name is compared too
    cv::Mat word, alike;
    cv::resize(name, word, {width, height}, 0, 0, cv::INTER_AREA);
    cv::copyMakeBorder(word, word, rim, rim, rim, rim, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::GaussianBlur(word, word, {}, kBlur_px);
    cv::matchTemplate(page, word, alike, cv::TM_CCOEFF_NORMED);
    for (int n = 0; n < eachSize; ++n) {
      double like = 0;
      cv::Point at;
      cv::minMaxLoc(alike, nullptr, &like, nullptr, &at);
      all.push_back(
          {{double(at.x + rim), double(at.y + rim), double(at.x + rim + width), double(at.y + rim + height)},
           like});
      cv::rectangle(alike, cv::Rect(at.x - width / 2, at.y - height / 2, width, height), cv::Scalar(-1),
                    cv::FILLED);
    }
  }
  std::ranges::sort(all, std::greater<>{}, &Place::like);
  std::vector<Place> apart;
  for (const Place& each : all)
    if (std::ranges::none_of(apart, [&](const Place& other) { return each.box.touches(other.box); }))
      apart.push_back(each);
  return apart;
}

/// Columns from a word to the nearest pixel of a switch's curves at the same height; empty if none is near.
std::optional<int> columnsTo(const PlotSwitch& plotSwitch, const std::vector<CurveTrace>& traces,
                             const Box& word, const Raster& picture) {
  constexpr double reach = 4, band = 0.3;  // in heights of the word
  const int most = static_cast<int>(reach * word.height());
  const auto isIts = [&](int x) {
    for (int y = static_cast<int>(word.middle().y - band * word.height());
         y <= static_cast<int>(word.middle().y + band * word.height()); ++y)
      for (const std::size_t t : plotSwitch.traces)
        if (hasColour(picture, traces[t].color, x, y)) return true;
    return false;
  };
  for (int by = 2; by <= most; ++by)
    if (isIts(static_cast<int>(word.x0) - by) || isIts(static_cast<int>(word.x1) + by)) return by;
  return {};
}

/// Returns true if a curve runs through a word, which makes it resemble another one.
bool isRunThrough(const Box& word, const std::vector<CurveTrace>& traces) {
  constexpr double rim_px = 2;
  return std::ranges::any_of(traces, [&](const CurveTrace& trace) {
    return std::ranges::any_of(trace.points_px,
                               [&](Point p) { return word.grown(rim_px, rim_px).contains(p); });
  });
}

/// Returns true if the writing has the colour of a curve, so that the colour beside a name is no key.
bool hasItsColour(const Box& word, const PlotSwitch& plotSwitch, const std::vector<CurveTrace>& traces,
                  const Raster& picture) {
  for (int y = static_cast<int>(word.y0); y < static_cast<int>(word.y1); ++y)
    for (int x = static_cast<int>(word.x0); x < static_cast<int>(word.x1); ++x)
      for (const std::size_t t : plotSwitch.traces)
        if (hasColour(picture, traces[t].color, x, y)) return true;
  return false;
}

/// The switch beside which a name stands.
std::optional<std::size_t> nearestTo(const std::vector<PlotSwitch>& switches,
                                     const std::vector<CurveTrace>& traces, const Box& word,
                                     const Raster& picture) {
  std::optional<std::size_t> nearest;
  int columns = 0;
  bool tied = false;
  for (std::size_t i = 0; i < switches.size(); ++i) {
    if (hasItsColour(word, switches[i], traces, picture)) return {};
    const auto to = columnsTo(switches[i], traces, word, picture);
    if (!to || (nearest && *to > columns)) continue;
    tied = nearest && *to == columns;
    nearest = i;
    columns = *to;
  }
  return tied ? std::nullopt : nearest;
}

bool isAscii(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

}  // namespace

std::optional<std::size_t> switchSpotted(const std::vector<PlotSwitch>& switches,
                                         const std::vector<CurveTrace>& traces, const Raster& picture,
                                         const std::string& requested) {
  constexpr int drawn_px = 64;
  if (isAscii(requested) || switches.size() < 2 || picture.empty()) return {};
  const auto drawn = wordsDrawn(requested, drawn_px);
  if (!drawn) return {};
  const cv::Mat name = cutToMarks(darkMaskOf(*drawn));
  if (name.empty()) return {};
  const std::vector<Place> positions = placesOf(name, darkMaskOf(picture));
  // A legend contains a switch's name once for each of its strokes.
  std::optional<std::size_t> found;
  for (const Place& place : positions) {
    if (place.like < kLeastLike || place.like < positions.front().like - kLeastApart) break;
    const auto plotSwitch =
        isRunThrough(place.box, traces) ? std::nullopt : nearestTo(switches, traces, place.box, picture);
    if (!plotSwitch || (found && *found != *plotSwitch)) return {};
    found = plotSwitch;
  }
  return found;
}

}  // namespace detent::importer
