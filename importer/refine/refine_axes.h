// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Between strokes and fit, at `precise`: refines the axes from all places where a line of the plot is
// visible, in one least-squares problem. In: the axes as read. Out: perspective and bend of the sheet as far
// as the lines determine them, with the covariance from which the error at any point follows
// (docs/develop/decisions/0206-axes-from-whole-lines.md). The strokes' points are not part of the problem:
// they show where a curve lies in the picture, but not where the axes are, and so share no unknown with it.
// Reading order: sighted_lines.h -> refine_axes.h

#include <array>
#include <optional>

#include "importer/fit/fit_options.h"
#include "importer/page/progress.h"
#include "importer/refine/sighted_lines.h"

namespace detent::importer {

/// Shape of the sheet, from the simplest to the most complex that lines can determine.
enum class SheetShape {
  asRead,  ///< no correction: the calibration explains the lines
  tilted,  ///< corrected perspective
  bent     ///< corrected perspective, and bend
};

/// The unknowns of a sheet, each scaled to about 1: eight of the perspective (row-major, the ninth is 1),
/// three of the bend's depth, two of its centre.
struct SheetUnknowns {
  static constexpr int count = 13;
  std::array<double, count> at{};
  Point middle_px, middle_mm_N, half_mm_N;  ///< origin and scale of the normalised coordinates
  double half_px = 1;

  Point toUnits(Point view_px) const;  ///< mm, N
};

using SheetCovariance = std::array<std::array<double, SheetUnknowns::count>, SheetUnknowns::count>;

struct RefinedAxes {
  AxisCalibration calibration;
  SheetShape shape = SheetShape::asRead;
  int lines = 0, places_ = 0;  ///< number of lines, and of places on them, that were seen
  /// Rms distance of the places from their lines, with large distances limited (Huber, 1 px): with the axes
  /// as read, and with the refined ones.
  double before_px = 0, after_px = 0;
  PointNoise sigmaAt(Point mm_N) const;  ///< common error of all points near this one, mm and N

  SheetUnknowns unknowns;
  SheetCovariance covariance{};  ///< 0 if nothing was refined
};

/// Empty if the lines do not determine the axes: on either axis fewer than two lines of known value or fewer
/// than two seen along their length; no picture; cancelled. A twist is fitted only if on both axes three
/// lines are seen along their length. Deterministic. Any thread.
std::optional<RefinedAxes> refineAxes(const PageView& view, const PlotFrame& frame,
                                      const AxisCalibration& calibration, const Progress& progress = {});

}  // namespace detent::importer
