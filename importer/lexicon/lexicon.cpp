// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lexicon/lexicon.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "importer/lexicon/letters.h"
#include "importer/lexicon/lexicon_data.h"
#include "model/check.h"

namespace detent::importer {
namespace {

constexpr double kNoMatch = std::numeric_limits<double>::infinity();  // cost

/// In the order of WordKind.
constexpr std::array<std::string_view, 14> kKinds{"press", "release", "point",  "contact",    "wear",
                                                  "curve", "variant", "series", "quantity",   "symbol",
                                                  "also",  "unit",    "column", "column-unit"};

/// A line's fields, set apart by tabs; empty ones at the end where it has fewer.
template <std::size_t count>
std::array<std::string_view, count> fieldsOf(std::string_view line) {
  std::array<std::string_view, count> fields;
  for (std::string_view& field : fields) {
    const std::size_t tab = std::min(line.find('\t'), line.size());
    field = line.substr(0, tab);
    line.remove_prefix(std::min(tab + 1, line.size()));
  }
  return fields;
}

/// Letters that are read in place of others, with the cost of that confusion.
struct Confusion {
  std::u32string read, printed;
  double cost = 0;
};

struct UnitConfusion {
  std::string_view read;
  UnitReading reading;
  bool isScript = false;
};

struct Entry {
  LexiconEntry entry;
  std::u32string letters;
  bool isCyrillic = false;
};

class Tables {
 public:
  static const Tables& get() {
    static const Tables tables;
    return tables;
  }

  std::array<std::vector<LexiconEntry>, kKinds.size()> byKind;
  std::array<std::vector<Entry>, kKinds.size()> words;  ///< whole words, beginnings and ends
  /// By the first printed letter.
  using ByLetter = std::unordered_map<char32_t, std::vector<Confusion>>;
  ByLetter ofEngine, ofScript, ofSpelling;
  std::vector<UnitConfusion> units;

 private:
  Tables() {
    for (std::size_t i = 0; i < lexicon::lexiconLineCount; ++i) addWord(lexicon::lexiconLines[i]);
    for (std::size_t i = 0; i < lexicon::confusionsLineCount; ++i) addConfusion(lexicon::confusionsLines[i]);
  }

  void addWord(std::string_view line) {
    if (line.empty() || line.starts_with("# ")) return;
    const auto [word, language, kindName, value] = fieldsOf<4>(line);
    const auto* const kind = std::ranges::find(kKinds, kindName);
    DETENT_CHECK(kind != kKinds.end() && !word.empty(), "a line of lexicon.tsv has a word and a known kind");
    const auto index = static_cast<std::size_t>(kind - kKinds.begin());
    LexiconEntry entry{word, language, value, static_cast<WordKind>(index), WordForm::whole};
    const bool isUnit = entry.kind == WordKind::unit || entry.kind == WordKind::columnUnit;
    if (!isUnit && word.size() > 1 && word.front() == '-') {
      entry.form = WordForm::end;
      entry.word.remove_prefix(1);
    } else if (!isUnit && word.size() > 1 && word.back() == '-') {
      entry.form = WordForm::beginning;
      entry.word.remove_suffix(1);
    } else if (!isUnit && word.find(' ') != std::string_view::npos) {
      entry.form = WordForm::phrase;
    } else if (!isUnit && isWrittenTogether(word)) {
      entry.form = WordForm::sign;
    }
    byKind[index].push_back(entry);
    const bool isOfTables = entry.kind == WordKind::column || entry.kind == WordKind::columnUnit;
    if (!isOfTables && entry.form != WordForm::phrase && entry.form != WordForm::sign)
      words[index].push_back({entry, codePoints(entry.word), hasCyrillic(entry.word)});
  }

