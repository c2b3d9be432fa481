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

/// One press, with its release where there is one; mm and N, in the order travelled.
struct LogRecord {
  std::string name;  ///< as the file calls it; may be empty
  std::vector<CurvePoint> press, release;
};

/// Columns that belong together, as positions in DataTable::columns.
struct ColumnGroup {
  std::size_t displacement = 0, force = 0;
  std::optional<Stroke> stroke;  ///< set if the columns hold one stroke alone
  std::string name;
};

/// A unit as the file or a person gives it, or as it is assumed.
struct AssumedUnit {
  std::string symbol;
  double size = 1;                   ///< mm or N
  std::optional<double> prior = {};  ///< log-likelihood of an assumed one; nullopt: it is given
  bool isAssumed() const { return prior.has_value(); }
};

/// One reading of a table.
struct LogInterpretation {
  std::vector<ColumnGroup> groups;
  AssumedUnit xUnit, yUnit;
  Evidence evidence;
  std::vector<LogRecord> records;  ///< at least one, with a press; empty: the interpretation gives no record
  bool forcesTurned = false, displacementTurned = false, fromRun = false, joined = false;
  std::string reading(const DataTable& data) const;
};

/// Why a table holds no force log, in the words of its titles.
enum class TableLack { none, displacement, force, columns, movement, sortedLoop, strokes };

}  // namespace detent::importer
