// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Place and reason of a JSON syntax error, in plain words.

#include <cstddef>
#include <string>
#include <string_view>

#include "model/message.h"

namespace detent {

/// "line 3, column 7" of a byte offset (1-based offset of the last byte read, as nlohmann counts).
Message placeOfByte(std::string_view text, std::size_t byte);

/// Text of nlohmann after the position: "syntax error while parsing value - invalid literal; last read: 'x'".
/// At most about 160 bytes, on one line.
std::string plainReason(const std::string& what);

}  // namespace detent
