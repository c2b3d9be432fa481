// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button as a datasheet plot: frame, grid, round ticks, axis titles, both strokes, callouts.

#include <optional>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/units.h"

namespace detent {

/// Words on a plot in the reader's language; UTF-8.
struct PlotWords {
  std::string displacement = "Displacement", force = "Force", press = "Press", release = "Release";
  std::string tactilePoint = "Tactile point", tactilePointOfRelease = "Tactile point (release)";
  std::string operatingPoint = "Operating point", resetPoint = "Reset point", bottomOut = "Bottom-out";
  std::string at = "at";  ///< between force and displacement of a callout
  std::string preTravel = "Pre-travel", differentialTravel = "Differential travel";
  std::string unlocked = "unlocked", locked = "locked";  ///< for states with these names
};

/// Lowest and highest value of an axis in its unit; lowest < highest.
struct AxisEnds {
  double lowest = 0, highest = 0;
};

struct SvgPlotStyle {
  double width_px = 640,
         height_px = 460;  ///< of one plot; > 200 each. One plot per state, stacked vertically
  ForceUnit forceUnit = ForceUnit::newton;  ///< of the printed axis
  LengthUnit lengthUnit = LengthUnit::millimetre;
  bool callouts = true;  ///< at tactile points, operating point, reset point and bottom-out
  PlotWords words;
  char decimalSign = '.';
  /// Press black, release dashed and #111: one colour to a printer and the eye, two to a program.
  bool monochrome = false;
  bool dimensions = false;  ///< pre-travel and differential travel, if their points exist
  std::optional<ForceUnit>
      secondForceUnit;                ///< unit of a second scale at the right; none if equal to the first
  std::optional<double> tolerance;    ///< width of a band around the press as a share of its forces, 0.01..1
  std::optional<double> tolerance_N;  ///< half width of a band around the press, > 0; used without
                                      ///< `tolerance`
  /// Share of the axis between the last tick, or the curves if that tick lies farther out, and the frame.
  /// With 0 a bottom-out may lie on the frame, where neither a person nor a program can distinguish them.
  double roomBeyondEnd = 0.04;
  std::optional<AxisEnds> xEnds, yEnds;  ///< axis ranges instead of those of the curves; curves are clipped
  std::string font = "DejaVu Sans, Arial, Helvetica, sans-serif";  ///< CSS font family
  double fontSize_px = 12;                                         ///< 6..40; margins scale with it
  double lineWidth_px = 2;                                         ///< of the strokes
  std::optional<double> width_mm;  ///< printed width; nullopt: a px is a CSS pixel
};

/// Ticks at 1, 2 or 5 times a power of ten that enclose [low, high].
struct Ticks {
  double first = 0, step = 1;
  int count = 0;     ///< >= 2
  int decimals = 0;  ///< of the labels
  double at(int i) const;
  double last() const { return at(count - 1); }
};
/// `aboutSteps` >= 2; low <= high, both finite.
Ticks niceTicks(double low, double high, int aboutSteps);

/// Position of values on a plot, in the style's units.
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
/// Frame that svgFrom draws for the first state of a button.
PlotFrame frameOfPlot(const ButtonState& state, const SvgPlotStyle& style = {});

/// Labels that a small plot leaves out because they would lie over others: "Reset point 0.42 N at 1.3 mm".
std::vector<std::string> labelsWithoutRoom(const Button& button, const SvgPlotStyle& style);

/// Complete SVG document. Curves are exact cubic Béziers. Deterministic.
std::string svgFrom(const Button& button, const SvgPlotStyle& style = {});

}  // namespace detent
