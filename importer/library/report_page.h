// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What feels like a switch, as one page that can be sent: plots, figures, credits, licences.

#include <string>
#include <vector>

#include "importer/library/find_switches.h"

namespace detent::importer {

/// One self-contained HTML page: no script, nothing loaded. `like` is what was asked for, `found` the answer,
/// nearest first (with distances), `fitting` how many were compared. Every text of a file is escaped. Same
/// input, same bytes. Any thread.
std::string reportPage(const LibrarySwitch& like, const std::vector<FoundSwitch>& found, std::size_t fitting);

}  // namespace detent::importer
