// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Escaping of text for SVG and HTML.

#include <string>
#include <string_view>

namespace detent {

/// Escapes markup characters, also for attributes; drops control characters, which XML does not allow.
std::string escapedForMarkup(std::string_view text);

}  // namespace detent
