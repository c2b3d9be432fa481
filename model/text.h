// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Locale-independent operations on text.

#include <string>
#include <string_view>

namespace detent {

/// Blank, tab, line feed, carriage return, vertical tab or form feed.
constexpr bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Returns the text without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// Returns the text with A-Z as a-z; other bytes unchanged.
std::string lowered(std::string_view text);

/// Returns true if the bytes are well-formed UTF-8 (RFC 3629), without overlong forms and surrogates.
bool isUtf8(std::string_view bytes);

}  // namespace detent
