// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One reading of a table: which columns, which units, which records.

#include <optional>
#include <string>
#include <vector>

#include "importer/evidence/evidence.h"
#include "importer/log/data_columns.h"
#include "model/stroke_curve.h"

namespace detent::importer {

/// One press, with its release if there is one; mm and N, in the order travelled.
struct LogRecord {
  std::string name;  ///< name in the file; may be empty
  std::vector<CurvePoint> press, release;
};

/// Columns that belong together, as positions in DataTable::columns.
struct ColumnGroup {
  std::size_t displacement = 0, force = 0;
  std::optional<Stroke> stroke;  ///< set if the columns hold only one stroke
  std::string name;
};

/// A unit as the file or a person gives it, or as it is assumed.
struct AssumedUnit {
  std::string symbol;
  double size = 1;                   ///< mm or N
  std::optional<double> prior = {};  ///< log-likelihood of an assumed unit; nullopt for a stated one
  bool isAssumed() const { return prior.has_value(); }
};

/// One reading of a table.
struct LogInterpretation {
  std::vector<ColumnGroup> groups;
  AssumedUnit xUnit, yUnit;
  Evidence evidence;
  std::vector<LogRecord> records;  ///< never empty in a result; each record has a press
  bool forcesTurned = false, displacementTurned = false, fromRun = false, joined = false;
  std::string reading(const DataTable& data) const;
};

/// The reason why a table holds no force log.
enum class TableLack { none, displacement, force, columns, movement, sortedLoop, strokes };

}  // namespace detent::importer
