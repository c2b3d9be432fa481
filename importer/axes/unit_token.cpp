// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/unit_token.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "importer/frame/glyph_marks.h"
#include "importer/lexicon/lexicon.h"
#include "model/units.h"

namespace detent::importer {
namespace {

/// Returns true for the first byte of a character of UTF-8.
bool startsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

/// The symbol of a unit of plots, for a correct reading or a usual misreading; empty if there is none.
/// `apart`: a mark separates the unit. A misreading that needs the quantity's name as confirmation is
/// returned as it was read: "H" may be newton (Н) or henry, which the whole title decides.
std::string_view symbolIn(std::string_view core, bool apart) {
  constexpr double surelyMisread = 0.5;             // cost of a reading
  constexpr std::array others{"n", "p", "m", "P"};  // official units that no plot uses
  if (std::ranges::find(others, core) != others.end()) return {};
  if (const auto reading = unitReadAs(core, TextSource::recognised, false))
    return !reading->needsQuantity                  ? reading->printed
           : apart && reading->cost < surelyMisread ? core
                                                    : std::string_view();
  if (const auto force = forceUnitFrom(core);
      force && *force != ForceUnit::meganewton && *force != ForceUnit::micronewton)
    return symbolOf(*force);
  const auto length = lengthUnitFrom(core);
  return length && *length != LengthUnit::metre && *length != LengthUnit::nanometre ? symbolOf(*length)
                                                                                    : std::string_view();
}

bool isBracket(char c) { return c == '(' || c == ')' || c == '[' || c == ']'; }
bool isMark(char c) { return isBracket(c) || c == '/' || c == ',' || c == '.' || c == ' '; }

/// Joins blobs above one another (an i and its dot, the parts of a syllable) to one letter.
std::vector<Box> joinedAlong(std::vector<Box> blobs) {
  std::sort(blobs.begin(), blobs.end(), [](const Box& a, const Box& b) { return a.x0 < b.x0; });
  std::vector<Box> letters;
  for (const Box& b : blobs) {
    const double shared = letters.empty() ? 0 : std::min(letters.back().x1, b.x1) - b.x0;
    if (shared > 0.4 * std::min(b.width(), letters.empty() ? b.width() : letters.back().width()))
      letters.back() = letters.back().joined(b);
    else
      letters.push_back(b);
  }
  return letters;
}

/// Indices where the unit may begin, the likeliest first: at the last word, at a bracket within it, behind
/// the last letter as wide as high, and a word earlier if a stroke or a bracket stands alone.
std::vector<std::size_t> starts(const std::vector<Box>& letters, double height) {
  constexpr double blank = 0.22, stroke = 0.45, lone = 0.65, square = 0.75;  // shares of the line's height
  constexpr std::size_t longest = 9;  // letters of a unit with its brackets
  std::vector<std::size_t> out, words;
  const auto add = [&](std::size_t at) {
    if (letters.size() - at <= longest && std::find(out.begin(), out.end(), at) == out.end())
      out.push_back(at);
  };
  for (std::size_t i = letters.size() - 1; i > 0; --i)
    if (letters[i].x0 - letters[i - 1].x1 >= blank * height) words.push_back(i);
  words.push_back(0);
  for (std::size_t k = 0; k < std::min<std::size_t>(2, words.size()); ++k) {
    const std::size_t at = words[k];
    const bool alone =
        at > 0 && k + 1 < words.size() && at - words[k + 1] == 1 && letters[at - 1].width() <= lone * height;
    if (alone) add(at - 1);
    if (k == 0) add(at);
  }
  for (std::size_t i = letters.size() - 1; i-- > 0;) {
    const Box& b = letters[i];
    if (b.height() >= 0.9 * height && b.width() <= stroke * height) add(i);
    if (b.height() >= square * height && b.width() >= square * height) {
      add(i + 1);
      break;
    }
  }
  return out;
}

/// The unit in a reading. `apart`: a mark in front of the reading separates it from the words, as a bracket
/// or slash within the reading does.
std::optional<UnitToken> named(std::string_view text, std::size_t blobs, bool apart) {
  std::string core;
  std::size_t marks = 0;
  bool closed = false, opened = false;
  for (const char c : text) {
    if (c == ' ') continue;
    if (!isMark(c)) {
      if (closed) return {};  // "d/N": the end of a word with a unit behind it
      core += c;
      continue;
    }
    closed = !core.empty();
    opened = opened || c == '(' || c == '[';
    if ((c == ')' || c == ']') && !opened) return {};  // the brackets contain more than the unit: "[x10 gf]"
    ++marks;
    apart = apart || c != '.';
  }
  // Letters of other scripts may be read as brackets: "[H" is "Гн", henry.
  const bool isTorn = opened && !closed && core.size() == 1;
  const std::string_view symbol = symbolIn(core, apart && !isTorn);
  // Fewer letters than blobs: one was lost, such as the N of "cN".
  if (symbol.empty() || blobs > core.size() + marks) return {};
  // Without a separating mark, a short unit may be a word or the end of one.
  if (!apart && (core.size() < 2 || core == "of" || core == "in")) return {};
  return UnitToken{std::string(symbol), apart};
}

}  // namespace

std::string UnitToken::endOf(const std::string& line) const {
  std::size_t end = std::min(line.find_last_of(' '), line.find_first_of("([{"));
  // If as many letters were read as there are blobs, the letters before the unit are known: "vIN]" is "v" and
  // "[N]".
  const auto isLetter = [](char c) { return c != ' ' && startsCharacter(c); };
  if (static_cast<std::size_t>(std::ranges::count_if(line, isLetter)) == lettersOfLine)
    for (std::size_t i = 0, before = 0; i < line.size(); ++i)
      if (isLetter(line[i]) && before++ == lettersBefore) end = i;
  std::string words = line.substr(0, end);
  while (words.ends_with(' ')) words.pop_back();
  return words + (apart ? " (" + symbol + ")" : " " + symbol);
}

namespace {

/// Least confidence of a reading. A reading of at least three letters between two brackets is hardly ever
/// wrong.
double leastSure(const std::string& text) {
  constexpr double sure = 0.7, sureInBrackets = 0.5;  // confidences of the engine
  constexpr std::ptrdiff_t fewest = 5;                // signs
  // start of a UTF-8 character
  const bool whole = std::ranges::count_if(text, startsCharacter) >= fewest &&
                     (text.front() == '(' || text.front() == '[') &&
                     (text.back() == ')' || text.back() == ']');
  return whole ? sureInBrackets : sure;
}

/// Tries the line's last letters as a unit; `letters` in their order.
std::optional<UnitToken> unitTokenIn(TextReader& reader, const std::vector<Box>& letters, double height,
                                     int quarterTurns, double angle_deg) {
  constexpr std::size_t tries = 3;
  std::size_t tried = 0;
  bool behindMark = false;
  for (const std::size_t from : starts(letters, height)) {
    if (tried++ == tries) break;
    Box token = letters[from];
    for (std::size_t i = from; i < letters.size(); ++i) token = token.joined(letters[i]);
    const SeenText seen =
        reader.readLineCarefully(turned(token, 4 - quarterTurns), TextKind::unit, angle_deg);
    if (seen.confidence >= leastSure(seen.utf8))
      if (auto unit = named(seen.utf8, letters.size() - from, behindMark)) {
        unit->lettersBefore = from, unit->lettersOfLine = letters.size();
        return unit;
      }
    behindMark = !seen.utf8.empty() && seen.utf8.front() == '/';
  }
  return {};
}

}  // namespace

std::optional<UnitToken> unitAtEnd(TextReader& reader, std::vector<Box> blobs, int quarterTurns,
                                   double angle_deg) {
  std::vector<Box> letters = joinedAlong(std::move(blobs));
  if (letters.empty()) return {};
  double height = 0;
  for (const Box& b : letters) height = std::max(height, b.height());
  if (auto unit = unitTokenIn(reader, letters, height, quarterTurns, angle_deg)) return unit;
  // An arrow may follow the title.
  const Box& last = letters.back();
  if (letters.size() < 2 || last.width() < 1.1 * last.height() || last.height() > 0.7 * height) return {};
  letters.pop_back();
  return unitTokenIn(reader, letters, height, quarterTurns, angle_deg);
}

}  // namespace detent::importer
