// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Interface of detent-graph: what its commands do, without arguments, terminal or exit.

#include <optional>
#include <string>
#include <vector>

#include "model/file/graph_report.h"
#include "model/file/svg_plot.h"

namespace detent {

/// What a file name's end says it holds. ".json" (".button.json") is a button, ".csv" samples, ".svg" a plot, "datapackage.json" a data
/// package with its tables beside it, ".wpd.json" a project of WebPlotDigitizer.
enum class GraphFileKind { button, csv, svg, dataPackage, tracedProject, tracedArchive };
Result<GraphFileKind> kindOfFile(const std::string& path);

/// Reads a button, or builds one through the samples of a CSV (named after the file).
Result<Button> readButton(const std::string& path);

struct ConvertOptions {
  std::string
      state;  ///< which state of a self-locking button goes into a CSV or a project; empty: the only one
  std::optional<double>
      speed_mm_per_s;  ///< of a button with graphs at several: written is the button of this one; > 0
  std::optional<double> forceStep_N;  ///< of a CSV of travel over force instead of samples; > 0
  SvgPlotStyle svg;                   ///< width and height > 200 px
};

struct CompareOptions {
  std::string stateA, stateB;  ///< which state of a self-locking button; empty: the only one
};

Result<Report> showGraph(const std::string& path);
Result<Report> checkGraph(const std::string& path);
/// Writes OUT whole or not at all.
Result<Report> convertGraph(const std::string& in, const std::string& out,
                            const ConvertOptions& options = {});
/// The mean of units of one button, with their spread; `out` is a .button.json, written whole or not at all.
Result<Report> averageGraphs(const std::vector<std::string>& units, const std::string& out);
/// One button of buttons measured at different speeds, one speed each; `out` is a .button.json, written whole or not at all.
Result<Report> familyOfGraphs(const std::vector<std::string>& paths,
                              const std::vector<double>& speeds_mm_per_s, const std::string& out);
Result<Report> compareGraphs(const std::string& a, const std::string& b, const CompareOptions& options = {});

}  // namespace detent
