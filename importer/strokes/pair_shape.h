// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The shape of two traced curves beside each other, by which strokes of one switch differ from two presses.
// docs/develop/decisions/0701-several-switches.md

#include "importer/page/polyline.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// A trace from left to right, with its bounding box.
struct CurvePath {
  explicit CurvePath(const CurveTrace& trace);

  Polyline points_px;
  Box room_px;
};

/// Lengths are shares of the box around both curves; signed ones are positive if the first curve's is the
/// larger displacement or force.
struct PairShape {
  double startsApart = 0, startForces = 0;  ///< of the left ends: along the travel, in force
  double reachesApart = 0;                  ///< of the right ends, signed
  double topsApart = 0;                     ///< of the largest forces, signed
  double gap = 0;                           ///< smaller distance of a far end from the other curve
  double above = 0, below = 0;        ///< share of the common travel where the first is seen above or below
  double farAbove = 0, farBelow = 0;  ///< the same, by more than two strokes of one switch cross
  double dropsLater = 0;              ///< of the ends of the largest drops, signed; 0 unless both drop
  double oneShape = 0;  ///< share of their difference that a scale and a shift explain; 0 unless both drop
};

PairShape shapeOf(const CurvePath& first, const CurvePath& second);

/// Returns true if the force falls monotonically from a path's left end to its right one. No stroke of a
/// button does: it begins where the finger meets the key and ends at the bottom-out.
bool onlyFalls(const CurvePath& path);

}  // namespace detent::importer
