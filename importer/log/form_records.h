// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The rows of chosen columns cut into strokes, and strokes joined to records.

#include <optional>
#include <string>
#include <string_view>

#include "importer/log/log_interpretation.h"

namespace detent::importer {

struct RecordRequest {
  const Table* table = nullptr;
  const DataTable* data = nullptr;
  std::optional<std::size_t> strokeColumn, cycleColumn;  ///< positions in DataTable::columns, given by hand
  bool swap = false;
  bool eitherStroke = false;  ///< the file has one stroke, which counts as the press
};

/// Fills in the records of an interpretation whose columns and units are settled, and adds the evidence of
/// the cuts. TableLack::none: there is at least one record, each with a press of two samples or more.
TableLack formRecords(const RecordRequest& request, LogInterpretation& made);

/// The stroke that a text names; nullopt: none, or both.
std::optional<Stroke> strokeNamedIn(std::string_view text);

/// A name parted into its words for strokes and the others: "Press2 (A)" is "2 A", a press.
struct StrokeName {
  std::string rest;
  std::optional<Stroke> stroke;
};
StrokeName strokeNameOf(std::string_view name);

/// Press and release of points that stand sorted by displacement, as digitizers export a loop: the force goes
/// to and fro.
bool holdsSortedLoop(const std::vector<CurvePoint>& points);

}  // namespace detent::importer
