// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lexicon/letters.h"

#include <algorithm>
#include <array>

namespace detent::importer {
namespace {

/// The letter without case and accents, for Latin, Greek and Cyrillic; 0 for a combining accent.
char32_t foldedLetter(char32_t c) {
  constexpr std::u32string_view latin =  // U+00C0 to U+017F; a sign that is no letter stays itself
      U"aaaaaaaceeeeiiiidnooooo ouuuuypsaaaaaaaceeeeiiiidnooooo "
      U"ouuuuypyaaaaaaccccccccddddeeeeeeeeeegggggggghhhh"
      U"iiiiiiiiiiiijjkkklllllll"
      U"lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
  struct Range {
    char32_t first, last, letter;
  };
  constexpr std::array<Range, 14> ranges{{{0x1A0, 0x1A1, U'o'},
                                          {0x1AF, 0x1B0, U'u'},
                                          {0x218, 0x219, U's'},
                                          {0x21A, 0x21B, U't'},
                                          {0x300, 0x36F, 0},
                                          {0x1EA0, 0x1EB7, U'a'},
                                          {0x1EB8, 0x1EC7, U'e'},
                                          {0x1EC8, 0x1ECB, U'i'},
                                          {0x1ECC, 0x1EE3, U'o'},
                                          {0x1EE4, 0x1EF1, U'u'},
                                          {0x1EF2, 0x1EF9, U'y'},
                                          {0x3C2, 0x3C2, U'σ'},
                                          {0x451, 0x451, U'е'},
                                          {0x401, 0x401, U'е'}}};
  constexpr std::u32string_view accented = U"άέήίόύώΆΈΉΊΌΎΏ", plain = U"αεηιουωαεηιουω";
  if (c >= U'A' && c <= U'Z') return c + 0x20;
  if (c >= 0xC0 && c <= 0x17F) return latin[c - 0xC0] == U' ' ? c : latin[c - 0xC0];
  for (const Range& range : ranges)
    if (c >= range.first && c <= range.last) return range.letter;
  if (const auto at = accented.find(c); at != std::u32string_view::npos) return plain[at];
  if (c >= 0x391 && c <= 0x3A9) return c + 0x20;  // Greek capitals
  if (c >= 0x410 && c <= 0x42F) return c + 0x20;  // Cyrillic capitals; those before А stand elsewhere
  if (c >= 0x400 && c <= 0x40F) return c + 0x50;
  if (c >= 0xFF21 && c <= 0xFF5A) return foldedLetter(c - 0xFF21 + U'A');  // full-width letters
  return c;
}

/// The code point at a place; a byte that is not well formed comes back alone.
struct Decoded {
  char32_t letter;
  std::size_t bytes;
};
Decoded decodedAt(std::string_view utf8, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return at + k < utf8.size() ? static_cast<unsigned char>(utf8[at + k]) : 0U;
  };
  const auto more = [&](std::size_t k) { return (byte(k) & 0xC0U) == 0x80U; };
  if (byte(0) >= 0xC2 && byte(0) <= 0xDF && more(1)) return {(byte(0) & 0x1FU) << 6 | (byte(1) & 0x3FU), 2};
  if (byte(0) >= 0xE0 && byte(0) <= 0xEF && more(1) && more(2))
    return {(byte(0) & 0x0FU) << 12 | (byte(1) & 0x3FU) << 6 | (byte(2) & 0x3FU), 3};
  if (byte(0) >= 0xF0 && byte(0) <= 0xF4 && more(1) && more(2) && more(3))
    return {(byte(0) & 0x07U) << 18 | (byte(1) & 0x3FU) << 12 | (byte(2) & 0x3FU) << 6 | (byte(3) & 0x3FU),
            4};
  return {byte(0), 1};
}

void appendLetter(std::string& text, char32_t letter) {
  const auto put = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  const auto putRest = [&](unsigned shift) { put(0x80U | (letter >> shift & 0x3FU)); };
  if (letter < 0x80) {
    put(letter);
  } else if (letter < 0x800) {
    put(0xC0U | letter >> 6);
    putRest(0);
  } else if (letter < 0x10000) {
    put(0xE0U | letter >> 12);
    putRest(6);
    putRest(0);
  } else {
    put(0xF0U | letter >> 18);
    putRest(12);
    putRest(6);
    putRest(0);
  }
}

}  // namespace

std::string folded(std::string_view utf8) {
  std::string out;
  for (std::size_t at = 0; at < utf8.size();) {
    const Decoded is = decodedAt(utf8, at);
    const char32_t letter = foldedLetter(is.letter);
    const bool single = is.bytes == 1 && is.letter >= 0x80;
    if (letter == is.letter || single)
      out += utf8.substr(at, is.bytes);
    else if (letter != 0)
      appendLetter(out, letter);
    at += is.bytes;
  }
  return out;
}

std::u32string codePoints(std::string_view utf8) {
  std::u32string out;
  for (std::size_t at = 0; at < utf8.size();) {
    const Decoded is = decodedAt(utf8, at);
    out += is.letter;
    at += is.bytes;
  }
  return out;
}

std::string utf8Of(std::u32string_view letters) {
  std::string text;
  for (const char32_t letter : letters) appendLetter(text, letter);
  return text;
}

std::vector<std::string> wordsOf(std::string_view utf8) {
  const auto isLetter = [](char c) {
    return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
  };
  std::vector<std::string> words(1);
  for (const char c : folded(utf8)) {
    if (isLetter(c))
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::size_t letterCount(std::string_view utf8) {
  return static_cast<std::size_t>(
      std::ranges::count_if(utf8, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

bool isWrittenTogether(std::string_view utf8) {
  constexpr char32_t firstHebrew = 0x590, firstLatinAgain = 0x1E00, lastGreek = 0x1FFF, firstWide = 0xFF00;
  return std::ranges::any_of(codePoints(utf8), [](char32_t c) {
    return (c >= firstHebrew && c < firstLatinAgain) || (c > lastGreek && c < firstWide);
  });
}

bool hasCyrillic(std::string_view utf8) {
  return std::ranges::any_of(codePoints(utf8), [](char32_t c) { return c >= 0x400 && c <= 0x4FF; });
}

}  // namespace detent::importer
