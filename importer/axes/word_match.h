// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Words as a recogniser reads them: one letter may be wrong.

#include <string_view>

namespace detent::importer {

/// Equal but for at most one replaced, missing or extra byte.
bool differByOneAtMost(std::string_view a, std::string_view b);

/// Whether a lower-case text holds a word: as it stands anywhere in it (compounds, languages without blanks), or, if it
/// has at least five ASCII letters, as a word of its own with one letter wrong.
bool mentions(std::string_view lowercaseText, std::string_view word);

}  // namespace detent::importer
