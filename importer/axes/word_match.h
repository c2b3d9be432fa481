// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Words as a recogniser reads them: letters may be wrong.

#include <cstddef>
#include <string_view>

namespace detent::importer {

/// Bytes to replace, take away or put in to make one of the other; `most` + 1 if more.
std::size_t editsBetween(std::string_view a, std::string_view b, std::size_t most);

/// Whether a lower-case text holds a word: as it stands anywhere in it (compounds, languages without blanks), or, if it
/// has at least five ASCII letters, as a word of its own with one letter wrong.
bool mentions(std::string_view lowercaseText, std::string_view word);

}  // namespace detent::importer
