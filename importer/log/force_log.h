// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables of force meters as an input, in any kind of file. Interpretations compete for the columns
// (interpret_columns.h). JSON and projects that keep strokes apart: recorded_switches.h.

#include <map>
#include <string>
#include <vector>

#include "importer/evidence/evidence.h"
#include "importer/page/progress.h"
#include "importer/strokes/stroke_pair.h"

namespace detent::importer {

/// Columns of a table by the words of their titles or by number, from 1; empty: found.
struct ColumnHints {
  std::string displacement, force, releaseDisplacement, releaseForce, stroke, cycle;
  bool operator==(const ColumnHints&) const = default;
};

struct LogHints {
  std::optional<LengthUnit> xUnit;
  std::optional<ForceUnit> yUnit;
  bool swapStrokes = false;
  std::string curve = {};  ///< of several records or switches in a file: name, number from 1, or "mean"
  ColumnHints columns = {};
  std::string releasePath = {};  ///< a second file, of the release alone; empty: none
};

/// Speed of a recorded stroke: the mean from 10 to 90 % of the travel, and the ratio of the faster half of
/// that to the slower one.
struct StrokeSpeed {
  double mean_mm_per_s = 0;  ///< > 0
  double uneven = 1;         ///< >= 1
};

struct ForceLog {
  StrokePair strokes;
  std::string xUnit, yUnit;                                ///< as found
  double preload_N = 0;                                    ///< offset removed (or 0)
  double noise_mm = 0, noise_N = 0;                        ///< estimated from the samples
  std::optional<double> operatingPoint_mm, resetPoint_mm;  ///< only if the file states them
  /// Of the first press and of the release after it; empty without a column of times.
  std::optional<StrokeSpeed> pressSpeed, releaseSpeed;
  long rowsRead = 0, rowsSkipped = 0;
  double confidence = 1;  ///< margin to the best other reading that gives a different button
  std::vector<Remark> remarks;
};

/// One record of a file, for --list.
struct ListedRecord {
  std::string name;  ///< may be empty
  double travel_mm = 0, highest_N = 0;
  bool release = false;
};

/// Result of reading a log.
struct LogReading {
  Result<ForceLog> log;
  std::vector<ListedRecord> records;               ///< of the best interpretation
  std::vector<ExplainedInterpretation> best = {};  ///< at most three
  std::optional<Question> question =
      {};  ///< only if `log` is a Failure notCertain; its choices are not tried here
};

/// Returns true if a file is a table, a spreadsheet, JSON or TAR by its content; by its ending where it
/// cannot be read.
bool isForceLogPath(const std::string& path);

LogReading readLog(const std::string& path, const LogHints& hints = {}, const Progress& progress = {});

/// The log of readLog alone.
Result<ForceLog> readForceLog(const std::string& path, const LogHints& hints = {},
                              const Progress& progress = {});

/// The files of releases by those of the presses that they belong to: in one folder, named alike but for the
/// word of the stroke ("NAME.downstroke.csv", "NAME.upstroke.csv").
std::map<std::string, std::string> pairedFiles(const std::vector<std::string>& paths);

/// A path without the word of a stroke that stands at the end of its name; as it is where none does.
std::string withoutStrokeWord(const std::string& path);

/// Names of the records of a file, as `curve` takes their numbers; empty ones where it gives none, none where
/// it is no log.
std::vector<std::string> recordNames(const std::string& path);

}  // namespace detent::importer
