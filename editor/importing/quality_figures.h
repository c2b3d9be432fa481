// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measured cost and error of each quality level.

#include <QString>

#include "importer/importer.h"

namespace detent::editor {

/// Figures of one level: docs/measurements/trade.md, "Importer: level of quality"; tests/bench/trade_test.py
/// fails where they differ.
struct QualityFigures {
  importer::Quality quality = importer::Quality::standard;
  double workOfDraft = 1;          ///< instructions of one whole import, as a multiple of a draft's
  double error_percentOfSpan = 0;  ///< median distance of the fitted graph from the true one
};

QualityFigures figuresOf(importer::Quality quality);
/// "Standard – 1.2 × the work of a draft, error 0.07 % of the axis".
QString describedQuality(importer::Quality quality);

}  // namespace detent::editor
