// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far a traced loop can be believed, from what a wrong one gives away: path off the ink, strong ink left
// over, profiles that are no line, turns that no curve makes.

#include <vector>

#include "importer/trace/loop_refine.h"

namespace detent::importer::trace {

/// All 0..1, 1 is best.
struct LoopEvidence {
  double onInk = 0;       ///< share of the path on curve ink or on a straight line it crosses
  double explained = 0;   ///< share of the long left-over ink that lies on one of the strokes
  double fit = 0;         ///< mean trust of the refined points
  double steadiness = 0;  ///< falls with turning beyond what force curves do
  double reach = 0;       ///< share of the frame's width that is covered, full from 55 % on
  double thinness = 0;    ///< falls with a width that no line has: bands and filled areas
  double together = 0;    ///< share of the travel that both strokes run over, full from 70 % on
  double confidence() const;
};

LoopEvidence judge(const PlanePair& pair, const RefinedPair& refined, const Structure& structure,
                   const WorkPlane& plane);

}  // namespace detent::importer::trace
