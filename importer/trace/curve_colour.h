// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Coverage by the colour of one curve on the plot area, and the thickness of its lines. Private to
// importer/trace.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

/// A colour or a difference of colours, 8-bit sRGB scale.
struct Color3 {
  float r = 0, g = 0, b = 0;

  friend Color3 operator+(Color3 p, Color3 q) { return {p.r + q.r, p.g + q.g, p.b + q.b}; }
  friend Color3 operator-(Color3 p, Color3 q) { return {p.r - q.r, p.g - q.g, p.b - q.b}; }
  friend Color3 operator*(float s, Color3 p) { return {s * p.r, s * p.g, s * p.b}; }
  friend float dot(Color3 p, Color3 q) { return p.r * q.r + p.g * q.g + p.b * q.b; }
  friend float norm(Color3 p) { return std::sqrt(dot(p, p)); }
};

inline Color3 colorAt(const Raster& raster, int x, int y) {
  const std::uint8_t* p = raster.at(x, y);
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

inline Rgb rgbOf(Color3 c) {
  const auto level = [](float v) { return static_cast<std::uint8_t>(std::clamp(v + 0.5F, 0.0F, 255.0F)); };
  return {level(c.r), level(c.g), level(c.b)};
}

inline Color3 color3Of(Rgb c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

/// Returns true for paper on which curves are darker.
inline bool isLight(Color3 paper) { return paper.r + paper.g + paper.b > 382; }  // half of white

struct PaletteColour {
  Color3 direction;      ///< unit vector, colour minus paper
  float strength = 0;    ///< distance of the full colour from the paper, colour levels
  double mass_px = 0;    ///< pixels of full coverage
  bool isCurve = false;  ///< draws a curve; if several mixtures explain a pixel, one of curves is likelier

  Color3 difference() const { return strength * direction; }
};

inline constexpr double kSameColourAngle =
    0.985;  // cosine between two differences to the paper of one colour

/// The palette entry of a colour on a given paper.
PaletteColour paletteColourOf(Rgb color, Color3 paper);

/// Coverage across a line: its sum and centroid.
struct CoverageAcross {
  double thickness_px = 0;
  double middle = 0;
};

/// Coverage of the area's pixels by one curve's colour, including lines and letters of that colour.
class ColourOnArea {
 public:
  /// `strength`: distance of the full colour from the paper, colour levels.
  ColourOnArea(Plane coverage, float strength) : coverage_(std::move(coverage)), strength_(strength) {}

  /// Returns true if the colour differs clearly from the paper.
  bool distinct() const { return strength_ > 40; }
  /// Coverage, 0..1; 0 outside the area and in other colours.
  float at(int x, int y) const { return coverage_.inside(x, y) ? coverage_.at(x, y) : 0.0F; }
  /// The run of coverage at the place, or within two pixels of it, across a vertical or a horizontal line.
  CoverageAcross across(double x, double y, bool plumb) const;
  /// Thickness of a line along these points, area px; 0 if it is not visible.
  double thicknessAlong(const std::vector<Point>& points) const;

 private:
  Plane coverage_;
  float strength_ = 0;
};

/// Coverage along a column of the area.
class PlumbLane {
 public:
  PlumbLane(const ColourOnArea& coverage, const PlotArea& area, double x)
      : colour_(coverage), area_(area), x_(x) {}

  /// Thicknesses of the rows between two rows, without horizontal lines of the plot.
  std::vector<double> rows(double y0, double y1) const;
  /// The row up to which every row from the start on has at least `least_px`, allowing gaps of `gap_px`.
  double top(double baseline, double least_px, double gap_px) const;
  /// Sub-pixel position of the lane's coverage between two rows.
  double middle(double y0, double y1) const;

 private:
  bool onLevelLine(double y) const;

  const ColourOnArea& colour_;
  const PlotArea& area_;
  double x_;
};

}  // namespace detent::importer::trace
