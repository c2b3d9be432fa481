// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Hash of a file: source of an import, stimuli of a study.

#include <span>
#include <string>
#include <string_view>

namespace detent {

/// SHA-256 (FIPS 180-4) of the bytes, 64 lower-case hexadecimal digits. Any thread.
std::string sha256Hex(std::span<const unsigned char> bytes);
std::string sha256Hex(std::string_view text);

}  // namespace detent
