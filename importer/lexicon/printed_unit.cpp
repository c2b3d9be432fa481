// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lexicon/printed_unit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <vector>

#include "importer/lexicon/letters.h"
#include "importer/lexicon/quantity_symbol.h"
#include "model/text.h"

namespace detent::importer {
namespace {

/// Units in which no button's graph is printed. On a page they are a misread smaller unit, or the unit of
/// another quantity.
constexpr std::array unprintedForces{ForceUnit::micronewton, ForceUnit::meganewton};
constexpr std::array unprintedLengths{LengthUnit::metre, LengthUnit::nanometre};

/// The title with full-width letters, full-width and angled brackets, and other blanks replaced by ASCII.
std::string plainTitle(std::string_view s) {
  std::string out;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const auto byte = [&](std::size_t k) {
      return i + k < s.size() ? static_cast<unsigned char>(s[i + k]) : 0U;
    };
    if (byte(0) == 0xEF && (byte(1) == 0xBC || byte(1) == 0xBD)) {  // U+FF01..U+FF5E: ASCII from '!' on
      const unsigned code = (byte(1) == 0xBC ? 0x00U : 0x40U) + (byte(2) - 0x80U) + 0x20U;
      out += code < 0x7F ? static_cast<char>(code) : ' ';
      i += 2;
    } else if (byte(0) == 0xE3 && byte(1) == 0x80 && (byte(2) == 0x90 || byte(2) == 0x91)) {
      out += byte(2) == 0x90 ? '[' : ']';
      i += 2;
    } else if (byte(0) == 0xE3 && byte(1) == 0x80 && byte(2) == 0x80) {
      out += ' ';
      i += 2;
    } else if (byte(0) == 0xC2 && byte(1) == 0xA0) {
      out += ' ';
      i += 1;
    } else if (byte(0) == 0xE2 && byte(1) == 0x82 && byte(2) == 0xAC &&
               // a bracket in a stroke font is read as a euro sign
               s.find_first_of("([") == std::string_view::npos) {
      out += '(';
      i += 2;
    } else if (s[i] == '<' || (s[i] == '>' && out.rfind('(') + 1 > out.rfind(')') + 1)) {
      out += s[i] == '<' ? '(' : ')';
    } else {
      out += s[i];
    }
  }
  return out;
}

struct Piece {
  std::string text;
  double sure;           // confidence that this is a unit, by its place in the title
  bool last = false;     // only a blank separates it from the words before it
  bool shorter = false;  // same as the previous piece, without a first letter that may be a misread bracket
};

std::string withoutBrackets(std::string_view s) {
  const auto first = s.find_first_not_of(" \t[](){}|:;'"), last = s.find_last_not_of(" \t[](){}|:;'");
  return first == std::string_view::npos ? std::string() : std::string(s.substr(first, last - first + 1));
}

std::string withoutBlanks(std::string s) {
  std::erase(s, ' ');
  return s;
}

/// The title without an arrow at its end, as printed or as a recogniser reads it: "Travel (mm) ->".
std::string withoutArrow(std::string t) {
  constexpr std::array tails{
      " ", "-", ">", "=", "_", "\xE2\x86\x92", "\xE2\x86\x91", "\xE2\x80\x94", "\xE2\x80\x93", "\xC2\xBB"};
  for (bool found = true; found;) {
    found = false;
    for (const std::string_view tail : tails)
      if (t.size() > tail.size() && t.ends_with(tail)) {
        t.resize(t.size() - tail.size());
        found = true;
      }
  }
  return t;
}

/// The text after the word for "unit": "gf" of "unit: gf", "单位：gf".
std::string withoutUnitWord(std::string text) {
  const std::string low = lowered(text);
  for (const std::string_view word :
       {"unit", "einheit", "\xE5\x8D\x95\xE4\xBD\x8D", "\xE5\x8D\x98\xE4\xBD\x8D"}) {
    if (!low.starts_with(word)) continue;
    return withoutBrackets(std::string_view(text).substr(word.size()));
  }
  return text;
}

// characters as which a recogniser reads brackets
constexpr std::string_view likeBrackets = "IlL1|iftCcrJj";

/// Texts in brackets; if a closing bracket is missing, also the text without a last character that may be
/// one.
std::vector<std::string> bracketed(const std::string& t) {
  // bytes; without its closing bracket the text runs on, and is too long for a unit
  constexpr std::size_t longest = 24;
  std::vector<std::string> out;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] != '(' && t[i] != '[' && t[i] != '{') continue;
    auto close = t.find_first_of(")]}|", i + 1);
    const bool closed = close != std::string::npos;
    if (!closed && t[i] == '{') continue;  // a misread part of an ideograph
    if (!closed) close = t.size();
    const std::string inside =
        withoutBlanks(withoutBrackets(std::string_view(t).substr(i + 1, close - i - 1)));
    if (close - i > longest || inside.empty()) continue;
    out.push_back(withoutUnitWord(inside));
    if (!closed && inside.size() > 1 && likeBrackets.find(inside.back()) != std::string_view::npos)
      out.push_back(withoutUnitWord(inside.substr(0, inside.size() - 1)));
  }
  return out;
}

