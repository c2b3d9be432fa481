// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Fits the press and the release of one button.

#include "importer/graph_findings.h"

namespace detent::importer {

/// Fitted strokes start at 0 mm, where the key is free of force, or later. Points left of 0 mm are noise of
/// axis and trace.
Result<FittedStrokes> fitBoth(const StrokePair& strokes, const FitOptions& press, const FitOptions& release);

}  // namespace detent::importer
