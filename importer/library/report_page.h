// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Switches that feel like another, as one page that can be sent: plots, figures, credits, licences.

#include <string>
#include <vector>

#include "importer/library/find_switches.h"

namespace detent::importer {

/// One self-contained HTML page: no script, nothing loaded. `like` is the reference, `found` the answer,
/// nearest first (with distances), `fitting` the number of compared switches. Every text of a file is
/// escaped. Same input, same bytes. Any thread.
std::string reportPage(const LibrarySwitch& like, const std::vector<FoundSwitch>& found, std::size_t fitting);

}  // namespace detent::importer
