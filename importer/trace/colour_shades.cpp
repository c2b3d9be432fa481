// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/colour_shades.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "importer/page/quantile.h"
#include "importer/trace/plot_lines.h"

namespace detent::importer::trace {

namespace {

constexpr float kMostStrength = 0.8F;      // share of the colour's strength, for a paler line
constexpr float kMaxShadeCoverage = 1.2F;  // coverage, as in unmix

cv::Mat square(int reach_px) {
  return cv::getStructuringElement(cv::MORPH_RECT, {2 * reach_px + 1, 2 * reach_px + 1});
}

/// 255 on lines that reach `level`, with their soft edges.
cv::Mat linesReaching(const cv::Mat& marks, float level) {
  constexpr int between_px = 3;   // thin lines lie between two pixels for a while
  constexpr double fading = 0.6;  // paler pixels beside an edge are its blur
  cv::Mat lines;
  cv::morphologyEx(marks >= level, lines, cv::MORPH_CLOSE, square(between_px));
  cv::dilate(lines, lines, square(1));
  cv::Mat edge = cv::Mat::zeros(marks.size(), CV_32F);
  marks.copyTo(edge, lines);
  cv::dilate(edge, edge, square(1));
  lines |= marks < fading * edge;
  return lines;
}

/// Extends the last point of `line` beside `other`, whose last point is its end on this side.
void leadOn(std::vector<Point>& line, std::vector<double>& widths, const std::vector<Point>& other,
            double within_px) {
  constexpr std::size_t stepsBack = 6;  // points back, a pixel apart
  constexpr double sameWay = 0.85;      // cosine
  const Point end = line.back();
  const auto nearest = std::ranges::min_element(other, {}, [&](Point p) { return distance(p, end); });
  const auto left = static_cast<std::size_t>(other.end() - nearest);
  if (distance(*nearest, end) > within_px || left <= stepsBack || line.size() <= stepsBack) return;
  const Point own = end - line[line.size() - 1 - stepsBack], nearestStep = *(nearest + stepsBack) - *nearest;
  if (dot(own, nearestStep) < sameWay * norm(own) * norm(nearestStep)) return;
  const Point beside = end - *nearest;
  for (std::size_t i = 1; i < left; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(left - 1);
    line.push_back(*(nearest + static_cast<std::ptrdiff_t>(i)) + (1 - share) * beside);
    widths.push_back(widths.back());
  }
}

}  // namespace

bool areShades(const PaletteColour& a, const PaletteColour& b) {
  constexpr float same = 0.99999F;  // cosine; a shade has its colour's direction by construction
  return dot(a.direction, b.direction) > same;
}

float ridgeLevel(const Plane& plane) {
  constexpr double core = 0.85;  // quantile; thin lines lie between pixels here and there
  const cv::Mat all = matOf(plane);
  cv::Mat highest;
  cv::dilate(all, highest, square(1));
  std::vector<float> ridges;
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x)
      if (plane.at(x, y) > 0 && plane.at(x, y) >= highest.at<float>(y, x)) ridges.push_back(plane.at(x, y));
  return ridges.empty() ? 0 : quantileOf(std::move(ridges), core);
}

void clearStrongLines(Plane& plane) {
  cv::Mat values = matOf(plane);
  values.setTo(0, linesReaching(values, kMostStrength));
}

std::optional<PaletteColour> palerShade(const PlotScene& scene, const PaletteColour& colour,
                                        const Plane& coverage, double leastMass_px) {
  const float leastLevel = scene.coverageThreshold() / std::max(1.0F, colour.strength);
  Plane rest = coverage;
  clearStrongLines(rest);
  double mass = 0;
  for (int y = 0; y < rest.height; ++y)
    for (int x = 0; x < rest.width; ++x) {
      float& level = rest.at(x, y);
      if (level < leastLevel || scene.onLine(x, y)) level = 0;
      mass += static_cast<double>(level);
    }
  const float level = ridgeLevel(rest);
  if (!(level > 0) || mass < leastMass_px * static_cast<double>(level)) return {};
  PaletteColour paler = colour;
  paler.strength *= level;
  paler.mass_px = mass / static_cast<double>(level);
  return paler;
}

void clearPlotLines(std::vector<Plane>& coverage, const std::vector<PaletteColour>& colours,
                    const PlotScene& scene, const std::vector<Box>& boxes) {
  for (std::size_t k = 0; k < colours.size(); ++k) {
    const auto isStronger = [&](const PaletteColour& other) {
      return areShades(other, colours[k]) && other.strength > colours[k].strength;
    };
    if (std::ranges::none_of(colours, isStronger)) continue;
    Plane& pale = coverage[k];
    for (const PixelAt p : dottedLines(ColourOnArea(pale, colours[k].strength), scene)) pale.at(p.x, p.y) = 0;
    for (const Box& box : boxes)
      for (int y = static_cast<int>(box.y0); y <= static_cast<int>(box.y1); ++y)
        for (int x = static_cast<int>(box.x0); x <= static_cast<int>(box.x1); ++x)
          if (pale.inside(x, y)) pale.at(x, y) = 0;
  }
}

void leadBeside(CurveTrace& paler, const CurveTrace& stronger) {
  constexpr double edge_px = 2.5;  // of a line's blur, as assumed for the stronger one
  if (paler.points_px.empty() || stronger.points_px.empty()) return;
  const double within_px =
      0.5 * (quantileOf(paler.width_px, 0.5) + quantileOf(stronger.width_px, 0.5)) + edge_px;
  std::vector<Point> other = stronger.points_px;
  for ([[maybe_unused]] const bool last : {true, false}) {
    leadOn(paler.points_px, paler.width_px, other, within_px);
    std::ranges::reverse(paler.points_px), std::ranges::reverse(paler.width_px), std::ranges::reverse(other);
  }
}

void partShades(std::vector<Plane>& coverage, const std::vector<PaletteColour>& colours) {
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t k = 0; k < colours.size(); ++k) {
      if (i == k || !areShades(colours[i], colours[k]) || colours[k].strength >= colours[i].strength)
        continue;
      const float paler = colours[k].strength / colours[i].strength;
      cv::Mat strong = matOf(coverage[i]), pale = matOf(coverage[k]);
      cv::Mat strongAndPale = strong + paler * pale;
      const cv::Mat ofStrong = linesReaching(strongAndPale, 0.5F * (1 + paler));
      strong.setTo(0), pale.setTo(0);
      strongAndPale.copyTo(strong, ofStrong);
      cv::Mat rest = cv::min(strongAndPale / paler, static_cast<double>(kMaxShadeCoverage));
      rest.copyTo(pale, ~ofStrong);
    }
}

}  // namespace detent::importer::trace
