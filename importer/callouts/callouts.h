// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// "Operating point" and "reset point" as datasheets call them out: a text in the plot and a leader line to
// the curve.

#include <string>
#include <vector>

#include "importer/strokes/stroke_pair.h"

namespace detent::importer {

enum class CalloutKind {
  operatingPoint,  ///< press displacement at which the contact closes
  resetPoint       ///< release displacement at which the contact opens
};

/// One callout that was followed to its curve.
struct Callout {
  CalloutKind kind = CalloutKind::operatingPoint;
  CurvePoint at;          ///< mm, N, on the traced stroke
  Point at_px;            ///< the same in view pixels
  double confidence = 0;  ///< share of the leader that is a thin line, 0..1
  std::string text;
};

/// Callouts whose leader was found; at most one of each kind (the one with the highest confidence). A text
/// without a leader is left out, because its position does not show which point it means.
std::vector<Callout> readCallouts(const PageView& view, const PlotFrame& frame, const AxesFound& axes,
                                  const StrokePair& strokes);

/// Kinds of points that a text inside the plot names, whether or not their place was found; each kind once.
std::vector<CalloutKind> printedCallouts(const PlotFrame& frame, const AxesFound& axes);

}  // namespace detent::importer
