// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/column_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "importer/lexicon/letters.h"
#include "importer/lexicon/lexicon.h"
#include "model/check.h"
#include "model/text.h"
#include "model/units.h"

namespace detent::importer {
namespace {

/// Values of the lexicon's kind "column", in the order of ColumnWord.
constexpr std::array<std::string_view, 19> kMeanings{"displacement", "displacement-weak",
                                                     "force",        "force-weak",
                                                     "time",         "index",
                                                     "cycle",        "record",
                                                     "direction",    "press",
                                                     "release",      "contact",
                                                     "other",        "mean",
                                                     "spread",       "copy",
                                                     "unit",         "raw",
                                                     "neutral"};

constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kBrackets{
    {{"(", ")"}, {"[", "]"}, {"{", "}"}, {"<", ">"}, {"（", "）"}, {"［", "］"}, {"【", "】"}}};

bool isAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

struct Vocabulary {
  std::unordered_map<std::string, std::uint32_t> words;  // of one or more words, joined by blanks
  std::unordered_set<std::string> headFirst;             // words of Romance languages alone
  // signs of scripts without blanks, the longest first
  std::vector<std::pair<std::string, std::uint32_t>> signs;
  std::vector<std::pair<std::string, std::uint32_t>> ends;  // last parts of compounds, the longest first
  std::map<std::string, ColumnUnit, std::less<>> units, foldedUnits;
};

ColumnUnit::Kind unitKindNamed(std::string_view name) {
  if (name == "displacement") return ColumnUnit::Kind::displacement;
  if (name == "force") return ColumnUnit::Kind::force;
  if (name == "time") return ColumnUnit::Kind::time;
  return ColumnUnit::Kind::other;
}

/// mm or N in a unit of force or travel that the model knows by this spelling.
double sizeInModel(const ColumnUnit& unit) {
  const bool isForce = unit.kind == ColumnUnit::Kind::force;
  const auto force = isForce ? forceUnitFrom(unit.text) : std::nullopt;
  const auto length = isForce ? std::nullopt : lengthUnitFrom(unit.text);
  DETENT_CHECK(force || length, "lexicon.tsv gives the size of a column's unit that model/units.h lacks");
  return force ? newtonsPer(*force) : millimetresPer(*length);
}

Vocabulary readVocabulary() {
  constexpr std::string_view romance = "fr es it pt ro", compounding = "de nl sv da no";
  Vocabulary all;
  for (const LexiconEntry& entry : entriesOf(WordKind::columnUnit)) {
    const std::size_t colon = entry.value.find(':');
    const std::string spelled(entry.word);
    ColumnUnit unit{unitKindNamed(entry.value.substr(0, colon)), 1, spelled};
    if (colon == std::string_view::npos) {
      unit.size = sizeInModel(unit);
    } else {
      const std::string_view size = entry.value.substr(colon + 1);
      std::from_chars(size.data(), size.data() + size.size(), unit.size);
    }
    all.units[spelled] = unit;
    const auto [place, isNew] = all.foldedUnits.emplace(folded(spelled), unit);
    if (!isNew && (place->second.kind != unit.kind || place->second.size != unit.size))
      place->second.kind = ColumnUnit::Kind::unknown;  // "mn": milli or mega
  }
  std::map<std::string, std::uint32_t> signs, ends;
  const auto words = entriesOf(WordKind::column);
  all.words.reserve(words.size());
  for (const LexiconEntry& entry : words) {
    const auto* const named = std::ranges::find(kMeanings, entry.value);
    const std::uint32_t meaning = 1U << static_cast<unsigned>(named - kMeanings.begin());
    const std::string word(entry.word);
    (entry.form == WordForm::sign ? signs[word] : all.words[word]) |= meaning;
    if (romance.find(entry.language) != std::string_view::npos)
      all.headFirst.insert(word);
    else
      all.headFirst.erase(word);
    if (word.size() >= 3 && compounding.find(entry.language) != std::string_view::npos) ends[word] |= meaning;
  }
  const auto longestFirst = [](const auto& from, auto& list) {
    list.assign(from.begin(), from.end());
    std::ranges::stable_sort(list, std::greater<>{}, [](const auto& each) { return each.first.size(); });
  };
  longestFirst(signs, all.signs), longestFirst(ends, all.ends);
  return all;
}

const Vocabulary& vocabulary() {
  static const Vocabulary all = readVocabulary();
  return all;
}

/// The words of a title in small letters. "forceN" and "force_N" are split into two words.
std::vector<std::string> titleWords(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  const auto end = [&] {
    if (!word.empty()) words.push_back(folded(word));
    word.clear();
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool letter =
        isAsciiLetter(c) || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80 || c == '#';
    if (!letter || (i > 0 && c >= 'A' && c <= 'Z' && text[i - 1] >= 'a' && text[i - 1] <= 'z')) end();
    if (letter) word += c;
  }
  end();
  return words;
}

std::uint32_t meaningsOf(const std::string& word) {
  const Vocabulary& all = vocabulary();
  if (const auto found = all.words.find(word); found != all.words.end()) return found->second;
  std::string singular = word;
  if (singular.size() > 4 && singular.back() == 's') {
    singular.pop_back();
    if (const auto found = all.words.find(singular); found != all.words.end()) return found->second;
  }
  // A word with a number: "ch1", "run2". Single letters with a number count only if they name axes: "y1".
  std::string stem = word;
  while (!stem.empty() && stem.back() >= '0' && stem.back() <= '9') stem.pop_back();
  constexpr auto axes = static_cast<std::uint32_t>(ColumnWord::displacementWeak) |
                        static_cast<std::uint32_t>(ColumnWord::forceWeak);
  if (!stem.empty() && stem.size() < word.size())
    if (const auto found = all.words.find(stem);
        found != all.words.end() && (stem.size() >= 2 || found->second == (found->second & axes)))
      return found->second;
  for (const auto& [ending, meanings] : all.ends)
    if (word.size() >= ending.size() + 3 && word.ends_with(ending)) return meanings;
  return 0;
}

std::optional<double> factorIn(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return {};
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return {};
  std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (rest.empty()) return value > 0 ? std::optional(value) : std::nullopt;
  if (value != 10) return {};
  if (rest.front() == '^') {
    rest.remove_prefix(1);
    int power = 0;
    const auto [last, wrong] = std::from_chars(rest.data(), rest.data() + rest.size(), power);
    return wrong == std::errc() && last == rest.data() + rest.size() ? std::optional(std::pow(10.0, power))
                                                                     : std::nullopt;
  }
  // Superscript digits.
  constexpr std::array<std::string_view, 10> superscripts{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  bool negative = false;
  int power = 0;
  if (rest.starts_with("⁻")) negative = true, rest.remove_prefix(std::string_view("⁻").size());
  while (!rest.empty()) {
    const auto* digit =
        std::ranges::find_if(superscripts, [&](std::string_view s) { return rest.starts_with(s); });
    if (digit == superscripts.end()) return {};
    power = 10 * power + static_cast<int>(digit - superscripts.begin());
    rest.remove_prefix(digit->size());
  }
  return std::pow(10.0, negative ? -power : power);
}

ColumnUnit unitSpelled(std::string_view text) {
  const Vocabulary& all = vocabulary();
  if (const auto found = all.units.find(text); found != all.units.end()) return found->second;
  if (const auto found = all.foldedUnits.find(folded(text)); found != all.foldedUnits.end())
    return found->second;
  return {ColumnUnit::Kind::unknown, 1, std::string(text)};
}

bool isMeasured(const ColumnUnit& unit) { return unit.isOfButton() || unit.kind == ColumnUnit::Kind::time; }

/// A fraction of a unit: "1/64 in".
std::optional<ColumnUnit> fractionOfUnit(std::string_view text) {
  double above = 0, below = 0;
  const char* const end = text.data() + text.size();
  const auto [slash, wrongAbove] = std::from_chars(text.data(), end, above);
  if (wrongAbove != std::errc() || slash == end || *slash != '/') return {};
  const auto [rest, wrongBelow] = std::from_chars(slash + 1, end, below);
  if (wrongBelow != std::errc() || !(above > 0) || !(below > 0)) return {};
  ColumnUnit unit = unitSpelled(trimmed(std::string_view(rest, static_cast<std::size_t>(end - rest))));
  if (!isMeasured(unit)) return {};
  unit.size *= above / below, unit.text = std::string(text);
  return unit;
}

/// Returns true for units one after the other: "N m", "N s".
bool isProductOfUnits(std::string_view text) {
  std::size_t units = 0;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (unitSpelled(text.substr(at, end - at)).kind == ColumnUnit::Kind::unknown) return false;
    ++units, at = end + 1;
  }
  return units > 1;
}

std::string_view withoutBrackets(std::string_view text) {
  text = trimmed(text);
  for (const auto& [open, close] : kBrackets)
    if (text.size() > open.size() + close.size() && text.starts_with(open) && text.ends_with(close))
      return trimmed(text.substr(open.size(), text.size() - open.size() - close.size()));
  return text;
}

}  // namespace

bool KnownWords::has(ColumnWord meaning) const {
  return std::ranges::any_of(words, [&](const Word& word) { return word.has(meaning); });
}

KnownWords knownWordsIn(std::string_view text) {
  const Vocabulary& all = vocabulary();
  KnownWords known;
  constexpr std::size_t longestPhrase = 4;  // words
  const std::vector<std::string> words = titleWords(text);
  for (std::size_t i = 0; i < words.size();) {
    std::size_t taken = 0;
    for (std::size_t length = std::min(longestPhrase, words.size() - i); length > 1 && !taken; --length) {
      std::string phrase = words[i];
      for (std::size_t k = 1; k < length; ++k) phrase += " " + words[i + k];
      if (const auto found = all.words.find(phrase); found != all.words.end()) {
        known.words.push_back({phrase, found->second});
        taken = length;
      }
    }
    if (!taken) {
      taken = 1;
      if (const std::uint32_t meanings = meaningsOf(words[i])) {
        if (all.headFirst.contains(words[i])) known.headFirst = true;
        known.words.push_back({words[i], meanings});
      } else {
        std::string rest = words[i];
        bool any = false;
        for (std::size_t at = 0; at < rest.size();) {
          const auto sign = std::ranges::find_if(all.signs, [&](const auto& each) {
            return std::string_view(rest).substr(at).starts_with(each.first);
          });
          if (sign == all.signs.end()) {
            ++at;
            continue;
          }
          known.words.push_back({sign->first, sign->second});
          at += sign->first.size(), any = true;
        }
        if (!any) ++known.unknown;
      }
    }
    i += taken;
  }
  return known;
}

ColumnUnit unitOf(std::string_view text) {
  const std::string_view whole = withoutBrackets(text);
  if (whole.empty() || whole == "-" || whole == "--" || whole == "n/a" || whole == "1") return {};
  ColumnUnit unit = unitSpelled(whole);
  if (unit.kind != ColumnUnit::Kind::unknown) return unit.text = std::string(whole), unit;
  if (auto fraction = fractionOfUnit(whole)) return *fraction;
  // A factor in front of a unit: "x0.1 N", "×10⁻³ N", "0.1 N".
  constexpr std::array<std::string_view, 5> signs{"x", "X", "×", "*", "·"};
  std::string_view bare = whole;
  for (const std::string_view sign : signs)
    if (bare.starts_with(sign) && bare.size() > sign.size() &&
        (bare[sign.size()] == ' ' || bare[sign.size()] == '.' ||
         (bare[sign.size()] >= '0' && bare[sign.size()] <= '9')))
      bare = trimmed(bare.substr(sign.size()));
  for (std::size_t cut = 1; cut < bare.size(); ++cut) {
    const auto factor = factorIn(bare.substr(0, cut));
    std::string_view rest = trimmed(bare.substr(cut));
    for (const std::string_view sign : signs)
      if (rest.starts_with(sign) && rest.size() > sign.size()) rest = trimmed(rest.substr(sign.size()));
    if (!factor || rest.empty()) continue;
    ColumnUnit scaled = unitSpelled(rest);
    if (!isMeasured(scaled)) continue;
    return scaled.size *= *factor, scaled.text = std::string(whole), scaled;
  }
  // A compound unit measures another quantity, whatever its parts are: "N m", "N/mm".
  if (isProductOfUnits(whole)) return {ColumnUnit::Kind::other, 1, std::string(whole)};
  const bool compound =
      whole.find_first_of("/^*") != std::string_view::npos || whole.find("²") != std::string_view::npos ||
      whole.find("³") != std::string_view::npos || whole.find("·") != std::string_view::npos ||
      whole.find("⋅") != std::string_view::npos;
  if (compound && whole.size() <= 16) {
    const std::string_view first = trimmed(whole.substr(0, whole.find_first_of("/^*\xC2\xE2")));
    if (unitSpelled(first).kind != ColumnUnit::Kind::unknown)
      return {ColumnUnit::Kind::other, 1, std::string(whole)};
  }
  return {ColumnUnit::Kind::unknown, 1, std::string(whole)};
}

SplitTitle splitTitle(std::string_view given) {
  const std::string_view title = trimmed(given);
  SplitTitle split{std::string(title), {}};
  if (title.empty()) return split;
  // Takes the last bracket that contains a unit. A bracket with another text is kept as an unknown unit.
  ColumnUnit unknown;
  for (const auto& [open, close] : kBrackets)
    for (std::size_t from = title.rfind(open); from != std::string_view::npos;
         from = from == 0 ? std::string_view::npos : title.rfind(open, from - 1)) {
      const std::size_t to = title.find(close, from + open.size());
      if (to == std::string_view::npos) continue;
      const std::string_view inside = trimmed(title.substr(from + open.size(), to - from - open.size()));
      const ColumnUnit unit = unitOf(inside);
      if (unit.kind == ColumnUnit::Kind::none) continue;
      if (unit.kind == ColumnUnit::Kind::unknown) {
        constexpr std::size_t longestUnit_bytes = 8;
        if (unknown.text.empty() && inside.size() <= longestUnit_bytes &&
            inside.find(' ') == std::string_view::npos && knownWordsIn(inside).words.empty() &&
            to + close.size() == title.size())
          unknown = unit;
        continue;
      }
      split.unit = unit;
      split.name = std::string(trimmed(title.substr(0, from))) + " " +
                   std::string(trimmed(title.substr(to + close.size())));
      split.name = std::string(trimmed(split.name));
      return split;
    }
  const ColumnUnit whole = unitOf(title);
  if (whole.kind != ColumnUnit::Kind::unknown && whole.kind != ColumnUnit::Kind::other) return {"", whole};
  // The unit may follow a slash, a comma, an underscore, "in", or a blank.
  const std::size_t at = title.find_last_of(" _/,:;.-");
  for (const std::size_t cut : {title.find('/'), title.find(" in "), title.find(", "), at}) {
    if (cut == std::string_view::npos || cut == 0) continue;
    const bool preposition = title.substr(cut).starts_with(" in ");
    const std::string_view behind = trimmed(title.substr(cut + (preposition ? 4 : 1)));
    const ColumnUnit unit = unitOf(behind);
    if (!unit.isKnown()) continue;
    const bool byBlank = cut == at && (title[cut] == ' ' || title[cut] == '-' || title[cut] == '.');
    // After a blank, units that are also words or numbering letters do not count.
    if (byBlank && !preposition &&
        (!isMeasured(unit) || behind == "in" || behind == "min" || behind == "p" || behind == "m" ||
         behind == "h" || behind == "#" || behind == "thou" || behind == "MN" || behind == "T"))
      continue;
    if (!byBlank && unit.kind == ColumnUnit::Kind::other && behind.size() < 2) continue;
    return {std::string(trimmed(title.substr(0, cut))), unit};
  }
  // The unit may begin with a capital letter, if the name before it fits the unit: "ForceLb", "travelMm".
  for (std::size_t i = 1; i < title.size() && unknown.text.empty(); ++i) {
    if (!(title[i - 1] >= 'a' && title[i - 1] <= 'z' && title[i] >= 'A' && title[i] <= 'Z')) continue;
    const ColumnUnit unit = unitOf(title.substr(i));
    const KnownWords words = knownWordsIn(title.substr(0, i));
    if ((unit.kind == ColumnUnit::Kind::force && words.has(ColumnWord::force)) ||
        (unit.kind == ColumnUnit::Kind::displacement && words.has(ColumnWord::displacement)) ||
        (unit.kind == ColumnUnit::Kind::time && words.has(ColumnWord::time)))
      return {std::string(title.substr(0, i)), unit};
  }
  split.unit = unknown;
  return split;
}

}  // namespace detent::importer
