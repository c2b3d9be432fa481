// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/graph_title.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace detent::importer {
namespace {

constexpr std::size_t longest_bytes = 48,
                      fewestLetters = 3;  // longer ones are sentences, shorter ones units and numbers
constexpr double reach = 0.25;            // largest distance above the frame, as a share of its height
constexpr double level_deg = 1;

bool mayBeTitle(const TextBox& text) {
  const auto letters = std::count_if(text.utf8.begin(), text.utf8.end(),
                                     [](unsigned char c) { return c >= 0x80 || std::isalpha(c); });
  return std::abs(text.angle_deg) < level_deg && text.utf8.size() <= longest_bytes &&
         static_cast<std::size_t>(letters) >= fewestLetters;
}

}  // namespace

std::string titleAbove(const LocatedGraph& graph) {
  const auto& corners = graph.frame.value.corners;
  const double top = std::min(corners[0].y, corners[1].y), left = corners[0].x, right = corners[1].x;
  const double lowest = top, highest = top - reach * (corners[3].y - corners[0].y);
  const TextBox* nearest = nullptr;
  for (const TextBox& text : graph.view.texts) {
    const Point middle = text.box.middle();
    const bool above = text.box.y1 <= lowest && text.box.y0 >= highest && middle.x > left && middle.x < right;
    if (above && mayBeTitle(text) && (!nearest || text.box.y1 > nearest->box.y1)) nearest = &text;
  }
  return nearest ? nearest->utf8 : std::string();
}

}  // namespace detent::importer
