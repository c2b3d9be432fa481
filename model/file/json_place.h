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

/// Problem of a text that stops being JSON at a byte, with the part of the line around it.
Message notJson(std::string_view text, std::size_t byte);

/// Number in nlohmann's text of an overflow: "[json.exception.out_of_range.406] number overflow parsing '1e999'".
std::string numberIn(std::string_view what);

}  // namespace detent
