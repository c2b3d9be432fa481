// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measurements that are kept as what they are: strokes already told apart, contact points beside them, several switches in a file.
// OpenDocument spreadsheets of the Open-Switch curve meter in both layouts (headings in one line or in two), JSON of Geekboards'
// force tester, projects of WebPlotDigitizer.

#include <string>
#include <vector>

#include "importer/log/recorded_switch.h"
#include "model/result.h"

namespace detent::importer {

/// Whether a path ends like a file that this reads: .ods, .json, .tar.
bool holdsRecordedSwitches(const std::string& path);

/// In the order of the file, at least one. Failure unreadableInput: missing, damaged, more than 32 MB (unpacked: 64 MB);
/// noForceGraph: no strokes in it. Any thread.
Result<std::vector<RecordedSwitch>> recordedSwitches(const std::string& path);

}  // namespace detent::importer
