// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Fonts that the programs carry. Private to importer/page.

#include <span>
#include <vector>

namespace detent::importer {

/// Font files for scripts and signs that the usual fonts have not.
std::vector<std::span<const unsigned char>> scriptFonts();

}  // namespace detent::importer
