// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The words of charts and tables (lexicon.tsv) and what text engines confuse (confusions.tsv). One matcher
// for all of them.

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace detent::importer {

/// Source of a text.
enum class TextSource {
  exact,      ///< a document's own text or a table's cell: letters are certain
  recognised  ///< read off pixels: letters may be wrong
};

/// Kind of an entry; the third column of lexicon.tsv, which describes each kind.
enum class WordKind {
  press,
  release,
  point,
  contact,
  wear,
  curve,
  variant,
  series,
  quantity,
  symbol,
  also,
  unit,
  column,
  columnUnit
};

/// Position that an entry may have in a label.
enum class WordForm {
  whole,      ///< a whole word
  end,        ///< "-kraft": the end of a longer word
  beginning,  ///< "ruck-": the beginning of a longer word
  phrase,     ///< several words in a row
  sign        ///< found anywhere in a text: words of languages without blanks, arrows
};

struct LexiconEntry {
  std::string_view word;  ///< without its hyphen; folded, units as printed
  std::string_view language, value;
  WordKind kind = WordKind::curve;
  WordForm form = WordForm::whole;
};

/// All entries of a kind, in the file's order.
std::span<const LexiconEntry> entriesOf(WordKind kind);

/// An entry of the lexicon that matches a word of a label, with the cost of the letters that differ.
struct WordMatch {
  const LexiconEntry* entry = nullptr;
  /// 0: same spelling; a letter that the engine confuses costs less than 1, any other letter 1
  double cost = 0;
  bool explained = true;  ///< confusions.tsv explains every difference
};

/// The entry of these kinds that is nearest to a folded word: a whole word, or a beginning or end of a
/// compound. In exact text only known variants of spelling are accepted. nullopt if no entry is near enough
/// for the word's length.
std::optional<WordMatch> matchWord(std::string_view foldedWord, std::initializer_list<WordKind> kinds,
                                   TextSource source);

/// Least cost of reading `read` in place of `printed`; nullopt if it exceeds `most`. With `explainedOnly`,
/// only differences that confusions.tsv lists are allowed.
std::optional<double> costOfReading(std::string_view read, std::string_view printed, double most,
                                    bool explainedOnly);

/// The printed unit behind a misread one: "cN" if the engine read "eN".
struct UnitReading {
  std::string_view printed;
  double cost = 0;  ///< 0..1
  /// true if the recognised text is itself a word or a unit, so that only a named quantity can decide
  bool needsQuantity = false;
};
/// The unit for which `read` may be a misreading. In exact text only confusions of Cyrillic and Latin letters
/// are considered, and only with `withCyrillic`.
std::optional<UnitReading> unitReadAs(std::string_view read, TextSource source, bool withCyrillic);

/// Quantity that an axis or a column measures.
enum class Quantity { none, force, travel, other };
struct NamedQuantity {
  Quantity quantity = Quantity::none;
  std::string_view name;        ///< English: "inductance"
  bool printedAsForce = false;  ///< another quantity that people print in units of force: pressure, mass
};

/// The quantity that the words of a title name. Force and travel take precedence over other quantities
/// ("force over time of use"), force over travel ("Kraft-Weg"). `none` if no word is known.
NamedQuantity quantityNamedIn(std::string_view title, TextSource source);
/// Returns true if a title has a word for this quantity, whatever else it names.
bool namesQuantity(std::string_view title, Quantity quantity, TextSource source);

/// The quantity of a unit that measures neither force nor travel: pressure for "kPa". Empty for an unknown
/// unit.
std::string_view quantityOfUnit(std::string_view unit);

}  // namespace detent::importer
