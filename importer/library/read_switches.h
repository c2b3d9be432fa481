// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From one file to the switches in it, through the importer's front door.

#include <filesystem>
#include <string>
#include <vector>

#include "importer/importer.h"
#include "importer/library/library_switch.h"
#include "model/result.h"

namespace detent::importer {

/// Whether the library takes a file, by its ending: force logs (.csv, .ods, .json) and buttons (.button.json).
bool isLibraryFile(const std::filesystem::path& path);

/// Whether a file is a page or a picture, by its ending: what may hold force graphs of datasheets.
bool isPageFile(const std::filesystem::path& path);

/// A graph of a page, with what its import says of how far figures may be off.
struct PageButton {
  Button button;
  /// Of the first state: the peak's force and travel, by fit, misfit and the rms of its axes' ticks. An import knows nothing of the others.
  KeyFigures sigmas = {};
};

/// The force graphs of a page or picture that are certain enough, in their order. Failure: why the first is none, where all are. Any
/// thread.
Result<std::vector<PageButton>> readPageButtons(const std::string& path, Quality quality);

/// Rows of buttons that stand in one page or picture.
Result<std::vector<LibrarySwitch>> switchesOfPage(const std::vector<PageButton>& buttons,
                                                  const std::string& path);

/// At least one; name, unit, run, part, figures, their `errors` where asked for (a third of the time) and shape are filled in. Failure: why
/// the file is refused. Any thread.
Result<std::vector<LibrarySwitch>> readSwitches(const std::string& path, bool errors = true);

/// The switch as a button of one state, named and with where it came from. Failure unreadableInput: the file is not what was indexed.
/// Any thread.
Result<Button> buttonOf(const LibrarySwitch& entry, Quality quality);

}  // namespace detent::importer
