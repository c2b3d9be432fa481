// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/cyrillic_look.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "importer/lexicon/stroke_words.h"
#include "model/text.h"

namespace detent::importer {
namespace {

bool isOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Capitalises a Cyrillic word. In UTF-8 the small letters а to п and р to я are in different blocks.
std::string withCapital(std::string_view word) {
  std::string capital(word);
  const auto second = static_cast<unsigned char>(word[1]);
  const bool late = static_cast<unsigned char>(word[0]) == 0xD1;
  capital[0] = '\xD0';
  capital[1] = static_cast<char>(late ? second + 0x20 : second - 0x20);
  return capital;
}

}  // namespace

std::string withCyrillicWords(std::string_view utf8) {
  std::string text;
  for (std::size_t from = 0; from < utf8.size();) {
    std::size_t to = from;
    while (to < utf8.size() && isOfWord(utf8[to]) == isOfWord(utf8[from])) ++to;
    const std::string_view part = utf8.substr(from, to - from), word = cyrillicWordLike(lowered(part));
    if (word.empty())
      text += part;
    else
      text +=
          std::isupper(static_cast<unsigned char>(part.front())) != 0 ? withCapital(word) : std::string(word);
    from = to;
  }
  return text;
}

}  // namespace detent::importer
