// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/cyrillic_look.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

#include "importer/axes/word_match.h"

namespace detent::importer {
namespace {

/// A word and how it looks in Latin letters, all of them small: capitals and small letters are alike in Cyrillic print.
struct Look {
  std::string_view word, latin;
};
constexpr std::array looks{
    Look{"нажатие", "haxatue"},       Look{"нагрузка", "harpy3ka"},  Look{"нагружение", "harpyxehue"},
    Look{"отпускание", "otnyckahue"}, Look{"возврат", "bo3bpat"},    Look{"разгрузка", "pa3rpy3ka"},
    Look{"обратный", "o6pathbiu"},    Look{"обратный", "o6pathbin"}, Look{"прямой", "npamou"},
    Look{"прямой", "npamon"},
};

bool isOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

std::string_view wordThatLooksLike(std::string_view read) {
  std::string small(read);
  std::ranges::transform(small, small.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found =
      std::ranges::find_if(looks, [&](const Look& look) { return differByOneAtMost(small, look.latin); });
  return found == looks.end() ? std::string_view() : found->word;
}

/// A small Cyrillic letter's capital: а to п lie in one block of bytes, р to я in the next.
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
    const std::string_view part = utf8.substr(from, to - from), word = wordThatLooksLike(part);
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
