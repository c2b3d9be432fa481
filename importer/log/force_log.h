// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The other way in: a force meter's CSV. Columns and units as instruments write them; strokes split at the
// turning point.

#include <string>
#include <vector>

#include "importer/page/progress.h"
#include "importer/strokes/stroke_pair.h"

namespace detent::importer {

struct LogHints {
  std::optional<LengthUnit> xUnit;
  std::optional<ForceUnit> yUnit;
  bool swapStrokes = false;
};

struct ForceLog {
  StrokePair strokes;
  std::string xUnit, yUnit;          ///< as found
  double preload_N = 0;              ///< offset removed (or 0)
  double noise_mm = 0, noise_N = 0;  ///< estimated from the samples
  long rowsRead = 0, rowsSkipped = 0;
  std::vector<Remark> remarks;
};

Result<ForceLog> readForceLog(const std::string& path, const LogHints& hints = {},
                              const Progress& progress = {});

}  // namespace detent::importer
