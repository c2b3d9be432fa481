// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The other way in: a force meter's CSV. Columns and units as instruments write them; strokes split at the
// turning point. Spreadsheets and JSON that keep strokes apart: recorded_switches.h.

#include <string>
#include <vector>

#include "importer/page/progress.h"
#include "importer/strokes/stroke_pair.h"

namespace detent::importer {

struct LogHints {
  std::optional<LengthUnit> xUnit;
  std::optional<ForceUnit> yUnit;
  bool swapStrokes = false;
  std::string curve = {};  ///< of several switches in a file: name, or number from 1
};

/// How fast a recorded stroke was travelled: mean from 10 to 90 % of the travel, and how much faster one half of that was than the other.
struct StrokeSpeed {
  double mean_mm_per_s = 0;  ///< > 0
  double uneven = 1;         ///< >= 1
};

struct ForceLog {
  StrokePair strokes;
  std::string xUnit, yUnit;                                ///< as found
  double preload_N = 0;                                    ///< offset removed (or 0)
  double noise_mm = 0, noise_N = 0;                        ///< estimated from the samples
  std::optional<double> operatingPoint_mm, resetPoint_mm;  ///< where the file says them
  /// Of the first press and of the release after it; empty without a column of times.
  std::optional<StrokeSpeed> pressSpeed, releaseSpeed;
  long rowsRead = 0, rowsSkipped = 0;
  std::vector<Remark> remarks;
};

/// Whether the importer takes a path for a force log, by its ending: .csv, .ods, .json, .tar.
bool isForceLogPath(const std::string& path);

/// Failure notCertain: the file holds several switches and `curve` names none of them.
Result<ForceLog> readForceLog(const std::string& path, const LogHints& hints = {},
                              const Progress& progress = {});

}  // namespace detent::importer
