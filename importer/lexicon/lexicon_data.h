// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The lines of lexicon.tsv and confusions.tsv, built into the program by CMakeLists.txt. Private to
// importer/lexicon.

#include <cstddef>
#include <iterator>
#include <string_view>

namespace detent::importer::lexicon {

extern const std::string_view lexiconLines[];
extern const std::size_t lexiconLineCount;
extern const std::string_view confusionsLines[];
extern const std::size_t confusionsLineCount;

}  // namespace detent::importer::lexicon
