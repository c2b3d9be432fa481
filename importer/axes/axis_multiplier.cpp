// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/axis_multiplier.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "importer/lexicon/letters.h"

namespace detent::importer {
namespace {

/// The text without blanks, with superscripts as digits, every dash as a hyphen and every multiplication sign
/// as "x".
std::string plainPower(std::string_view text) {
  constexpr std::u32string_view superscripts = U"⁰¹²³⁴⁵⁶⁷⁸⁹", dashes = U"-−–—⁻", times = U"x×·*∙⋅X";
  std::string plain;
  for (const char32_t c : codePoints(text)) {
    if (const auto digit = superscripts.find(c); digit != std::u32string_view::npos)
      plain += static_cast<char>('0' + digit);
    else if (dashes.find(c) != std::u32string_view::npos)
      plain += '-';
    else if (times.find(c) != std::u32string_view::npos)
      plain += 'x';
    else if (c != U' ' && c != U'^' && c != U'+')
      plain += c < 0x80 ? static_cast<char>(c) : '?';
  }
  return plain;
}

/// Region where a multiplier of this axis may stand.
Box placeOfMultiplier(const Box& frame, Axis axis, const Box& labels) {
  constexpr double beside = 0.15, inwards = 0.25, above = 0.12;  // shares of the frame's width and height
  const double width = frame.width(), height = frame.height();
  if (axis == Axis::y)
    return {std::min(labels.x0, frame.x0 - beside * width), frame.y0 - above * height,
            frame.x0 + inwards * width, frame.y0 - 1};
  return {frame.x1 - inwards * width, labels.y1 - 1, frame.x1 + beside * width, labels.y1 + above * height};
}

}  // namespace

std::optional<double> multiplierIn(std::string_view text) {
  std::string plain = plainPower(text);
  const bool isTimes = plain.starts_with('x');
  if (isTimes) plain.erase(0, 1);
  const bool isOne =
      !plain.empty() && std::string_view("1lIi|t").find(plain.front()) != std::string_view::npos;
  if (!isOne || plain.size() < 3) return {};
  const bool isPower = plain[1] == '0' || plain[1] == 'O' || plain[1] == 'o';
  if (!isPower && plain[1] != 'e' && plain[1] != 'E') return {};
  std::string_view exponent = std::string_view(plain).substr(2);
  const bool isNegative = exponent.starts_with('-');
  if (isNegative) exponent.remove_prefix(1);
  if (exponent.size() != 1 || exponent.front() < '0' || exponent.front() > '9') return {};
  // "103" without "x" and without a negative exponent is a plain number
  if (isPower && !isTimes && !isNegative) return {};
  const int power = exponent.front() - '0';
  return std::pow(10.0, isNegative ? -power : power);
}

double multiplierAtEnd(GraphReading& r, Axis axis, const Box& labels) {
  constexpr std::size_t fewLines = 2;
  const Box place = placeOfMultiplier(r.box, axis, labels);
  std::vector<SeenText> lines = r.ownTexts(place);
  if (r.view.texts.empty())
    lines = r.readLines(place, 0, axis == Axis::y ? Point{r.box.x0, r.box.y0} : Point{r.box.x1, labels.y1},
                        fewLines);
  for (const SeenText& line : lines)
    if (const auto multiplier = multiplierIn(line.utf8)) return *multiplier;
  return 1;
}

}  // namespace detent::importer
