// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What each quality level costs and gives, as measured.

#include <QString>

#include "importer/importer.h"

namespace detent::editor {

/// Figures of one level over the corpus' real single graphs: docs/bench-importer.md says how they are
/// measured, docs/decisions/1022-figures-beside-the-quality.md has all three levels.
struct QualityFigures {
  importer::Quality quality = importer::Quality::standard;
  double median_s = 0;             ///< of one whole import
  double error_percentOfSpan = 0;  ///< median distance of the fitted graph from the true one
};

QualityFigures figuresOf(importer::Quality quality);
/// "Standard – about 0.6 s, error 0.06 % of the axis".
QString describedQuality(importer::Quality quality);

}  // namespace detent::editor
