// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/printed_unit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <vector>

#include "importer/axes/word_match.h"
#include "model/text.h"

namespace detent::importer {
namespace {

/// What a recogniser makes of a unit. Readings that are units or words of their own count only beside a word that names
/// the quantity.
template <class Unit>
struct Misreading {
  std::string_view text;  // blanks removed
  Unit unit;
  double sure;
  bool needsWord;
};

constexpr std::array forceMisreadings{Misreading<ForceUnit>{"eN", ForceUnit::centinewton, 0.8, false},
                                      Misreading<ForceUnit>{"\xC2\xA2N", ForceUnit::centinewton, 0.8, false},
                                      Misreading<ForceUnit>{"oN", ForceUnit::centinewton, 0.6, true},
                                      Misreading<ForceUnit>{"(N", ForceUnit::centinewton, 0.5, true},
                                      Misreading<ForceUnit>{"cM", ForceUnit::centinewton, 0.5, true},
                                      Misreading<ForceUnit>{"of", ForceUnit::gramForce, 0.6, true},
                                      Misreading<ForceUnit>{"gt", ForceUnit::gramForce, 0.6, true},
                                      Misreading<ForceUnit>{"9f", ForceUnit::gramForce, 0.7, false},
                                      Misreading<ForceUnit>{"af", ForceUnit::gramForce, 0.6, false},
                                      Misreading<ForceUnit>{"ef", ForceUnit::gramForce, 0.6, false},
                                      Misreading<ForceUnit>{"sf", ForceUnit::gramForce, 0.6, false},
                                      Misreading<ForceUnit>{"mMN", ForceUnit::millinewton, 0.7, false},
                                      Misreading<ForceUnit>{"0z", ForceUnit::ounceForce, 0.8, false},
                                      Misreading<ForceUnit>{"0zf", ForceUnit::ounceForce, 0.8, false},
                                      Misreading<ForceUnit>{"02f", ForceUnit::ounceForce, 0.6, true},
                                      Misreading<ForceUnit>{"Ibf", ForceUnit::poundForce, 0.8, false},
                                      Misreading<ForceUnit>{"1bf", ForceUnit::poundForce, 0.8, false},
                                      Misreading<ForceUnit>{"Ib", ForceUnit::poundForce, 0.8, false},
                                      Misreading<ForceUnit>{"1b", ForceUnit::poundForce, 0.8, false},
                                      Misreading<ForceUnit>{"02", ForceUnit::ounceForce, 0.6, false},
                                      Misreading<ForceUnit>{"gef", ForceUnit::gramForce, 0.6, true},
                                      // Cyrillic, named by the Latin letters it looks like.
                                      Misreading<ForceUnit>{"H", ForceUnit::newton, 0.8, false},
                                      Misreading<ForceUnit>{"cH", ForceUnit::centinewton, 0.8, false},
                                      Misreading<ForceUnit>{"CH", ForceUnit::centinewton, 0.7, false},
                                      Misreading<ForceUnit>{"MH", ForceUnit::millinewton, 0.8, false},
                                      Misreading<ForceUnit>{"mH", ForceUnit::millinewton, 0.8, false},
                                      Misreading<ForceUnit>{"r", ForceUnit::gramForce, 0.7, false},
                                      Misreading<ForceUnit>{"rc", ForceUnit::gramForce, 0.8, false},
                                      Misreading<ForceUnit>{"Krc", ForceUnit::kilogramForce, 0.8, false},
                                      Misreading<ForceUnit>{"krc", ForceUnit::kilogramForce, 0.8, false},
                                      Misreading<ForceUnit>{"Kr", ForceUnit::kilogramForce, 0.7, false}};

constexpr std::array lengthMisreadings{Misreading<LengthUnit>{"rnm", LengthUnit::millimetre, 0.8, false},
                                       Misreading<LengthUnit>{"mrn", LengthUnit::millimetre, 0.8, false},
                                       Misreading<LengthUnit>{"mmn", LengthUnit::millimetre, 0.8, false},
                                       Misreading<LengthUnit>{"1mm", LengthUnit::millimetre, 0.7, false},
                                       Misreading<LengthUnit>{"lmm", LengthUnit::millimetre, 0.7, false},
                                       Misreading<LengthUnit>{"nm", LengthUnit::millimetre, 0.6, true},
                                       Misreading<LengthUnit>{"mn", LengthUnit::millimetre, 0.5, true},
                                       Misreading<LengthUnit>{"am", LengthUnit::millimetre, 0.5, true},
                                       Misreading<LengthUnit>{"mim", LengthUnit::millimetre, 0.7, true},
                                       Misreading<LengthUnit>{"imm", LengthUnit::millimetre, 0.7, true},
                                       Misreading<LengthUnit>{"mii", LengthUnit::mil, 0.6, true},
                                       Misreading<LengthUnit>{"mi", LengthUnit::mil, 0.5, true},
                                       // The English model knows no Greek letter.
                                       Misreading<LengthUnit>{"pm", LengthUnit::micrometre, 0.8, true},
                                       Misreading<LengthUnit>{"ym", LengthUnit::micrometre, 0.8, true},
                                       Misreading<LengthUnit>{"wm", LengthUnit::micrometre, 0.8, true},
                                       Misreading<LengthUnit>{"jm", LengthUnit::micrometre, 0.8, true},
                                       Misreading<LengthUnit>{"jum", LengthUnit::micrometre, 0.8, true},
                                       Misreading<LengthUnit>{"lum", LengthUnit::micrometre, 0.8, true},
                                       Misreading<LengthUnit>{"Hm", LengthUnit::micrometre, 0.8, true},
                                       Misreading<LengthUnit>{"vm", LengthUnit::micrometre, 0.7, true},
                                       Misreading<LengthUnit>{"nn", LengthUnit::millimetre, 0.5, true},
                                       // Cyrillic, named by the Latin letters it looks like.
                                       Misreading<LengthUnit>{"MKM", LengthUnit::micrometre, 0.8, false},
                                       Misreading<LengthUnit>{"mkm", LengthUnit::micrometre, 0.8, false},
                                       Misreading<LengthUnit>{"Mkm", LengthUnit::micrometre, 0.8, false},
                                       Misreading<LengthUnit>{"MkM", LengthUnit::micrometre, 0.8, false}};

/// No button's graph is printed in these; on a page they are a smaller unit misread, or another quantity.
constexpr std::array unprintedForces{ForceUnit::micronewton, ForceUnit::meganewton};
constexpr std::array unprintedLengths{LengthUnit::metre, LengthUnit::nanometre};

constexpr std::array forceWords{"force", "kraft", "load", "weight", "力",
                                "荷重",  "сила",  "усил", "fuerza", "carga"};
constexpr std::array lengthWords{"travel", "stroke",     "displacement", "deflection", "distance", "weg",
                                 "hub",    "course",     "depth",        "position",   "行程",     "位移",
                                 "変位",   "ストローク", "перемещение",  "ход",        "recorrido"};

/// Units of other quantities, whole. Single letters are left out: a recogniser makes them of anything.
constexpr std::array otherUnits{"ms",
                                "sec",
                                "secs",
                                "min",
                                "hrs",
                                "Hz",
                                "kHz",
                                "MHz",
                                "Pa",
                                "hPa",
                                "kPa",
                                "MPa",
                                "GPa",
                                "bar",
                                "mbar",
                                "psi",
                                "mV",
                                "kV",
                                "mA",
                                "\xC2\xB5"
                                "A",
                                "uA",
                                "Ohm",
                                "ohm",
                                "ohms",
                                "kOhm",
                                "MOhm",
                                "mOhm",
                                "\xCE\xA9",
                                "k\xCE\xA9",
                                "m\xCE\xA9",
                                "\xE2\x84\xA6",
                                "mW",
                                "kW",
                                "\xC2\xB0",
                                "\xC2\xB0"
                                "C",
                                "\xC2\xB0"
                                "F",
                                "deg",
                                "rad",
                                "Nm",
                                "mNm",
                                "Ncm",
                                "Nmm",
                                "km",
                                "dB",
                                "dBA",
                                "dB(A)",
                                "%",
                                "a.u.",
                                "arb.u.",
                                "EUR",
                                "USD",
                                "mol",
                                "mJ",
                                "kJ",
                                "rpm",
                                "pF",
                                "nF",
                                "\xC2\xB5"
                                "F",
                                "ppm",
                                "pcs",
                                "cycles"};

/// Words of titles that measure something else.
constexpr std::array otherWords{"time",         "zeit",      "cycles",      "frequency", "frequenz",
                                "pressure",     "druck [",   "stress",      "strain",    "temperature",
                                "temperatur",   "voltage",   "spannung",    "current",   "resistance",
                                "widerstand",   "torque",    "drehmoment",  "angle",     "winkel",
                                "acceleration", "speed",     "velocity",    "stiffness", "energy",
                                "wavelength",   "intensity", "probability", "price",     "month"};

/// Full-width letters and brackets, angled ones, and blanks of other widths, to plain ones.
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
    } else if (byte(0) == 0xE2 && byte(1) == 0x82 &&
               byte(2) == 0xAC) {  // a bracket of a stroke font, as read
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
  double sure;           // of being a unit by where it stands
  bool last = false;     // nothing but blanks sets it apart from the words before it
  bool shorter = false;  // the piece before it, its first letter taken for a bracket
};

std::string withoutBrackets(std::string_view s) {
  const auto first = s.find_first_not_of(" \t[](){}|:;'"), last = s.find_last_not_of(" \t[](){}|:;'");
  return first == std::string_view::npos ? std::string() : std::string(s.substr(first, last - first + 1));
}

std::string withoutBlanks(std::string s) {
  std::erase(s, ' ');
  return s;
}

/// Without the arrow that some titles end in, as printed or as a recogniser sees it: "Travel (mm) ->".
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

/// "unit: gf", "单位：gf": what stands after the word.
std::string withoutUnitWord(std::string text) {
  const std::string low = lowered(text);
  for (const std::string_view word :
       {"unit", "einheit", "\xE5\x8D\x95\xE4\xBD\x8D", "\xE5\x8D\x98\xE4\xBD\x8D"}) {
    if (!low.starts_with(word)) continue;
    return withoutBrackets(std::string_view(text).substr(word.size()));
  }
  return text;
}

constexpr std::string_view likeBrackets = "IlL1|iftCcrJj";  // what a recogniser makes of one

/// What stands in brackets, also with what may be the closing one taken off.
std::vector<std::string> bracketed(const std::string& t) {
  constexpr std::size_t longest = 24;  // bytes; a recogniser loses closing brackets, and the rest is no unit
  std::vector<std::string> out;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] != '(' && t[i] != '[' && t[i] != '{') continue;
    auto close = t.find_first_of(")]}|", i + 1);
    const bool closed = close != std::string::npos;
    if (!closed && t[i] == '{') continue;  // a rest of an ideograph
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

