// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Base64 (RFC 4648, section 4).

#include <optional>
#include <string>
#include <string_view>

namespace detent {

std::string base64From(std::string_view bytes);
/// Returns nullopt for text that base64From does not write: other characters, missing padding, left-over
/// bits.
std::optional<std::string> bytesFromBase64(std::string_view text);

}  // namespace detent
