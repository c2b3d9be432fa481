// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Bytes as text that JSON can hold (RFC 4648, section 4).

#include <optional>
#include <string>
#include <string_view>

namespace detent {

std::string base64From(std::string_view bytes);
/// nullopt for anything that base64From does not write: other characters, missing padding, bits left over.
std::optional<std::string> bytesFromBase64(std::string_view text);

}  // namespace detent
