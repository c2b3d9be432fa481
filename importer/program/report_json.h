// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reports as JSON, in the shape that scripts rely on.

#include <string>
#include <vector>

#include "importer/importer.h"

namespace detent::importer {

/// One object on one line. `input`: as the user wrote it. `outputs`: the files written. `explained`: readings
/// for --explain, the best first: "interpretations": [{"reading", "evidence": [{"name", "about",
/// "log_likelihood"}], "sum"}].
std::string reportJson(const ImportReport& report, const std::string& input,
                       const std::vector<std::string>& outputs,
                       const std::vector<ExplainedInterpretation>& explained = {});
/// Report of a refused input. `switches`: those of its plot; if there are several, they are listed as
/// "curves".
std::string failureJson(const Failure& failure, const std::string& input,
                        const std::vector<PlotSwitch>& switches = {},
                        const std::optional<Question>& question = {},
                        const std::vector<ExplainedInterpretation>& explained = {});
/// {"records":[...]}: the records in a table.
std::string recordsJson(const std::vector<ListedRecord>& records);

/// A listed graph with the switches it shows.
struct ListedPlot {
  ListedGraph graph;
  std::vector<PlotSwitch> switches;
};
/// {"graphs":[...]}: `frame_pt` for documents, `frame_px` for pictures; "warnings" and
/// "warning_codes" where there are any.
std::string listJson(const std::vector<ListedPlot>& plots, const std::vector<Remark>& remarks);

/// `stroke,displacement_mm,force_N`: traced points before the fit, in the order travelled.
std::string traceCsv(const StrokePair& strokes);

}  // namespace detent::importer
