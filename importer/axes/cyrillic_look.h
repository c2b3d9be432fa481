// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cyrillic words in the Latin letters that a recogniser without Cyrillic ones takes them for.

#include <string>
#include <string_view>

namespace detent::importer {

/// Puts back the words of strokes that were read as the Latin letters and digits they look like, one or two
/// of which may be wrong: "HaxaTue" is "Нажатие", "Bo3Bpat" is "Возврат". What looks like none of them stays.
std::string withCyrillicWords(std::string_view utf8);

}  // namespace detent::importer
