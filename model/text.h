// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Plain operations on text, the same in every locale.

#include <string>
#include <string_view>

namespace detent {

/// Blank, tab, line feed, carriage return, vertical tab, form feed.
constexpr bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Without the blanks at both ends; a part of what was given.
std::string_view trimmed(std::string_view text);

/// With a-z for A-Z; all other bytes stay as they are.
std::string lowered(std::string_view text);

/// Whether the bytes are well-formed UTF-8 (RFC 3629): nothing overlong, no surrogates.
bool isUtf8(std::string_view bytes);

}  // namespace detent
