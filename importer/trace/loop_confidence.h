// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Confidence of a traced loop from signs of a wrong one: path off the curve's pixels, strong pixels left
// over, profiles that are no line, turns that no curve makes.

#include <vector>

#include "importer/trace/loop_refine.h"

namespace detent::importer::trace {

/// All 0..1, 1 is best.
struct LoopEvidence {
  double onCurve = 0;     ///< share of the path on the curve's pixels or on a straight line it crosses
  double explained = 0;   ///< share of long pieces that lie on one of the strokes
  double fit = 0;         ///< mean trust of the refined points
  double steadiness = 0;  ///< decreases with turning beyond that of force curves
  double reach = 0;       ///< share of the frame's width that is covered; full from 55 % on
  double thinness = 0;    ///< decreases with a width that no line has: bands and filled areas
  double together = 0;    ///< share of the travel common to both strokes; full from 70 % on
  double confidence() const;
};

LoopEvidence judge(const PlanePair& pair, const RefinedPair& refined, const Structure& structure,
                   const WorkPlane& plane);

}  // namespace detent::importer::trace
