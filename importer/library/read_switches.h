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

/// Returns true if the library takes a file with this ending: force logs (.csv, .ods, .json) and buttons
/// (.button.json).
bool isLibraryFile(const std::filesystem::path& path);

/// Returns true if a file is, by its ending, a page or picture, which may hold force graphs of datasheets.
bool isPageFile(const std::filesystem::path& path);

/// A graph of a page, with the standard errors that its import implies.
struct PageButton {
  Button button;
  /// Of the first state: force and travel of the peak, from fit, misfit and the rms of the axes' ticks. Other
  /// figures have no error.
  KeyFigures sigmas = {};
};

/// Force graphs of a page or picture whose confidence suffices, in their order. Failure: if there is none,
/// the reason for which the first was refused. Any thread.
Result<std::vector<PageButton>> readPageButtons(const std::string& path, Quality quality);

/// Rows of buttons that stand in one page or picture.
Result<std::vector<LibrarySwitch>> switchesOfPage(const std::vector<PageButton>& buttons,
                                                  const std::string& path);

/// Switches of one file, at least one, with name, unit, run, part, figures and shape. `errors`: with standard
/// errors of the figures, which take a third of the time. `releasePath`: file of the release if it has its
/// own. Failure: the reason of the refusal. Any thread.
Result<std::vector<LibrarySwitch>> readSwitches(const std::string& path, bool errors = true,
                                                const std::string& releasePath = {});

/// SHA-256 of a file, and of its release's where that is in a file of its own.
Result<std::string> contentHash(const std::string& path, const std::string& releasePath);

/// The switch as a button of one state, with its name and provenance. Failure unreadableInput: the file
/// changed since it was indexed. Any thread.
Result<Button> buttonOf(const LibrarySwitch& entry, Quality quality);

}  // namespace detent::importer