/// "lbF": the letter of a force, written large.
std::string withSmallF(std::string text) {
  if (text.size() > 1 && text.back() == 'F') text.back() = 'f';
  return text;
}

/// "Iegf]": the opening bracket was read as a letter.
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

bool isUnitLetter(char c) {
  return static_cast<unsigned char>(c) >= 0x80 || std::isalpha(static_cast<unsigned char>(c)) != 0;
}

/// Where the last part of a column's name begins: behind a stroke at its foot or a full stop, at a capital behind a small letter; 0 if
/// it has no parts.
std::size_t lastPartOf(std::string_view name) {
  if (const auto parting = name.find_last_of("_.-"); parting != std::string_view::npos) return parting + 1;
  for (std::size_t i = name.size(); i-- > 1;)
    if (std::isupper(static_cast<unsigned char>(name[i])) != 0 &&
        std::islower(static_cast<unsigned char>(name[i - 1])) != 0)
      return i;
  return 0;
}

/// "travel_mm", "Force.N", "forceGf": titles that are names of a table's columns, which have no blanks, end in their unit.
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
  const auto letters = std::ranges::count_if(name.substr(0, from), isUnitLetter);
  if (letters == 0 || unit.empty() || !std::ranges::all_of(unit, isUnitLetter)) return;
  if (from > 0 && name[from - 1] == '-' && (unit.size() == 1 || unit == "in")) return;  // "plug-in"
  if (unit.size() > 1 || letters >= fewest) out.push_back({std::string(unit), 0.9});
}

