// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Between strokes and fit, at `precise`: the axes once more, from every place where a line of the plot was
// seen, at one common minimum. In: the axes as read. Out: perspective and bend of the sheet, as far as the
// lines bear evidence of them, with the covariance from which the error of any point follows
// (docs/develop/decisions/0206-axes-from-whole-lines.md). The strokes' own points are no part of the problem:
// they say where a curve runs in the picture, and nothing of where the axes are. What they share no unknown
// with has its minimum apart from theirs. Reading order: sighted_lines.h -> refine_axes.h

#include <array>
#include <optional>

#include "importer/fit/fit_options.h"
#include "importer/page/progress.h"
#include "importer/refine/sighted_lines.h"

namespace detent::importer {

/// Shape of the sheet, from the simplest to the most complex that lines can determine.
enum class SheetShape {
  asRead,  ///< the calibration explains the lines
  tilted,  ///< another perspective
  bent     ///< perspective and bend
};

/// The unknowns of a sheet, about 1 each: eight of the perspective (row-major, its ninth is 1), three of the
/// bend's depth, two of the place it moves from.
struct SheetUnknowns {
  static constexpr int count = 13;
  std::array<double, count> at{};
  Point middle_px, middle_mm_N, half_mm_N;  ///< origin and size of the numbers' scales
  double half_px = 1;

  Point toUnits(Point view_px) const;  ///< mm, N
};

using SheetCovariance = std::array<std::array<double, SheetUnknowns::count>, SheetUnknowns::count>;

struct RefinedAxes {
  AxisCalibration calibration;
  SheetShape shape = SheetShape::asRead;
  int lines = 0, places_ = 0;  ///< seen
  /// Rms distance of the places from their lines, large ones held down (Huber, 1 px), with the axes as read
  /// and as they are now.
  double before_px = 0, after_px = 0;
  PointNoise sigmaAt(Point mm_N) const;  ///< error that all points near this one share, mm and N

  SheetUnknowns unknowns;
  SheetCovariance covariance{};  ///< 0 where nothing was free
};

/// Empty if the lines do not determine it: fewer than two lines of known value, or two seen along their
/// length, on either axis; no picture; cancelled. A twist is fitted only if three lines are seen along their
/// length on both axes. Deterministic. Any thread.
std::optional<RefinedAxes> refineAxes(const PageView& view, const PlotFrame& frame,
                                      const AxisCalibration& calibration, const Progress& progress = {});

}  // namespace detent::importer
