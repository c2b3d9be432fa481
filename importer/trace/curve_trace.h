// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Step 4: from pixels to ordered sub-pixel polylines, without grid, text, arrows and legend.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "importer/axes/axis_calibration.h"
#include "importer/page/progress.h"

namespace detent::importer {

namespace trace {
class PlotScene;
}

/// Separator between several legend texts of one colour.
inline constexpr std::string_view kLabelParting = " / ";

/// One traced curve in view pixels, ordered along the line.
struct CurveTrace {
  std::vector<Point> points_px;
  std::vector<double> width_px;  ///< local line width, same length; empty for vector paths
  Rgb color;
  bool fromVector = false;  ///< taken from the document's own paths: exact
  double confidence = 0;
  std::size_t errorBars = 0;  ///< on the plot's curves, left out
  /// Set for graphs whose strokes share one colour, where the tracer separates them.
  std::optional<Stroke> stroke;
  std::string label;  ///< legend text of this colour or dash pattern, if any; several separated by " / "
  Box labelBox_px;    ///< position of the label, view pixels, also if it was not read; empty without one
};

/// Colour as "#2a6099".
std::string nameOf(Rgb color);
/// "#2a6099" or "2a6099"; nullopt for anything else.
std::optional<Rgb> colorFrom(std::string_view text);

struct TraceHints {
  std::optional<Rgb> pressColor, releaseColor;
  std::vector<Box> masks_px;  ///< regions to ignore, view pixels

  bool operator==(const TraceHints&) const = default;
};

struct TraceOptions {
  double pointSpacing_px = 1;  ///< along the curve; (0, 16]
};

/// `scene`: of the view, made with the axes' texts and the hints' masks.
Result<std::vector<CurveTrace>> traceCurves(const PageView& view, const trace::PlotScene& scene,
                                            const AxesFound& axes, const TraceHints& hints = {},
                                            const TraceOptions& options = {}, const Progress& progress = {});

}  // namespace detent::importer
