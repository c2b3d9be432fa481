// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Both strokes of a loop on the work plane. Each path is the best one given the other: pixels taken by one
// stroke are worth little to the other, so that together they take all strong pixels. Then the union is
// separated into the upper (press) and the lower (release) one.

#include <vector>

#include "importer/trace/loop_path.h"
#include "importer/trace/loop_structure.h"

namespace detent::importer::trace {

struct PlanePair {
  std::vector<Point> press;    ///< plane px, x never decreases, at most 1 px apart; empty if nothing was
                               ///< found
  std::vector<Point> release;  ///< in the same order as press (not the order travelled); empty: press only
  bool dashed = false;         ///< gaps were accepted as part of a stroke
  bool locked = false;         ///< the release ends on the press near zero force, farther in
  bool bottomOutsCut = false;  ///< a stroke ends where its bottom-out continues in dashes
  double ownRelease_px = 0;    ///< length of pixels that only the second stroke explains
  double further_px = 0;       ///< travel of the best curve in the remaining pixels
  /// that curve climbs to the tops of both strokes like a bottom-out: of another switch, or of these
  /// strokes
  bool bottomOutLeftOver = false;
  bool leftItsLine = false;  ///< a stroke crosses paper although its line continues elsewhere
};

PlanePair findPair(const Structure& structure, const WorkPlane& plane);

/// Separates two paths that may touch and cross: first the one to the left of the direction of travel (higher
/// force; earlier on a bottom-out), then the other. Paths closer than `contact_px` touch.
std::pair<std::vector<Point>, std::vector<Point>> partUpperLower(const std::vector<Point>& a,
                                                                 const std::vector<Point>& b,
                                                                 double contact_px);

}  // namespace detent::importer::trace
