// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Both strokes of the loop on the work plane. Each path is the best one given the other: ink already taken by
// one stroke is worth little to the other, so that together they take all strong curve ink. Then the union is
// parted into the upper (press) and the lower (release) one.

#include <vector>

#include "importer/trace/loop_path.h"
#include "importer/trace/loop_structure.h"

namespace detent::importer::trace {

struct PlanePair {
  std::vector<Point> press;    ///< plane px, x never falls, at most 1 px apart; empty if nothing was found
  std::vector<Point> release;  ///< the same order as press (not yet the order travelled); empty: press only
  bool dashed = false;         ///< gaps were taken as part of a stroke
  bool locked = false;         ///< the release ends at the press' foot, farther in
  bool wallsCut = false;       ///< a stroke ends where its wall goes on in dashes
  double ownRelease_px = 0;    ///< length of ink that only the second stroke explains
  double further_px = 0;       ///< travel of the best curve in the ink that both leave over
  bool wallLeftOver =
      false;  ///< that curve climbs to the tops of both as a wall: another switch's, or their own
  bool leftItsLine = false;  ///< a stroke crosses paper where the line it came on goes on
};

PlanePair findPair(const Structure& structure, const WorkPlane& plane);

/// Parts two paths that may touch and cross: first the one that lies to the left of the direction of travel
/// (higher force; earlier on a wall), then the other. Paths closer than `contact_px` count as touching.
std::pair<std::vector<Point>, std::vector<Point>> partUpperLower(const std::vector<Point>& a,
                                                                 const std::vector<Point>& b,
                                                                 double contact_px);

}  // namespace detent::importer::trace
