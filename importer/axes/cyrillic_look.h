// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cyrillic words in the Latin letters that a recogniser without Cyrillic ones takes them for.

#include <string>
#include <string_view>

namespace detent::importer {

/// Restores the words of strokes that were read as similar Latin letters and digits, one or two of which may
/// be wrong: "HaxaTue" is "Нажатие", "Bo3Bpat" is "Возврат". Other text stays.
std::string withCyrillicWords(std::string_view utf8);

}  // namespace detent::importer
