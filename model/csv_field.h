// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// CSV fields.

#include <string>

namespace detent {

/// Returns one field of a CSV line, quoted if RFC 4180 requires it.
std::string csvField(const std::string& text);

}  // namespace detent
