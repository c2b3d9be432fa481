// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measurements in files that already separate the strokes, with contact points beside them or several
// switches in one file.
// OpenDocument spreadsheets of the Open-Switch curve meter in both layouts (headings in one line or in two),
// JSON of Geekboards' force tester, projects of WebPlotDigitizer.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "importer/log/table.h"
#include "model/result.h"
#include "model/stroke_curve.h"
#include "model/units.h"

namespace detent::importer {

/// One switch of a file, in the units of the file. CurvePoint's fields stand for these, not for mm and N.
struct RecordedSwitch {
  std::string name;                        ///< as the file calls it; empty where it does not
  std::vector<CurvePoint> press, release;  ///< each as written; release may be empty
  std::vector<CurvePoint> run;  ///< instead of both, where the file keeps the way down and up as one
  std::optional<double> operatingPoint, resetPoint;
  std::optional<LengthUnit> xUnit = LengthUnit::millimetre;  ///< nullopt: the file does not say
  std::optional<ForceUnit> yUnit = ForceUnit::gramForce;
  bool scaleDoubtful = false;  ///< forces of this kind of file lie well off other laboratories'
};

/// Switches of a curve meter's sheet; empty where no columns are headed as a switch's downstroke.
std::vector<RecordedSwitch> switchesOfSheet(const Table& sheet);

/// Switches of a JSON file that keeps strokes apart, or of a WebPlotDigitizer project in JSON or TAR. In the
/// order of the file, at least one. Failure unreadableInput: damaged; noForceGraph: no strokes in it.
Result<std::vector<RecordedSwitch>> switchesOfJson(const nlohmann::json& json, const std::string& subject);
Result<std::vector<RecordedSwitch>> switchesOfArchive(const std::string& bytes, const std::string& subject);

/// Returns true if a JSON document is of a kind that switchesOfJson knows.
bool keepsStrokesApart(const nlohmann::json& document);

/// Returns true if a JSON document is a project of WebPlotDigitizer.
bool isDigitizerProject(const nlohmann::json& document);

/// The switches of a project of version 3 or 4. Data sets of xy axes are strokes: one whose name says release
/// (release, return, up, unload) is the release of the press whose name is the same without that word; of two
/// sets of which neither says so, the one that lies lower; a single set is a run. Axes' titles are not kept
/// in a project, units therefore only where a name of axes or set says them. Failure noForceGraph about
/// `subject`: no data set on xy axes has two points; unreadableInput: a version this does not know.
Result<std::vector<RecordedSwitch>> switchesOfProject(const nlohmann::json& document,
                                                      const std::string& subject);

/// The project's JSON out of the archive `bytes`. Failure unreadableInput about `subject`: no TAR archive,
/// damaged, or no project.
Result<std::string> projectInArchive(std::string_view bytes, const std::string& subject);

}  // namespace detent::importer
