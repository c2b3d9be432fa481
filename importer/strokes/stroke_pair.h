// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Step 5: decides which trace is the press and which the release; in millimetres and newtons, in the order
// travelled.

#include <string>
#include <vector>

#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Dense points of one stroke in the order travelled (release: decreasing displacement).
struct StrokePoints {
  std::vector<CurvePoint> points;  ///< mm, N
  std::vector<Point> points_px;    ///< the same in view pixels, same length; empty for force logs
  bool fromVector = false;
};

struct StrokePair {
  StrokePoints press;
  std::optional<StrokePoints> release;
};

struct StrokeHints {
  bool swap = false;
  /// name or number of the switch to take if there are several (chosenSwitch); empty: the only one
  std::string curve;
  bool noRelease = false;  ///< the plot shows no release of this button

  bool operator==(const StrokeHints&) const = default;
};

/// A trace as this stroke: in mm and N, in the order travelled.
StrokePoints strokeOf(const CurveTrace& trace, Stroke stroke, const AxisCalibration& calibration);

/// Failure noForceGraph: nothing that could be a press; notCertain: several switches and none chosen, curves
/// that cannot be grouped, or press and release that cannot be separated; wrongUsage: the chosen switch does
/// not exist.
Result<Found<StrokePair>> separateStrokes(const std::vector<CurveTrace>& traces, const AxesFound& axes,
                                          const StrokeHints& hints = {});

}  // namespace detent::importer
