// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Commands of detent-graph, without arguments, terminal or exit.

#include <optional>
#include <string>
#include <vector>

#include "model/file/graph_report.h"
#include "model/file/svg_plot.h"

namespace detent {

/// File kind by the end of the name: ".json" (".button.json") a button, ".csv" samples, ".svg" a plot,
/// "datapackage.json" a data package with tables, ".wpd.json" a WebPlotDigitizer project.
enum class GraphFileKind { button, csv, svg, dataPackage, tracedProject, tracedArchive };
Result<GraphFileKind> kindOfFile(const std::string& path);

/// Reads a button, or builds one from the samples of a CSV (named after the file).
Result<Button> readButton(const std::string& path);

struct ConvertOptions {
  std::string state;  ///< state of a self-locking button for a CSV or a project; empty: the only one
  std::optional<double> speed_mm_per_s;  ///< speed of a button with several graphs; > 0
  std::optional<double> travelStep_mm;   ///< travel step of a CSV instead of samples
  std::vector<double> travels_mm;        ///< travels of the CSV rows, instead of even steps; may be empty
  std::optional<double> forceStep_N;  ///< force step of a CSV of displacement over force instead of samples;
                                      ///< > 0
  SvgPlotStyle svg;                   ///< width and height > 200 px
};

struct CompareOptions {
  std::string stateA, stateB;  ///< states of self-locking buttons; empty: the only one
};

Result<Report> showGraph(const std::string& path);
Result<Report> checkGraph(const std::string& path);
/// Writes OUT completely or not at all.
Result<Report> convertGraph(const std::string& in, const std::string& out,
                            const ConvertOptions& options = {});
/// Mean of units of one button with their spread; `out` is a .button.json, written completely or not at all.
Result<Report> averageGraphs(const std::vector<std::string>& units, const std::string& out);
/// Combines buttons measured at different speeds; `out` is a .button.json, written completely or not at all.
Result<Report> familyOfGraphs(const std::vector<std::string>& paths,
                              const std::vector<double>& speeds_mm_per_s, const std::string& out);
Result<Report> compareGraphs(const std::string& a, const std::string& b, const CompareOptions& options = {});

}  // namespace detent
