// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Returns true if output goes to a terminal. POSIX.

namespace detent::importer {

bool stderrIsTerminal();

}  // namespace detent::importer
