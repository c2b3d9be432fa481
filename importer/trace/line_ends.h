// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The exact ends of a traced line: caps trimmed, last pixel found, cut or extended to the frame.

#include "importer/trace/centre_line.h"

namespace detent::importer::trace {

/// Measures ends along the line's own direction; a line that reaches the frame's edge is extended to it, one
/// that leaves the frame is cut there.
void finishEnds(CentreLine& line, const CurveField& field, const Box& frame);

}  // namespace detent::importer::trace