/// Corrects a capital F at the end of a unit of force: "lbF".
std::string withSmallF(std::string text) {
  if (text.size() > 1 && text.back() == 'F') text.back() = 'f';
  return text;
}

/// Adds the text before a closing bracket whose opening bracket was read as a letter: "Iegf]".
void addUnopened(const std::string& t, std::vector<Piece>& out) {
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (t[i] != ']' && t[i] != ')') continue;
    auto open = t.find_last_of(' ', i - 1);
    open = open == std::string::npos ? 0 : open + 1;
    const std::string inside = withoutBrackets(std::string_view(t).substr(open, i - open));
    if (inside.empty()) continue;
    out.push_back({inside, 0.9});
    if (likeBrackets.find(inside.front()) != std::string_view::npos)
      out.push_back({inside.substr(1), 0.7, false, true});
  }
}

bool isLetter(char c) {
  return static_cast<unsigned char>(c) >= 0x80 || std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Index at which the last part of a column's name begins: behind an underscore, full stop or hyphen, or at a
/// capital letter behind a small one; 0 if the name has one part.
std::size_t lastPartOf(std::string_view name) {
  if (const auto parting = name.find_last_of("_.-"); parting != std::string_view::npos) return parting + 1;
  for (std::size_t i = name.size(); i-- > 1;)
    if (std::isupper(static_cast<unsigned char>(name[i])) != 0 &&
        std::islower(static_cast<unsigned char>(name[i - 1])) != 0)
      return i;
  return 0;
}

/// Adds the unit at the end of a table column's name, which has no blanks: "travel_mm", "Force.N", "forceGf".
void addOfColumn(const std::string& t, std::vector<Piece>& out) {
  constexpr std::ptrdiff_t fewest = 3;  // letters of a name before a unit of one: "F_N" is a normal force
  std::string_view name = t;
  if (const auto blank = name.find_last_of(' '); blank != std::string_view::npos)
    name.remove_prefix(blank + 1);
  name = name.substr(0, name.find_last_not_of("._") + 1);
  constexpr std::string_view quotes = "\xE2\x80";  // as ideographs come back that nobody read: "“oN"
  if (name.find(quotes) != std::string_view::npos) return;
  const std::size_t from = lastPartOf(name);
  const std::string_view unit = name.substr(from);
  const auto letters = std::ranges::count_if(name.substr(0, from), isLetter);
  if (letters == 0 || unit.empty() || !std::ranges::all_of(unit, isLetter)) return;
  if (from > 0 && name[from - 1] == '-' && (unit.size() == 1 || unit == "in")) return;  // "plug-in"
  if (unit.size() > 1 || letters >= fewest) out.push_back({std::string(unit), 0.9});
}

/// Possible units in a title, the surest first: texts in brackets; if there are none, the text after a slash
/// or after "in", and the last word.
std::vector<Piece> pieces(const std::string& title) {
  const std::string t = withoutArrow(title);
  std::vector<Piece> out;
  for (auto& inside : bracketed(t)) out.push_back({std::move(inside), 1.0});
  if (!out.empty()) return out;
  addUnopened(t, out);
  if (!out.empty()) return out;
  if (const auto slash = t.rfind('/'); slash != std::string::npos)
    out.push_back({withoutBlanks(withoutBrackets(std::string_view(t).substr(slash + 1))), 0.95});
  if (const auto in = t.rfind(" in "); in != std::string::npos)
    out.push_back({withoutBrackets(std::string_view(t).substr(in + 4)), 0.95});
  else if (const auto joined = t.rfind(" in");
           joined != std::string::npos)  // "Weg inmm": a blank was not seen
    out.push_back({withoutBrackets(std::string_view(t).substr(joined + 3)), 0.85});
  addOfColumn(t, out);
  // A comma may come back as a full stop: "Force. N".
  const auto comma = t.find(',') != std::string::npos ? t.rfind(',') : t.rfind(". ");
  if (comma != std::string::npos)
    out.push_back({withoutBlanks(withoutBrackets(std::string_view(t).substr(comma + 1))), 0.9});
  if (const auto blank = t.find_last_of(' '); blank != std::string::npos)
    out.push_back({withoutBrackets(std::string_view(t).substr(blank + 1)), 0.7, true});
  else
    out.push_back({withoutBrackets(t), 0.6});
  return out;
}

/// Texts that resemble a misread unit but are not taken for one: they are words, or the end of a title.
constexpr std::array<std::string_view, 8> ambiguousReadings{"of", "am", "H", "r", "(N", "02", "mi", "af"};

/// Returns true if a piece may be a unit. A single letter, which may be the end of a word, is a unit only
/// where a unit must stand.
bool mayBeUnit(const Piece& piece) {
  if (piece.sure >= 0.9) return true;
  return piece.text.size() > 1 ? piece.text != "in" : piece.text == "N" || piece.text == "g";
}

/// The unit among a title's pieces, unless the title names a quantity that is not measured in it. `agrees`:
/// the title names this quantity.
template <class Unit, std::size_t M, class FromSymbol>
std::optional<PrintedUnit<Unit>> unitIn(const std::string& title, TextSource source, bool agrees,
                                        const std::array<Unit, M>& unprinted, FromSymbol fromSymbol) {
  std::optional<PrintedUnit<Unit>> best;
  const bool withCyrillic = hasCyrillic(title);
  const auto offer = [&](std::optional<Unit> unit, double sure) {
    const bool isPrinted = unit && std::ranges::find(unprinted, *unit) == unprinted.end();
    if (isPrinted && (!best || sure > best->sure)) best = PrintedUnit<Unit>{*unit, sure};
  };
  for (Piece& piece : pieces(title)) {
    piece.text = withSmallF(std::move(piece.text));
    const auto unit = fromSymbol(piece.text);
    if (piece.shorter && unit && best && best->unit != *unit) return {};  // "CN]": of "[N]" or of "cN]"
    if (mayBeUnit(piece)) offer(unit, piece.sure);
    // The last word may be a misread unit if it is a word in no language: "Load Ibf".
    const bool behindWord =
        piece.last && agrees && std::ranges::find(ambiguousReadings, piece.text) == ambiguousReadings.end();
    if (piece.sure < 0.9 && !behindWord) continue;
    const auto reading = unitReadAs(piece.text, source, withCyrillic);
    if (reading && (agrees || !reading->needsQuantity))
      offer(fromSymbol(reading->printed), piece.sure * (1 - reading->cost));
  }
  return best;
}

/// Returns a name that contradicts force and travel in a title without a word for either: a letter of another
/// quantity in front of the unit, or a word of a document's own title that the lexicon does not know. Empty
/// without any. Words in recognised text are ignored, because their letters may be wrong.
std::string unknownNameIn(const std::string& title, TextSource source) {
  constexpr std::size_t fewest = 4;  // letters of a word
  if (quantityNamedIn(title, source).quantity != Quantity::none) return {};
  if (const auto symbol = symbolBeforeUnit(withoutArrow(title), source))
    return symbol->agrees ? std::string() : symbol->letter;
  if (source != TextSource::exact) return {};
  for (const std::string& word : wordsOf(title)) {
    const bool isKnown =
        matchWord(word,
                  {WordKind::press, WordKind::release, WordKind::point, WordKind::curve, WordKind::variant},
                  source)
            .has_value();
    if (letterCount(word) >= fewest && !isWrittenTogether(word) && !isKnown && !forceUnitFrom(word) &&
        !lengthUnitFrom(word))
      return word;
  }
  return {};
}

/// Returns true if a unit of force or length stands where only units stand: in brackets, after a slash or a
/// comma.
bool hasUnitInPlace(const std::string& title, TextSource source) {
  return std::ranges::any_of(pieces(title), [&](const Piece& piece) {
    const auto reading = unitReadAs(piece.text, source, false);
    const bool isUnit = forceUnitFrom(piece.text) || lengthUnitFrom(piece.text);
    return piece.sure >= 0.9 && (isUnit || (reading && !reading->needsQuantity));
  });
}

/// Words of a heading that may be units: the parts of its brackets, or without brackets the words behind
/// "in". `perLength`: "N/mm" in a bracket are two.
std::vector<std::string> headingTokens(const std::string& heading, bool perLength) {
  std::vector<std::string> tokens;
  const auto add = [&](std::string_view token) { tokens.push_back(withSmallF(withoutBrackets(token))); };
  for (auto open = heading.find_first_of("[("); open != std::string::npos;
       open = heading.find_first_of("[(", open + 1)) {
    const auto close = std::min(heading.find_first_of(")]", open), heading.size());
    for (std::size_t from = open + 1; from <= close;) {
      const auto to = std::min(heading.find_first_of(perLength ? ",;/|" : ",;|", from), close);
      add(std::string_view(heading).substr(from, to - from));
      from = to + 1;
    }
  }
  if (!tokens.empty()) return tokens;
  constexpr std::string_view in = " in ";
  for (auto at = heading.find(in); at != std::string::npos; at = heading.find(in, at + 1)) {
    const auto from = at + in.size(), to = std::min(heading.find(' ', from), heading.size());
    add(std::string_view(heading).substr(from, to - from));
  }
  return tokens;
}

}  // namespace

