// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether somebody is watching. POSIX.

namespace detent::importer {

bool stderrIsTerminal();

}  // namespace detent::importer
