// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Assigns quantities to the columns of a table: every assignment that titles, units and values leave open,
// with its evidence.

#include <optional>
#include <string>
#include <vector>

#include "importer/log/force_log.h"
#include "importer/log/log_interpretation.h"

namespace detent::importer {

struct ColumnReading {
  std::vector<LogInterpretation> best;  ///< the best first; empty where something lacks
  TableLack lack = TableLack::none;
  std::string unknownUnit;  ///< of a column that would be it
  bool unknownUnitOfForce = false;
  std::optional<std::string> badColumn;  ///< a column given by hand that is not there
};

ColumnReading interpretColumns(const Table& table, const DataTable& data, const LogHints& hints,
                               bool eitherStroke = false);

/// The units that a table may have where it says none.
std::vector<AssumedUnit> possibleUnits(bool force);

/// Log-likelihood of units, given a button's travel and highest force. `record` has the units of the file.
Evidence unitEvidence(const LogRecord& record, const AssumedUnit& x, const AssumedUnit& y);

/// Difference of two records: mean distance of their strokes along force, as a share of the first's force
/// span; 1 where one has a stroke that the other has not, or their travels differ by more than a tenth.
double differenceOf(const LogRecord& a, const LogRecord& b);

/// The records' mean, place by place; strokes that all have.
LogRecord meanOf(const std::vector<LogRecord>& records);

}  // namespace detent::importer
