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

/// One switch of a file, in the file's units: CurvePoint's fields are not mm and N here.
struct RecordedSwitch {
  std::string name;                        ///< name in the file; may be empty
  std::vector<CurvePoint> press, release;  ///< as stored; the release may be empty
  std::vector<CurvePoint> run;             ///< both strokes in one run, if the file does not separate them
  std::optional<double> operatingPoint, resetPoint;
  std::optional<LengthUnit> xUnit = LengthUnit::millimetre;  ///< nullopt: the file does not state it
  std::optional<ForceUnit> yUnit = ForceUnit::gramForce;
  bool scaleDoubtful = false;  ///< files of this kind have forces that differ much from other laboratories'
};

/// Switches of a curve meter's sheet; empty if no columns are titled as the downstroke of a switch.
std::vector<RecordedSwitch> switchesOfSheet(const Table& sheet);

/// Switches of a JSON file that separates the strokes, or of a WebPlotDigitizer project in JSON or TAR. In
/// the order of the file, at least one. Failure unreadableInput: damaged; noForceGraph: no strokes in it.
Result<std::vector<RecordedSwitch>> switchesOfJson(const nlohmann::json& json, const std::string& subject);
Result<std::vector<RecordedSwitch>> switchesOfArchive(const std::string& bytes, const std::string& subject);

/// Returns true if a JSON document is of a kind that switchesOfJson knows.
bool keepsStrokesApart(const nlohmann::json& document);

/// Returns true if a JSON document is a project of WebPlotDigitizer.
bool isDigitizerProject(const nlohmann::json& document);

/// The switches of a project of version 3 or 4. Data sets on xy axes are strokes. A set whose name says
/// release (release, return, up, unload) is the release of the press with the same name without that word. Of
/// two sets without such a word, the lower one is the release. A single set is a run. Projects do not store
/// axis titles, so units are known only if a name of axes or a set states them. Failure noForceGraph about
/// `subject`: no data set on xy axes has two points; unreadableInput: an unknown version.
Result<std::vector<RecordedSwitch>> switchesOfProject(const nlohmann::json& document,
                                                      const std::string& subject);

/// The project's JSON out of the archive `bytes`. Failure unreadableInput about `subject`: no TAR archive,
/// damaged, or no project.
Result<std::string> projectInArchive(std::string_view bytes, const std::string& subject);

}  // namespace detent::importer
