// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The fonts of the worker: Liberation, whose letters have the widths of Arial, Times and Courier, and fonts
// for other scripts that it receives. The machine's own fonts are not used, so that a drawing is the same
// everywhere.

#include <string_view>
#include <vector>

namespace detent::importer::svg {

/// Copies of Liberation's files in memory, as file descriptors. Call before access to the file system is
/// closed. Empty if they are not installed. `drawing`: fonts that it does not name are left out.
std::vector<int> liberationFonts(std::string_view drawing);

/// Restricts fontconfig to the font files at these descriptors. Returns false if that fails.
bool useFonts(const std::vector<int>& descriptors);

/// Returns true if one of them has this code point.
bool fontsHave(char32_t letter);

}  // namespace detent::importer::svg
