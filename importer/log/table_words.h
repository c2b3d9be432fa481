// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The content of table_words.tsv, built into the program by CMakeLists.txt.

#include <string_view>

namespace detent::importer {

std::string_view tableWords();

}  // namespace detent::importer
