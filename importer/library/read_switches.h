// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From one file to the switches in it, through the importer's front door.

#include <filesystem>
#include <string>
#include <vector>

#include "importer/library/library_switch.h"
#include "model/result.h"

namespace detent::importer {

/// Whether the library takes a file, by its ending: force logs (.csv, .ods, .json) and buttons (.button.json).
bool isLibraryFile(const std::filesystem::path& path);

/// At least one; name, unit, run, part, figures and shape are filled in. Failure: why the file is refused. Any thread.
Result<std::vector<LibrarySwitch>> readSwitches(const std::string& path);

/// The same as buttons of one state each, in the same order.
Result<std::vector<Button>> readButtons(const std::string& path);

}  // namespace detent::importer
