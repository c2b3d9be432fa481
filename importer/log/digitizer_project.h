// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Graphs traced by hand in WebPlotDigitizer: its project as JSON (versions 3 and 4), or as the TAR archive it saves.

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "importer/log/recorded_switch.h"
#include "model/result.h"

namespace detent::importer {

/// Whether a JSON document is such a project.
bool isDigitizerProject(const nlohmann::json& document);

/// The switches of a project. Data sets of xy axes are strokes: one whose name says release (release, return, up, unload) is the
/// release of the press whose name is the same without that word; of two sets of which neither says so, the one that lies lower; a
/// single set is a run. Axes' titles are not kept in a project, units therefore only where a name of axes or set says them.
/// Failure noForceGraph about `subject`: no data set on xy axes has two points; unreadableInput: a version this does not know.
Result<std::vector<RecordedSwitch>> switchesOfProject(const nlohmann::json& document,
                                                      const std::string& subject);

/// The project's JSON out of the archive `bytes`. Failure unreadableInput about `subject`: no TAR archive, damaged, or no project.
Result<std::string> projectInArchive(std::string_view bytes, const std::string& subject);

}  // namespace detent::importer
