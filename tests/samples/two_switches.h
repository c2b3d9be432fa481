// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A page whose plot shows more than one switch.

#include <initializer_list>
#include <string>
#include <utility>

namespace detent::tests {

/// A plot of two switches, 0..4 mm and 0..1.2 N: "Brown" with press and release, "Red" with a press alone.
inline std::string twoSwitchesSvg() {
  const auto line = [](const char* colour, std::initializer_list<std::pair<double, double>> mm_N) {
    std::string points;
    for (const auto& [mm, newton] : mm_N)
      points += std::to_string(100 + 120 * mm) + "," + std::to_string(400 - 300 * newton) + " ";
    return std::string("<polyline fill='none' stroke-width='2' stroke='") + colour + "' points='" + points +
           "'/>";
  };
  const auto text = [](double x, double y, const std::string& words, const char* anchor = "middle") {
    return "<text font-family='sans-serif' font-size='14' x='" + std::to_string(x) + "' y='" +
           std::to_string(y) + "' text-anchor='" + anchor + "'>" + words + "</text>";
  };
  std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' width='800' height='470'>"
      "<rect x='100' y='40' width='480' height='360' fill='none' stroke='black'/>";
  for (int i = 0; i <= 4; ++i) svg += text(100 + 120 * i, 420, std::to_string(i));
  for (int i = 0; i <= 6; ++i)
    svg += text(80, 405 - 60 * i, std::to_string(i / 5) + "." + std::to_string(i * 2 % 10), "end");
  svg += text(340, 450, "Travel (mm)") + text(60, 25, "Force (N)");
  svg += line("#c8102e", {{0, 0}, {1.5, 0.8}, {2.5, 0.5}, {3.6, 0.9}, {3.8, 1.1}});
  svg += line("#0b5cad", {{0, 0}, {1.4, 0.65}, {2.4, 0.35}, {3.6, 0.75}, {3.8, 1.1}});
  svg += line("#2e8b37", {{0, 0}, {1.2, 0.6}, {2.0, 0.4}, {3.3, 0.55}, {3.5, 1.0}});
  int row = 0;
  for (const auto& [colour, words] :
       {std::pair{"#c8102e", "Brown press"}, {"#0b5cad", "Brown release"}, {"#2e8b37", "Red"}}) {
    const double y = 60 + 20 * row++;
    svg += "<line x1='620' x2='650' y1='" + std::to_string(y) + "' y2='" + std::to_string(y) +
           "' stroke-width='2' stroke='" + colour + "'/>" + text(658, y + 5, words, "start");
  }
  return svg + "</svg>";
}

}  // namespace detent::tests
