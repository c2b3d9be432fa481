// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The result drawn back over the page, to check the import by eye.

#include "importer/strokes/stroke_pair.h"
#include "model/button.h"

namespace detent::importer {

struct GraphEvidence;

/// Frame, ticks with the values read, traced points, fitted curves, tactile points and unexplained marks over
/// the (paled) view, enlarged so that one curve pixel is visible. Any thread.
Raster drawOverlay(const GraphEvidence& evidence, const StrokePair& strokes, const Button& button);

/// Evidence of a refused import: frame, ticks, traced curves, and the marks that none of it explains.
Raster drawOverlay(const GraphEvidence& evidence);

}  // namespace detent::importer
