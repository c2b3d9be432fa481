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
  bool eitherStroke = false;  ///< the file has one stroke, which is taken as the press
};

/// Fills in the records of an interpretation whose columns and units are decided, and adds the evidence of
/// the cuts. TableLack::none means at least one record, each with a press of at least two samples.
TableLack formRecords(const RecordRequest& request, LogInterpretation& made);

/// The stroke that a text names; nullopt: none, or both.
std::optional<Stroke> strokeNamedIn(std::string_view text);

/// A name divided into its stroke and its other words: "Press2 (A)" is a press named "2 A".
struct StrokeName {
  std::string rest;
  std::optional<Stroke> stroke;
};
StrokeName strokeNameOf(std::string_view name);

/// Returns true if the points of press and release are mixed, sorted by displacement, as digitizers export a
/// loop: the force alternates between both curves.
bool holdsSortedLoop(const std::vector<CurvePoint>& points);

}  // namespace detent::importer
