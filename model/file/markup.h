// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Text that goes into SVG and HTML.

#include <string>
#include <string_view>

namespace detent {

/// With references for the signs that mean something in markup, inside of attributes too; control characters, which XML does not
/// have, are left out.
std::string escapedForMarkup(std::string_view text);

}  // namespace detent
