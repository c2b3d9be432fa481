#pragma once
// What each quality level costs and gives, as measured.

#include <QString>

#include "importer/importer.h"

namespace detent::editor {

/// Figures of one level over the corpus' real single graphs: docs/bench-importer.md, "real, single".
struct QualityFigures {
  importer::Quality quality = importer::Quality::standard;
  double median_s = 0;             ///< of one whole import, program start included
  double error_percentOfSpan = 0;  ///< median distance of the fitted graph from the true one
};

QualityFigures figuresOf(importer::Quality quality);
/// "Standard – about 0.9 s, 0.07 % of the axis".
QString describedQuality(importer::Quality quality);

}  // namespace detent::editor