std::optional<PrintedUnit<ForceUnit>> forceUnitIn(std::string_view title, TextSource source) {
  const std::string plain = plainTitle(title);
  const NamedQuantity named = quantityNamedIn(plain, source);
  if (named.quantity == Quantity::travel || (named.quantity == Quantity::other && !named.printedAsForce) ||
      !unknownNameIn(plain, source).empty())
    return {};
  return unitIn(plain, source, named.quantity != Quantity::none, unprintedForces, forceUnitFrom);
}

std::optional<PrintedUnit<LengthUnit>> lengthUnitIn(std::string_view title, TextSource source) {
  const std::string plain = plainTitle(title);
  const bool agrees = namesQuantity(plain, Quantity::travel, source);
  if (!agrees &&
      (quantityNamedIn(plain, source).quantity != Quantity::none || !unknownNameIn(plain, source).empty()))
    return {};
  return unitIn(plain, source, agrees, unprintedLengths, lengthUnitFrom);
}

std::optional<HeadingUnits> headingUnitsIn(std::string_view heading, TextSource source) {
  const std::string plain = plainTitle(heading);
  const bool namesBoth =
      namesQuantity(plain, Quantity::force, source) && namesQuantity(plain, Quantity::travel, source);
  if (namesQuantity(plain, Quantity::other, source)) return {};
  const std::vector<std::string> units = headingTokens(plain, namesBoth);
  if (units.size() != 2) return {};
  for (const auto& [ofForce, ofLength] : {std::pair(units[0], units[1]), std::pair(units[1], units[0])}) {
    const auto force = forceUnitFrom(ofForce);
    const auto length = lengthUnitFrom(ofLength);
    if (force && length && std::ranges::find(unprintedForces, *force) == unprintedForces.end() &&
        std::ranges::find(unprintedLengths, *length) == unprintedLengths.end())
      return HeadingUnits{*force, *length};
  }
  return {};
}

