// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Step 5: which trace is the press, which the release; in millimetres and newtons, in the order travelled.

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

  bool operator==(const StrokeHints&) const = default;
};

/// Failure noForceGraph: nothing that could be a press; notCertain: more curves than two, or press and
/// release that cannot be told apart.
Result<Found<StrokePair>> separateStrokes(const std::vector<CurveTrace>& traces, const AxesFound& axes,
                                          const StrokeHints& hints = {});

}  // namespace detent::importer
