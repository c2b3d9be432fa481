// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a text stops being JSON, and why, in a reader's words.

#include <cstddef>
#include <string>
#include <string_view>

#include "model/message.h"

namespace detent {

/// "line 3, column 7" of a byte offset (1-based offset of the last read byte, as nlohmann counts).
Message placeOfByte(std::string_view text, std::size_t byte);

/// What nlohmann says after the position: "syntax error while parsing value - invalid literal; last read: 'x'". At most some 160
/// bytes, in one line.
std::string plainReason(const std::string& what);

}  // namespace detent
