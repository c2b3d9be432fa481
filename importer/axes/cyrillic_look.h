// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Recovers Cyrillic words that a text engine without Cyrillic letters has read as similar Latin ones.

#include <string>
#include <string_view>

namespace detent::importer {

/// Restores the words for strokes, even if one or two letters are wrong: "HaxaTue" is "Нажатие", "Bo3Bpat" is
/// "Возврат". Other text stays unchanged.
std::string withCyrillicWords(std::string_view utf8);

}  // namespace detent::importer