  void addConfusion(std::string_view line) {
    if (line.empty() || line.front() == '#') return;
    const auto [read, printed, costText, source, where] = fieldsOf<5>(line);
    const double cost = std::strtod(std::string(costText).c_str(), nullptr);
    DETENT_CHECK(cost >= 0 && cost < 1, "a line of confusions.tsv has a cost from 0 to less than 1");
    if (where != "word") {
      units.push_back({read, {printed, cost, where == "unit-with-quantity"}, source == "script"});
      return;
    }
    ByLetter& table = source == "script" ? ofScript : source == "spelling" ? ofSpelling : ofEngine;
    const std::u32string letters = codePoints(printed);
    DETENT_CHECK(!letters.empty(), "a line of confusions.tsv says what is printed");
    table[letters.front()].push_back({codePoints(read), letters, cost});
  }
};

bool startsAt(std::u32string_view text, std::size_t at, std::u32string_view part) {
  return text.substr(at, part.size()) == part;
}

/// Kinds of confusions that may explain a difference.
struct Admitted {
  bool engine = false, script = false;
  double unexplained = kNoMatch;  ///< cost of a letter that nothing explains
};

/// Weighted edit distance from what was read to what is printed; kNoMatch above `most`.
double distanceBetween(std::u32string_view read, std::u32string_view printed, double most,
                       const Admitted& admitted) {
  // most letters by which the lengths differ; most letters of a word
  constexpr std::size_t longestGap = 4, longestWord = 32;
  if (read == printed) return 0;
  if (read.size() > printed.size() + longestGap || printed.size() > read.size() + longestGap ||
      read.size() > longestWord || printed.size() > longestWord)
    return kNoMatch;
  const Tables& tables = Tables::get();
  const std::array<const Tables::ByLetter*, 3> lists{&tables.ofSpelling,
                                                     admitted.engine ? &tables.ofEngine : nullptr,
                                                     admitted.script ? &tables.ofScript : nullptr};
  const std::size_t rows = read.size() + 1, columns = printed.size() + 1;
  std::array<double, (longestWord + 1) * (longestWord + 1)> cost;
  std::fill_n(cost.begin(), rows * columns, kNoMatch);
  cost[0] = 0;
  std::size_t farthest = 0;  // last row that was reached so far
  for (std::size_t i = 0; i < rows && i <= farthest; ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      const double here = cost[i * columns + j];
      if (here > most) continue;
      const auto reach = [&](std::size_t down, std::size_t right, double more) {
        if (i + down >= rows || j + right >= columns || here + more > most) return;
        double& there = cost[(i + down) * columns + j + right];
        there = std::min(there, here + more);
        farthest = std::max(farthest, i + down);
      };
      if (i + 1 < rows && j + 1 < columns) reach(1, 1, read[i] == printed[j] ? 0 : admitted.unexplained);
      reach(1, 0, admitted.unexplained);
      reach(0, 1, admitted.unexplained);
      if (j + 1 == columns) continue;
      for (const auto* const list : lists) {
        if (list == nullptr) continue;
        const auto of = list->find(printed[j]);
        if (of == list->end()) continue;
        for (const Confusion& each : of->second)
          if (startsAt(printed, j, each.printed) && startsAt(read, i, each.read) &&
              (!each.read.empty() || (i > 0 && i + 1 < rows)))  // letters are lost only inside a word
            reach(each.read.size(), each.printed.size(), each.cost);
      }
    }
  return cost[rows * columns - 1] <= most ? cost[rows * columns - 1] : kNoMatch;
}

/// Number of letters that may be wrong in a word of this length.
double forgiven(std::size_t letters) {
  constexpr std::size_t fewestForOne = 6, fewestForTwo = 9;
  return letters >= fewestForTwo ? 2 : letters >= fewestForOne ? 1 : 0;
}

// largest summed cost of letters that were confused with others of the same shape
constexpr double kSmallCosts = 0.3;

/// Cost of a word compared with an entry's letters, and whether known confusions explain it.
struct Priced {
  double cost = kNoMatch;
  bool explained = true;
};
Priced priceOf(std::u32string_view read, const Entry& known, TextSource source) {
  constexpr std::size_t fewest = 4;        // shorter words must match exactly
  constexpr double explainedLetter = 0.5;  // cost
  if (read == std::u32string_view(known.letters)) return {0, true};
  const std::size_t letters = std::min(read.size(), known.letters.size());
  if (letters < fewest) return {};
  Admitted admitted;
  if (source == TextSource::exact) return {distanceBetween(read, known.letters, 0, admitted), true};
  admitted.engine = true;
  admitted.script = known.isCyrillic;
  const double allowed = forgiven(letters + (known.entry.kind == WordKind::quantity ? 1 : 0));
  const double sure = distanceBetween(read, known.letters, explainedLetter * allowed + kSmallCosts, admitted);
  if (sure < kNoMatch) return {sure, true};
  if (allowed == 0) return {};
  admitted.unexplained = 1;
  return {distanceBetween(read, known.letters, allowed + kSmallCosts, admitted), false};
}

/// Removes a sign from a text wherever it stands; returns true if the text had it.
bool takeOut(std::string& text, std::string_view sign) {
  bool found = false;
  for (auto at = text.find(sign); at != std::string::npos; at = text.find(sign)) {
    text.replace(at, sign.size(), " ");
    found = true;
  }
  return found;
}

/// The title with a blank before each capital letter inside a word, to split names of columns: "forceGf",
/// "travelMm".
std::string partedAtCapitals(std::string_view title) {
  std::string out;
  for (std::size_t i = 0; i < title.size(); ++i) {
    const auto isSmall = [](char c) { return c >= 'a' && c <= 'z'; };
    if (i > 0 && title[i] >= 'A' && title[i] <= 'Z' && isSmall(title[i - 1])) out += ' ';
    out += title[i];
  }
  return out;
}

/// Returns true if a match is certain enough to count. A quantity other than force and travel contradicts a
/// unit, so a short or badly read word does not prove it.
bool mayBeSaid(std::string_view word, const WordMatch& match, TextSource source) {
  constexpr std::size_t fewest = 4;  // letters
  const bool isOther = match.entry->value != "force" && match.entry->value != "travel";
  return !isOther || source == TextSource::exact ||
         (match.cost <= kSmallCosts && letterCount(word) >= fewest);
}

/// Every quantity that a title's words name, each once.
std::vector<std::string_view> quantitiesIn(std::string_view title, TextSource source) {
  constexpr std::size_t fewestWithin = 5;  // letters of a word that is searched inside words read as one
  std::vector<std::string_view> found;
  const auto add = [&](std::string_view name) {
    if (std::ranges::find(found, name) == found.end()) found.push_back(name);
  };
  std::vector<std::string> words = wordsOf(partedAtCapitals(title));
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  std::vector<const LexiconEntry*> signs;
  for (const LexiconEntry& entry : entriesOf(WordKind::quantity)) {
    if (entry.form == WordForm::sign) signs.push_back(&entry);
    if (entry.form == WordForm::phrase &&
        (" " + text + " ").find(" " + std::string(entry.word) + " ") != std::string::npos) {
      add(entry.value);
      takeOut(text, entry.word);
    }
  }
  // The longest sign first: that of a torque contains that of a force.
  std::ranges::stable_sort(signs, std::greater<>{}, [](const LexiconEntry* e) { return e->word.size(); });
  for (const LexiconEntry* sign : signs)
    if (takeOut(text, sign->word)) add(sign->value);
  for (const std::string& word : wordsOf(text)) {
    const auto match = matchWord(word, {WordKind::quantity}, source);
    if (match && mayBeSaid(word, *match, source)) {
      add(match->entry->value);
    } else if (source == TextSource::recognised) {
      for (const LexiconEntry& entry : entriesOf(WordKind::quantity))
        if (entry.form == WordForm::whole && entry.word.size() >= fewestWithin &&
            (entry.value == "force" || entry.value == "travel") && word.find(entry.word) != std::string::npos)
          add(entry.value);
    }
  }
  return found;
}

}  // namespace

std::span<const LexiconEntry> entriesOf(WordKind kind) {
  return Tables::get().byKind[static_cast<std::size_t>(kind)];
}

std::optional<double> costOfReading(std::string_view read, std::string_view printed, double most,
                                    bool explainedOnly) {
  const Admitted admitted{true, hasCyrillic(printed), explainedOnly ? kNoMatch : 1};
  const double cost = distanceBetween(codePoints(read), codePoints(printed), most, admitted);
  return cost < kNoMatch ? std::optional(cost) : std::nullopt;
}

namespace {

std::optional<WordMatch> nearestMatch(std::string_view word, std::initializer_list<WordKind> kinds,
                                      TextSource source) {
  constexpr std::size_t fewestBefore = 3;  // letters of a compound in front of its last part
  const std::u32string read = codePoints(word);
  std::optional<WordMatch> best;
  for (const WordKind kind : kinds)
    for (const Entry& known : Tables::get().words[static_cast<std::size_t>(kind)]) {
      if (known.entry.form == WordForm::beginning) continue;
      Priced price;
      if (known.entry.form == WordForm::whole)
        price = priceOf(read, known, source);
      else if (read.size() >= known.letters.size() + fewestBefore && word.ends_with(known.entry.word))
        price = {0, true};
      if (price.cost == kNoMatch) continue;
      if (!best || price.cost < best->cost) best = WordMatch{&known.entry, price.cost, price.explained};
    }
  return best;
}

}  // namespace

std::optional<WordMatch> matchWord(std::string_view word, std::initializer_list<WordKind> kinds,
                                   TextSource source) {
  constexpr std::size_t mostKept = 20000;  // limit of kept answers; a page repeats its words many times
  thread_local std::map<std::pair<std::string, unsigned>, std::optional<WordMatch>> known;
  unsigned requested = source == TextSource::exact ? 1U : 0U;
  for (const WordKind kind : kinds) requested |= 2U << static_cast<unsigned>(kind);
  if (known.size() > mostKept) known.clear();
  const auto [at, isNew] = known.try_emplace({std::string(word), requested});
  if (isNew) at->second = nearestMatch(word, kinds, source);
  return at->second;
}

std::optional<UnitReading> unitReadAs(std::string_view read, TextSource source, bool withCyrillic) {
  for (const UnitConfusion& each : Tables::get().units)
    if (each.read == read && (source == TextSource::recognised || (each.isScript && withCyrillic)))
      return each.reading;
  return {};
}

bool namesQuantity(std::string_view title, Quantity quantity, TextSource source) {
  const auto found = quantitiesIn(title, source);
  return std::ranges::any_of(found, [&](std::string_view name) {
    return quantity == Quantity::force    ? name == "force"
           : quantity == Quantity::travel ? name == "travel"
                                          : name != "force" && name != "travel";
  });
}

NamedQuantity quantityNamedIn(std::string_view title, TextSource source) {
  const auto found = quantitiesIn(title, source);
  const auto names = [&](std::string_view name) { return std::ranges::find(found, name) != found.end(); };
  if (names("force")) return {Quantity::force, "force", true};
  if (names("travel")) return {Quantity::travel, "travel", false};
  if (found.empty()) return {};
  const bool asForce = std::ranges::any_of(
      entriesOf(WordKind::also), [&](const LexiconEntry& entry) { return entry.word == found.front(); });
  return {Quantity::other, found.front(), asForce};
}

std::string_view quantityOfUnit(std::string_view unit) {
  const auto units = entriesOf(WordKind::unit);
  const auto found = std::ranges::find(units, unit, &LexiconEntry::word);
  return found != units.end() ? found->value : std::string_view();
}

}  // namespace detent::importer
