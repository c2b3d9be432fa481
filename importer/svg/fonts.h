// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The fonts that the worker draws with: Liberation, whose letters are as wide as those of Arial, Times and
// Courier, and for other scripts those it is handed. None of the machine's, so that a drawing is the same
// everywhere.

#include <string_view>
#include <vector>

namespace detent::importer::svg {

/// Copies of Liberation's files in memory, as descriptors; call before the file system is closed. Empty where
/// they are not installed. `drawing`: what it never mentions is left out.
std::vector<int> liberationFonts(std::string_view drawing);

/// Makes the font files at these descriptors all that fontconfig knows. False: it cannot.
bool useFonts(const std::vector<int>& descriptors);

/// Returns true if one of them has this code point.
bool fontsHave(char32_t letter);

}  // namespace detent::importer::svg
