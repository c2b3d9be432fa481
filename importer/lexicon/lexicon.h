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

/// The third column of lexicon.tsv, which describes each.
enum class WordKind {
  press,
  release,
  point,
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
  sign        ///< anywhere: writing without blanks between words, arrows
};

struct LexiconEntry {
  std::string_view word;  ///< without its hyphen; folded, units as printed
  std::string_view language, value;
  WordKind kind = WordKind::curve;
  WordForm form = WordForm::whole;
};

/// All entries of a kind, in the file's order.
std::span<const LexiconEntry> entriesOf(WordKind kind);

/// An entry of the lexicon that a word of a label fits, with the cost of the differing letters.
struct WordMatch {
  const LexiconEntry* entry = nullptr;
  double cost = 0;        ///< 0: spelled so; letters that the engine confuses cost less than 1 each, others 1
  bool explained = true;  ///< confusions.tsv explains every difference
};

/// The entry of these kinds that a folded word is nearest to, whole words and beginnings or ends of
/// compounds. In exact text nothing but the spelling counts. nullopt if none is near enough for the word's
/// length.
std::optional<WordMatch> matchWord(std::string_view foldedWord, std::initializer_list<WordKind> kinds,
                                   TextSource source);

/// Least cost of reading `read` where `printed` stands; nullopt if it exceeds `most`. With `explainedOnly`
/// differences that confusions.tsv does not list are not admitted.
std::optional<double> costOfReading(std::string_view read, std::string_view printed, double most,
                                    bool explainedOnly);

/// A whole unit that reads as another sign: "eN" is "cN".
struct UnitReading {
  std::string_view printed;
  double cost = 0;  ///< 0..1
  /// true if the recognised text is itself a word or a unit, so that only a named quantity can decide
  bool needsQuantity = false;
};
/// `withCyrillic`: of exact text, only with Cyrillic letters beside it.
std::optional<UnitReading> unitReadAs(std::string_view read, TextSource source, bool withCyrillic);

/// Quantity that an axis or a column measures.
enum class Quantity { none, force, travel, other };
struct NamedQuantity {
  Quantity quantity = Quantity::none;
  std::string_view name;        ///< English: "inductance"
  bool printedAsForce = false;  ///< another quantity that people print in units of force: pressure, mass
};

/// The quantity that the words of a title name; force and travel go before others ("force over time of
/// use"), force before travel ("Kraft-Weg"). `none` if no word of it is known.
NamedQuantity quantityNamedIn(std::string_view title, TextSource source);
/// Returns true if a title has a word for this quantity, whatever else it names.
bool namesQuantity(std::string_view title, Quantity quantity, TextSource source);

/// The quantity of a unit of neither force nor travel: "kPa" is a pressure. Empty if unknown.
std::string_view quantityOfUnit(std::string_view unit);

}  // namespace detent::importer
