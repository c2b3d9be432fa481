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

/// Columns of a table, by words of their titles or by number, from 1; an empty one is found.
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
  std::string releasePath = {};  ///< a second file, which holds only the release; empty: none
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
  /// Speeds of the first press and of the release after it; empty without a column of times.
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
  std::vector<ListedRecord> records;               ///< records of the best interpretation
  std::vector<ExplainedInterpretation> best = {};  ///< at most three
  std::optional<Question> question =
      {};  ///< only if `log` is a Failure notCertain; its choices have not been tried
};

/// Returns true if a file's content is a table, a spreadsheet, JSON or TAR; for an unreadable file its ending
/// decides.
bool isForceLogPath(const std::string& path);

LogReading readLog(const std::string& path, const LogHints& hints = {}, const Progress& progress = {});

/// The log that readLog finds, without records and question.
Result<ForceLog> readForceLog(const std::string& path, const LogHints& hints = {},
                              const Progress& progress = {});

/// Files of releases, by the files of their presses: files in one folder with the same name except for the
/// word of the stroke ("NAME.downstroke.csv", "NAME.upstroke.csv").
std::map<std::string, std::string> pairedFiles(const std::vector<std::string>& paths);

/// A path without a stroke's word at the end of its name; other paths unchanged.
std::string withoutStrokeWord(const std::string& path);

/// Names of a file's records, in the order of the numbers that StrokeHints::curve takes. A name is empty if
/// the file has none; no names if the file is no log.
std::vector<std::string> recordNames(const std::string& path);

}  // namespace detent::importer
