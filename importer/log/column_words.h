// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The title of a table's column: its known words (lexicon.tsv, kind "column") and its unit.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace detent::importer {

/// The meaning of a word in a title; a value of the kind "column" in lexicon.tsv.
enum class ColumnWord : std::uint32_t {
  displacement = 1 << 0,
  displacementWeak = 1 << 1,  ///< "x": often, not always
  force = 1 << 2,
  forceWeak = 1 << 3,
  time = 1 << 4,
  index = 1 << 5,
  cycle = 1 << 6,
  record = 1 << 7,
  direction = 1 << 8,
  press = 1 << 9,
  release = 1 << 10,
  contact = 1 << 11,
  other = 1 << 12,  ///< another quantity: strain, speed, raw counts
  mean = 1 << 13,
  spread = 1 << 14,  ///< minimum, maximum, deviation
  copy = 1 << 15,    ///< peak hold, filtered, set point: a second form of another column
  unit = 1 << 16,
  /// as the sensor sends it; alone it is another quantity, beside a quantity it has no effect
  raw = 1 << 17,
  neutral = 1 << 18  ///< any quantity: "channel", "value"
};

/// The known words of a text in order, each with all its meanings.
struct KnownWords {
  struct Word {
    std::string text;
    std::uint32_t meanings = 0;
    bool has(ColumnWord meaning) const { return meanings & static_cast<std::uint32_t>(meaning); }
  };
  std::vector<Word> words;
  std::size_t unknown = 0;  ///< number of unknown words beside these
  /// true in a language whose compound nouns begin with their head: "force de charge"
  bool headFirst = false;
  bool has(ColumnWord meaning) const;
};
KnownWords knownWordsIn(std::string_view text);

/// A unit with its size. `text` is as written.
struct ColumnUnit {
  enum class Kind { none, displacement, force, time, other, unknown };
  Kind kind = Kind::none;
  double size = 1;  ///< mm, N or s in one unit
  std::string text;
  bool isKnown() const { return kind != Kind::none && kind != Kind::unknown; }
  bool isOfButton() const { return kind == Kind::displacement || kind == Kind::force; }
};

/// The unit that makes up a whole text: "mm", "(x0.1 N)", "N/mm²". `unknown` if the text is no known unit,
/// `none` if it is empty.
ColumnUnit unitOf(std::string_view text);

/// The unit at the end of a title, and the title without it.
struct SplitTitle {
  std::string name;
  ColumnUnit unit;
};
SplitTitle splitTitle(std::string_view title);

}  // namespace detent::importer
