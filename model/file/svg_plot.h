// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button as a datasheet prints it: frame, grid, ticks on round numbers, axis titles, both strokes,
// callouts.

#include <optional>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/units.h"

namespace detent {

/// What stands on a plot, in the language of who reads it; UTF-8.
struct PlotWords {
  std::string displacement = "Displacement", force = "Force", press = "Press", release = "Release";
  std::string tactilePoint = "Tactile point", tactilePointOfRelease = "Tactile point (release)";
  std::string operatingPoint = "Operating point", resetPoint = "Reset point", bottomOut = "Bottom-out";
  std::string at = "at";  ///< between a callout's force and its displacement
  std::string preTravel = "Pre-travel", differentialTravel = "Differential travel";
  std::string unlocked = "unlocked", locked = "locked";  ///< of states that are called so
};

/// Lowest and highest value of an axis, in its unit; lowest < highest.
struct AxisEnds {
  double lowest = 0, highest = 0;
};

struct SvgPlotStyle {
  double width_px = 640,
         height_px = 460;  ///< of one plot; > 200 each. One plot per state, one below the other
  ForceUnit forceUnit = ForceUnit::newton;  ///< of the printed axis
  LengthUnit lengthUnit = LengthUnit::millimetre;
  bool callouts = true;  ///< tactile points, operating and reset point, bottom-out
  PlotWords words;
  char decimalSign = '.';
  /// Press black, release dashed and next to black: one ink to a printer and to the eye, two colours to a program.
  bool monochrome = false;
  bool dimensions = false;  ///< pre-travel and differential travel, where the points they need are there
  std::optional<ForceUnit>
      secondForceUnit;                ///< of a scale at the right side; not in a copy of the first unit
  std::optional<double> tolerance;    ///< a band about the press this share of its forces wide, 0.01..1
  std::optional<double> tolerance_N;  ///< without that: a band so far above and below the press, > 0
  double roomBeyondEnd =
      0;  ///< of the axis: the box goes on so far behind its last tick, or behind the curves
          ///< where that tick lies farther out
  std::optional<AxisEnds> xEnds, yEnds;  ///< instead of those of the curves; what lies outside is cut off
  std::string font = "DejaVu Sans, Arial, Helvetica, sans-serif";  ///< as CSS has it
  double fontSize_px = 12;                                         ///< 6..40; margins go with it
  double lineWidth_px = 2;                                         ///< of the strokes
  std::optional<double> width_mm;  ///< how wide the drawing is printed; without it a px is a CSS pixel
};

/// Ticks on 1, 2 or 5 times a power of ten that enclose [low, high].
struct Ticks {
  double first = 0, step = 1;
  int count = 0;     ///< >= 2
  int decimals = 0;  ///< of the labels
  double at(int i) const;
  double last() const { return at(count - 1); }
};
/// `aboutSteps` >= 2; low <= high, both finite.
Ticks niceTicks(double low, double high, int aboutSteps);

/// Where values of the style's units stand on a plot.
struct PlotFrame {
  double left_px = 0, top_px = 0, right_px = 0, bottom_px = 0;
  Ticks x, y;  ///< from edge to edge

  double xPx(double value) const {
    return left_px + (value - x.first) / (x.last() - x.first) * (right_px - left_px);
  }
  double yPx(double value) const {
    return bottom_px - (value - y.first) / (y.last() - y.first) * (bottom_px - top_px);
  }
};
/// The frame that svgFrom draws for a state that stands first in its button.
PlotFrame frameOfPlot(const ButtonState& state, const SvgPlotStyle& style = {});

/// A whole SVG document. Curves are cubic Béziers: exact, not sampled. Deterministic.
std::string svgFrom(const Button& button, const SvgPlotStyle& style = {});

}  // namespace detent
