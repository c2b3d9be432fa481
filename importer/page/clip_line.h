// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines cut at the edges of a box.

#include <vector>

#include "importer/page/polyline.h"

namespace detent::importer {

/// The part of segment a-b inside the box, as parameters 0..1; false if none.
bool insideSpan(Point a, Point b, const Box& box, double& from, double& to);

/// The point at parameter t of a-b; exactly a or b at the ends.
Point pointBetween(Point a, Point b, double t);

/// The parts of the polyline inside the box, cut exactly at its edges, in order.
std::vector<Polyline> clippedLine(const Polyline& line, const Box& box);

}  // namespace detent::importer
