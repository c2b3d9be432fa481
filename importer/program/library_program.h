// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-import library: its own command line, from the words to the exit code.

#include <functional>

namespace detent::importer {

/// Returns true if the command line is the library's: "library" counts only before one of its own commands or
/// alone, so that an input of that name is imported as any other.
bool isLibraryCommand(int argc, const char* const* argv);

/// Runs, prints, and returns the exit code. `cancelled` may be called from any thread.
int runLibrary(int argc, char** argv, const std::function<bool()>& cancelled);

}  // namespace detent::importer
