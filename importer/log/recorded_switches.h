// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measurements that are kept as what they are: strokes already told apart, contact points beside them, several switches in a file.
// OpenDocument spreadsheets of the Open-Switch curve meter in both layouts (headings in one line or in two), JSON of Geekboards'
// force tester, projects of WebPlotDigitizer.

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "importer/log/recorded_switch.h"
#include "importer/log/table.h"
#include "model/result.h"

namespace detent::importer {

/// Switches of a curve meter's sheet; empty where no columns are headed as a switch's downstroke.
std::vector<RecordedSwitch> switchesOfSheet(const Table& sheet);

/// Switches of a JSON file that keeps strokes apart, or of a WebPlotDigitizer project in JSON or TAR. In the order of the file, at
/// least one. Failure unreadableInput: damaged; noForceGraph: no strokes in it.
Result<std::vector<RecordedSwitch>> switchesOfJson(const std::string& text, const std::string& subject);
Result<std::vector<RecordedSwitch>> switchesOfArchive(const std::string& bytes, const std::string& subject);

/// Returns true if a JSON document is of a kind that switchesOfJson knows.
bool keepsStrokesApart(const nlohmann::json& document);

}  // namespace detent::importer
