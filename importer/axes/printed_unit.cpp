// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/printed_unit.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace detent::importer {
namespace {

template <class Unit>
struct Spelling {
  std::string_view text;  // blanks removed; case matters where it tells units apart
  Unit unit;
  double sure;  // 1: nothing else; less: what a recogniser makes of it
};

constexpr std::array forceSpellings{Spelling<ForceUnit>{"cN", ForceUnit::centinewton, 1},
                                    Spelling<ForceUnit>{"CN", ForceUnit::centinewton, 0.9},
                                    Spelling<ForceUnit>{"cn", ForceUnit::centinewton, 0.9},
                                    Spelling<ForceUnit>{"eN", ForceUnit::centinewton, 0.8},
                                    Spelling<ForceUnit>{"\xC2\xA2N", ForceUnit::centinewton, 0.8},
                                    Spelling<ForceUnit>{"oN", ForceUnit::centinewton, 0.6},
                                    Spelling<ForceUnit>{"(N", ForceUnit::centinewton, 0.5},
                                    Spelling<ForceUnit>{"cM", ForceUnit::centinewton, 0.5},
                                    Spelling<ForceUnit>{"mN", ForceUnit::millinewton, 1},
                                    Spelling<ForceUnit>{"N", ForceUnit::newton, 1},
                                    Spelling<ForceUnit>{"Newton", ForceUnit::newton, 1},
                                    Spelling<ForceUnit>{"newton", ForceUnit::newton, 1},
                                    Spelling<ForceUnit>{"gf", ForceUnit::gramForce, 1},
                                    Spelling<ForceUnit>{"gF", ForceUnit::gramForce, 0.9},
                                    Spelling<ForceUnit>{"Gf", ForceUnit::gramForce, 0.9},
                                    Spelling<ForceUnit>{"GF", ForceUnit::gramForce, 0.9},
                                    Spelling<ForceUnit>{"of", ForceUnit::gramForce, 0.6},
                                    Spelling<ForceUnit>{"gt", ForceUnit::gramForce, 0.6},
                                    Spelling<ForceUnit>{"9f", ForceUnit::gramForce, 0.7},
                                    Spelling<ForceUnit>{"af", ForceUnit::gramForce, 0.6},
                                    Spelling<ForceUnit>{"ef", ForceUnit::gramForce, 0.6},
                                    Spelling<ForceUnit>{"sf", ForceUnit::gramForce, 0.6},
                                    Spelling<ForceUnit>{"gr", ForceUnit::gramForce, 0.7},
                                    Spelling<ForceUnit>{"g", ForceUnit::gramForce, 0.95},
                                    Spelling<ForceUnit>{"gram", ForceUnit::gramForce, 1},
                                    Spelling<ForceUnit>{"grams", ForceUnit::gramForce, 1},
                                    Spelling<ForceUnit>{"gram-force", ForceUnit::gramForce, 1},
                                    Spelling<ForceUnit>{"kgf", ForceUnit::kilogramForce, 1},
                                    Spelling<ForceUnit>{"kg", ForceUnit::kilogramForce, 0.9},
                                    Spelling<ForceUnit>{"ozf", ForceUnit::ounceForce, 1},
                                    Spelling<ForceUnit>{"oz", ForceUnit::ounceForce, 1},
                                    Spelling<ForceUnit>{"oz.", ForceUnit::ounceForce, 1},
                                    Spelling<ForceUnit>{"0zf", ForceUnit::ounceForce, 0.8},
                                    Spelling<ForceUnit>{"02f", ForceUnit::ounceForce, 0.6},
                                    Spelling<ForceUnit>{"lbf", ForceUnit::poundForce, 1},
                                    Spelling<ForceUnit>{"lb", ForceUnit::poundForce, 0.9}};

constexpr std::array lengthSpellings{Spelling<LengthUnit>{"mm", LengthUnit::millimetre, 1},
                                     Spelling<LengthUnit>{"MM", LengthUnit::millimetre, 0.9},
                                     Spelling<LengthUnit>{"rnm", LengthUnit::millimetre, 0.8},
                                     Spelling<LengthUnit>{"mrn", LengthUnit::millimetre, 0.8},
                                     Spelling<LengthUnit>{"mmn", LengthUnit::millimetre, 0.8},
                                     Spelling<LengthUnit>{"nm", LengthUnit::millimetre, 0.6},
                                     Spelling<LengthUnit>{"mn", LengthUnit::millimetre, 0.5},
                                     Spelling<LengthUnit>{"am", LengthUnit::millimetre, 0.5},
                                     Spelling<LengthUnit>{"mim", LengthUnit::millimetre, 0.7},
                                     Spelling<LengthUnit>{"imm", LengthUnit::millimetre, 0.7},
                                     Spelling<LengthUnit>{"cm", LengthUnit::centimetre, 1},
                                     Spelling<LengthUnit>{"inch", LengthUnit::inch, 1},
                                     Spelling<LengthUnit>{"inches", LengthUnit::inch, 1},
                                     Spelling<LengthUnit>{"in", LengthUnit::inch, 0.9},
                                     Spelling<LengthUnit>{"in.", LengthUnit::inch, 0.9},
                                     Spelling<LengthUnit>{"mil", LengthUnit::mil, 0.9},
                                     Spelling<LengthUnit>{"\xC2\xB5m", LengthUnit::micrometre, 1},
                                     Spelling<LengthUnit>{"\xCE\xBCm", LengthUnit::micrometre, 1},
                                     Spelling<LengthUnit>{"um", LengthUnit::micrometre, 0.8},
                                     Spelling<LengthUnit>{"millimeter", LengthUnit::millimetre, 1},
                                     Spelling<LengthUnit>{"millimetre", LengthUnit::millimetre, 1}};

/// Full-width brackets and blanks to plain ones.
std::string plainTitle(std::string_view s) {
  std::string out(s);
  const auto replaceAll = [&](std::string_view from, std::string_view to) {
    std::string next;
    std::size_t done = 0;
    for (auto at = out.find(from); at != std::string::npos; at = out.find(from, done)) {
      next.append(out, done, at - done).append(to);
      done = at + from.size();
    }
    next.append(out, done);
    out = std::move(next);
  };
  replaceAll("\xEF\xBC\x88", "(");
  replaceAll("\xEF\xBC\x89", ")");
  replaceAll("\xE3\x80\x90", "[");
  replaceAll("\xE3\x80\x91", "]");
  replaceAll("\xEF\xBC\x8F", "/");
  replaceAll("\xEF\xBC\x8E", ".");
  replaceAll("\xC2\xA0", " ");
  return out;
}

struct Piece {
  std::string text;
  double sure;  // of being a unit by where it stands
};

std::string trimmed(std::string_view s) {
  const auto first = s.find_first_not_of(" \t[](){}|:;\"'"), last = s.find_last_not_of(" \t[](){}|:;\"'");
  return first == std::string_view::npos ? std::string() : std::string(s.substr(first, last - first + 1));
}

std::string withoutBlanks(std::string s) {
  std::erase(s, ' ');
  return s;
}

/// Where units stand in titles, surest first: in brackets, after a slash, after "in", as the last word.
std::vector<Piece> pieces(std::string_view title) {
  const std::string t = plainTitle(title);
  std::vector<Piece> out;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] != '(' && t[i] != '[' && t[i] != '{') continue;
    auto close = t.find_first_of(")]}|", i + 1);
    // A recogniser loses closing brackets or reads them as letters.
    if (close == std::string::npos) close = t.size();
    if (close - i <= 14)
      out.push_back({withoutBlanks(trimmed(std::string_view(t).substr(i + 1, close - i - 1))), 1.0});
  }
  // "Iegf]": the opening bracket was read as a letter.
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t[i] == ']' || t[i] == ')') {
      auto open = t.find_last_of(" ([{", i - 1);
      open = open == std::string::npos ? 0 : open + 1;
      if (open < i) out.push_back({trimmed(std::string_view(t).substr(open, i - open)), 0.9});
      if (open + 1 < i) out.push_back({trimmed(std::string_view(t).substr(open + 1, i - open - 1)), 0.7});
    }
  if (const auto slash = t.rfind('/'); slash != std::string::npos)
    out.push_back({withoutBlanks(trimmed(std::string_view(t).substr(slash + 1))), 0.95});
  if (const auto in = t.rfind(" in "); in != std::string::npos)
    out.push_back({trimmed(std::string_view(t).substr(in + 4)), 0.95});
  if (const auto blank = t.find_last_of(" ,"); blank != std::string::npos) {
    out.push_back({trimmed(std::string_view(t).substr(blank + 1)), 0.7});
  } else {
    out.push_back({trimmed(t), 0.6});
  }
  return out;
}

template <class Unit, std::size_t N>
std::optional<PrintedUnit<Unit>> unitIn(std::string_view title,
                                        const std::array<Spelling<Unit>, N>& spellings) {
  std::optional<PrintedUnit<Unit>> best;
  for (const auto& piece : pieces(title))
    for (const auto& s : spellings) {
      // A misreading counts only where a unit must stand.
      if (piece.text != s.text || (s.sure < 0.85 && piece.sure < 0.9)) continue;
      const double sure = piece.sure * s.sure;
      if (!best || sure > best->sure) best = PrintedUnit<Unit>{s.unit, sure};
    }
  return best;
}

}  // namespace

std::optional<PrintedUnit<ForceUnit>> forceUnitIn(std::string_view title) {
  return unitIn(title, forceSpellings);
}
std::optional<PrintedUnit<LengthUnit>> lengthUnitIn(std::string_view title) {
  return unitIn(title, lengthSpellings);
}

}  // namespace detent::importer
