// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds the two strokes of one switch among several curves without names: they close a loop.
// docs/develop/decisions/0701-several-switches.md

#include <cstddef>
#include <vector>

#include "importer/page/polyline.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Returns true if the force falls monotonically from a trace's left end to its right one. No stroke of a
/// button does: it begins where the finger meets the key and ends at the bottom-out. `trace` of two points or
/// more.
bool onlyFalls(const CurveTrace& trace);

/// Smaller distance of one line's end from the other line. `endOfA`, `endOfB`: points of the lines.
double gapAtTheEnds(const Polyline& a, Point endOfA, const Polyline& b, Point endOfB);

/// The curves that close loops, one pair for each switch, the upper one first: both begin and end together,
/// and the upper one lies above along the whole travel. `drawn` are indices of traces of two points or more.
/// Empty if a curve that is not falling monotonically belongs to no loop, or may belong to two because two
/// samples of one switch end near each other.
std::vector<std::vector<std::size_t>> closedLoops(const std::vector<CurveTrace>& traces,
                                                  const std::vector<std::size_t>& drawn);

/// Returns true if two curves are strokes of one switch by their paths alone: they begin and end in one
/// point, and one lies above the other all the way. Two presses have separate bottom-outs
/// (docs/develop/decisions/0814-unseen-styles.md).
bool closeInOnePoint(const CurveTrace& first, const CurveTrace& second);

/// One group for each curve, if every curve has its own colour and no two of them can be the strokes of one
/// switch: they cross, or, of three or more, end apart. Empty otherwise, and if a curve is too short for a
/// stroke or falls monotonically.
std::vector<std::vector<std::size_t>> pressesApart(const std::vector<CurveTrace>& traces,
                                                   const std::vector<std::size_t>& drawn);

}  // namespace detent::importer
