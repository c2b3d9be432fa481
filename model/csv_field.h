// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables as text.

#include <string>

namespace detent {

/// One field of a CSV line (RFC 4180), quoted where it has to be.
std::string csvField(const std::string& text);

}  // namespace detent
