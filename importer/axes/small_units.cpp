// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/small_units.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <opencv2/imgproc.hpp>

#include "importer/axes/drawn_text.h"

namespace detent::importer {
namespace {

struct Unit {
  const char* ascii;
  double rare = 0;  ///< likeness it has to be ahead by, as hardly anybody draws plots in it
};

constexpr std::array units{Unit{"mm"},       Unit{"cm"},  Unit{"in"}, Unit{"inch"}, Unit{"mil"}, Unit{"um"},
                           Unit{"nm"},       Unit{"N"},   Unit{"cN"}, Unit{"mN"},   Unit{"kN"},  Unit{"g"},
                           Unit{"dN", 0.03}, Unit{"gf"},  Unit{"kg"}, Unit{"kgf"},  Unit{"oz"},  Unit{"ozf"},
                           Unit{"lb"},       Unit{"lbf"}, Unit{"s"},  Unit{"ms"},   Unit{"min"}, Unit{"V"},
                           Unit{"mV"},       Unit{"A"},   Unit{"mA"}};

double likenessOf(const Unit& unit, const cv::Mat& patch, std::vector<DrawnText>& hands) {
  double best = -1;
  for (DrawnText& hand : hands)
    for (const auto& [open, shut] : {std::pair('(', ')'), std::pair('[', ']')})
      best = std::max(best, hand.likeness(patch, open + std::string(unit.ascii) + shut));
  return best - unit.rare;
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
  std::vector<DrawnText> hands;
  for (const int font : {cv::FONT_HERSHEY_SIMPLEX, cv::FONT_HERSHEY_COMPLEX})
    for (const double digit : {0.68, 0.75, 0.83, 0.9})  // brackets reach above and below
      for (const double advance : {0.76, 0.88})
        hands.emplace_back(Hand{font, digit * height, advance * digit * height});
  std::array<double, units.size()> like{};
  std::transform(units.begin(), units.end(), like.begin(),
                 [&](const Unit& unit) { return likenessOf(unit, patch, hands); });
  const auto best = std::max_element(like.begin(), like.end());
  const bool alone =
      std::count_if(like.begin(), like.end(), [&](double l) { return l > *best - ahead; }) == 1;
  if (*best < leastLike || !alone) return {};
  return units[static_cast<std::size_t>(best - like.begin())].ascii;
}

std::string withUnit(const std::string& utf8, const std::string& unit) {
  const std::string before = utf8.substr(0, utf8.find_first_of("([{"));
  const std::string words = before.size() < utf8.size() ? before : utf8.substr(0, utf8.find(' '));
  return words + (words.empty() || words.back() == ' ' ? "(" : " (") + unit + ")";
}

}  // namespace detent::importer
