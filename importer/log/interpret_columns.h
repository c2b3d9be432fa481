// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Assigns quantities to the columns of a table: every assignment that titles, units and values allow, with
// its evidence.

#include <optional>
#include <string>
#include <vector>

#include "importer/log/force_log.h"
#include "importer/log/log_interpretation.h"

namespace detent::importer {

struct ColumnReading {
  std::vector<LogInterpretation> best;  ///< the best first; empty if a quantity is missing
  TableLack lack = TableLack::none;
  std::string unknownUnit;  ///< unit of the column that would have been taken
  bool unknownUnitOfForce = false;
  std::optional<std::string> badColumn;  ///< a column given by hand that does not exist
};

ColumnReading interpretColumns(const Table& table, const DataTable& data, const LogHints& hints,
                               bool eitherStroke = false);

/// Possible units of a table that states none.
std::vector<AssumedUnit> possibleUnits(bool force);

/// Evidence for units by a button's usual travel and highest force. `record` is in the units of the file.
Evidence unitEvidence(const LogRecord& record, const AssumedUnit& x, const AssumedUnit& y);

/// Difference of two records: mean distance of their strokes along force, as a share of the force span of
/// `a`. 1 if only one of them has some stroke, or if their travels differ by more than a tenth.
double differenceOf(const LogRecord& a, const LogRecord& b);

/// Mean of the records at equal shares of their travel; only strokes that all records have.
LogRecord meanOf(const std::vector<LogRecord>& records);

}  // namespace detent::importer