/// Where units stand in titles, surest first: in brackets; without any after a slash, after "in", as the last word.
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

template <std::size_t N>
bool hasWord(const std::string& low, const std::array<const char*, N>& words) {
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return mentions(low, word); });
}

/// Misreadings of units that are words, or letters that end a title.
constexpr std::array<std::string_view, 8> words{"of", "am", "H", "r", "(N", "02", "mi", "af"};

/// A letter that may be a word's end is a unit only where a unit must stand.
bool mayBeUnit(const Piece& piece) {
  if (piece.sure >= 0.9) return true;
  return piece.text.size() > 1 ? piece.text != "in" : piece.text == "N" || piece.text == "g";
}

template <class Unit, std::size_t N, std::size_t M, class FromSymbol>
std::optional<PrintedUnit<Unit>> unitIn(std::string_view title,
                                        const std::array<Misreading<Unit>, N>& misreadings,
                                        const std::array<Unit, M>& unprinted, bool hasQuantityWord,
                                        FromSymbol fromSymbol) {
  std::optional<PrintedUnit<Unit>> best;
  const auto offer = [&](Unit unit, double sure) {
    if (!best || sure > best->sure) best = PrintedUnit<Unit>{unit, sure};
  };
  for (Piece& piece : pieces(plainTitle(title))) {
    piece.text = withSmallF(std::move(piece.text));
    const auto unit = fromSymbol(piece.text);
    if (piece.shorter && unit && best && best->unit != *unit) return {};  // "CN]": of "[N]" or of "cN]"
    if (unit && mayBeUnit(piece) && std::ranges::find(unprinted, *unit) == unprinted.end())
      offer(*unit, piece.sure);
    // "Load Ibf": a last word that no language has.
    const bool behindWord =
        piece.last && hasQuantityWord && std::ranges::find(words, piece.text) == words.end();
    if (piece.sure < 0.9 && !behindWord) continue;
    for (const auto& m : misreadings)
      if (piece.text == m.text && (hasQuantityWord || !m.needsWord)) offer(m.unit, piece.sure * m.sure);
  }
  return best;
}

