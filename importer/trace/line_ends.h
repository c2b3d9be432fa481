// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a traced line really ends: its caps trimmed, its last pixel found, and cut or carried on to the
// frame.

#include "importer/trace/centre_line.h"

namespace detent::importer::trace {

/// Ends measured along the line's own direction; a line that reaches the frame's edge is carried on to it,
/// one that leaves the frame is cut there.
void finishEnds(CentreLine& line, const CurveField& field, const Box& frame);

}  // namespace detent::importer::trace
