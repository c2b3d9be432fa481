// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/small_units.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "importer/axes/drawn_text.h"

namespace detent::importer {
namespace {

struct Unit {
  const char* ascii;
  double rare = 0;  ///< additional likeness that a unit needs if plots rarely use it
};

constexpr std::array units{Unit{"mm"},       Unit{"cm"},  Unit{"in"}, Unit{"inch"}, Unit{"mil"}, Unit{"um"},
                           Unit{"nm"},       Unit{"N"},   Unit{"cN"}, Unit{"mN"},   Unit{"kN"},  Unit{"g"},
                           Unit{"dN", 0.03}, Unit{"gf"},  Unit{"kg"}, Unit{"kgf"},  Unit{"oz"},  Unit{"ozf"},
                           Unit{"lb"},       Unit{"lbf"}, Unit{"s"},  Unit{"ms"},   Unit{"min"}, Unit{"V"},
                           Unit{"mV"},       Unit{"A"},   Unit{"mA"}};

/// Likeness of the unit in either kind of brackets, in the style that fits best.
double unitLikeness(const Unit& unit, const cv::Mat& patch, double height, std::vector<DrawnText>& hands) {
  // largest gap between the bracket and the end of the line, in heights of the line; there may be dust or a
  // full stop
  constexpr double blank = 0.75;
  double best = -1;
  for (DrawnText& hand : hands)
    for (const auto& [open, shut] : {std::pair('(', ')'), std::pair('[', ']')})
      best = std::max(best, hand.likenessAtEnd(patch, open + std::string(unit.ascii) + shut, blank * height));
  return best - unit.rare;
}

/// Styles in which a unit may be drawn: every combination of these fonts, digit heights (as shares of the
/// line's height; brackets are higher than digits) and advances (as shares of the digit's height).
std::vector<DrawnText> unitFonts(double height, std::initializer_list<int> fonts,
                                 std::initializer_list<double> digits,
                                 std::initializer_list<double> advances) {
  std::vector<DrawnText> hands;
  for (const int font : fonts)
    for (const double digit : digits)
      for (const double advance : advances)
        hands.emplace_back(Hand{font, digit * height, advance * digit * height});
  return hands;
}

struct JudgedUnit {
  const Unit* unit = nullptr;
  double likeness = -1;
};

/// The units that remain possible after a comparison in two common styles; empty if nothing resembles a unit
/// in brackets.
std::vector<JudgedUnit> likelyUnits(const cv::Mat& patch, double height) {
  // correlations: least for a unit at all, and most below the best
  constexpr double leastLike = 0.4, behind = 0.2;
  std::vector<DrawnText> common = unitFonts(height, {cv::FONT_HERSHEY_SIMPLEX}, {0.71, 0.83}, {0.82});
  std::vector<JudgedUnit> likely;
  double best = leastLike;
  for (const Unit& unit : units) {
    likely.push_back({&unit, unitLikeness(unit, patch, height, common)});
    best = std::max(best, likely.back().likeness);
  }
  std::erase_if(likely, [&](const JudgedUnit& j) { return j.likeness < best - behind; });
  return likely;
}

}  // namespace

std::optional<std::string> bracketedUnit(const cv::Mat& darkness, const Box& line, int quarterTurns) {
  constexpr double leastLike = 0.75, ahead = 0.025, longest = 5.5;  // the last in heights of a line
  const bool lying = quarterTurns % 2 != 0;
  const double height = lying ? line.width() : line.height(), width = lying ? line.height() : line.width();
  Box end = line;
  if (lying)
    end.y1 = line.y0 + std::min(width, longest * height);
  else
    end.x0 = line.x1 - std::min(width, longest * height);
  const cv::Mat patch = finePatch(darkness, end, quarterTurns);
  if (patch.empty()) return {};
  std::vector<JudgedUnit> likely = likelyUnits(patch, height);
  if (likely.empty()) return {};
  std::vector<DrawnText> hands = unitFonts(height, {cv::FONT_HERSHEY_SIMPLEX, cv::FONT_HERSHEY_COMPLEX},
                                           {0.68, 0.75, 0.83, 0.9}, {0.76, 0.88});
  for (JudgedUnit& each : likely) each.likeness = unitLikeness(*each.unit, patch, height, hands);
  const auto best = std::ranges::max_element(likely, {}, &JudgedUnit::likeness);
  const auto rivals =
      std::ranges::count_if(likely, [&](const JudgedUnit& j) { return j.likeness > best->likeness - ahead; });
  if (best->likeness < leastLike || rivals > 1) return {};
  return best->unit->ascii;
}

std::string withUnit(const std::string& utf8, const std::string& unit) {
  const std::string before = utf8.substr(0, utf8.find_first_of("([{"));
  const std::string words = before.size() < utf8.size() ? before : utf8.substr(0, utf8.find(' '));
  return words + (words.empty() || words.back() == ' ' ? "(" : " (") + unit + ")";
}

}  // namespace detent::importer