/// What stands where a heading names units: the parts of its brackets, without any what stands behind "in". `perLength`: "N/mm" in a
/// bracket are two.
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

std::optional<PrintedUnit<ForceUnit>> forceUnitIn(std::string_view title) {
  return unitIn(title, forceMisreadings, unprintedForces, hasWord(lowered(plainTitle(title)), forceWords),
                forceUnitFrom);
}

std::optional<PrintedUnit<LengthUnit>> lengthUnitIn(std::string_view title) {
  return unitIn(title, lengthMisreadings, unprintedLengths, hasWord(lowered(plainTitle(title)), lengthWords),
                lengthUnitFrom);
}

std::optional<HeadingUnits> headingUnitsIn(std::string_view heading) {
  const std::string t = plainTitle(heading), low = lowered(t);
  const bool namesBoth = hasWord(low, forceWords) && hasWord(low, lengthWords);
  if (std::ranges::any_of(otherWords, [&](const char* word) { return low.find(word) != std::string::npos; }))
    return {};
  const std::vector<std::string> units = headingTokens(t, namesBoth);
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

std::string otherQuantityIn(std::string_view title) {
  const std::string t = plainTitle(title), low = lowered(t);
  for (const Piece& piece : pieces(t)) {
    if (piece.sure < 0.9) continue;
    if (std::find(otherUnits.begin(), otherUnits.end(), piece.text) != otherUnits.end()) return piece.text;
    // A force per length, a multiple of a force: a unit with more around it.
    const auto sign = piece.text.find_first_of("/*^");
    const bool multiple = piece.text.starts_with("x1") || piece.text.starts_with("\xC3\x97");
    if (piece.sure >= 1 && (multiple || (sign != std::string::npos && sign > 0))) return piece.text;
  }
  if (hasWord(low, forceWords) || hasWord(low, lengthWords)) return {};
  for (const std::string_view word : otherWords)
    if (low.find(word) != std::string::npos) return std::string(word);
  return {};
}

}  // namespace detent::importer