std::string otherQuantityIn(std::string_view title, TextSource source) {
  const std::string plain = plainTitle(title);
  const NamedQuantity named = quantityNamedIn(plain, source);
  for (const Piece& piece : pieces(plain)) {
    if (piece.sure < 0.9) continue;
    // A single letter may be a quantity's symbol ("Kraft, F") or a misreading.
    const bool isUnit = piece.text.size() > 1 || (source == TextSource::exact && piece.sure >= 1);
    if (isUnit && !quantityOfUnit(piece.text).empty()) {
      if (named.quantity == Quantity::other) return std::string(named.name) + " (" + piece.text + ")";
      return piece.text;
    }
    // A unit with other signs around it is a force per length or a multiple of a force.
    const auto sign = piece.text.find_first_of("/*^");
    const bool multiple = piece.text.starts_with("x1") || piece.text.starts_with("\xC3\x97");
    if (piece.sure >= 1 && (multiple || (sign != std::string::npos && sign > 0))) return piece.text;
  }
  if (hasUnitInPlace(plain, source))
    if (std::string unknown = unknownNameIn(plain, source); !unknown.empty()) return unknown;
  const bool isForce = named.printedAsForce && forceUnitIn(title, source);  // "Pressure, gf"
  return named.quantity == Quantity::other && !isForce ? std::string(named.name) : std::string();
}

}  // namespace detent::importer
