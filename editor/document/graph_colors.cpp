// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/graph_colors.h"

#include <array>

#include "editor/document/series_colors.h"

namespace detent::editor {
namespace {

QColor withAlpha(const char* name, int alpha) {
  QColor color(name);
  color.setAlpha(alpha);
  return color;
}

}  // namespace

GraphColors graphColors(bool dark) {
  if (dark)
    return {"#1b1e22",
            "#353a41",
            "#8d949d",
            "#dfe3e8",  // backgrounds
            "#56b4e9",
            "#e69f00",  // strokes
            "#f0e442",
            "#2ac99a",
            "#e58bb9",
            "#b0b6be",  // points, end of travel
            withAlpha("#56b4e9", 10),
            withAlpha("#f0a35e", 18),
            withAlpha("#b0b6be", 16),
            "#a7b0ba",
            "#ff8a5c",
            "#ffffff",
            "#ff6b4a"};
  return {"#ffffff",
          "#e3e6ea",
          "#5b626b",
          "#1d2126",
          "#0072b2",
          "#c46f00",
          "#8a6d00",
          "#00805c",
          "#b0527f",
          "#6b727b",
          withAlpha("#0072b2", 7),
          withAlpha("#e69f00", 16),
          withAlpha("#6b727b", 13),
          "#7b838d",
          "#d55e00",
          "#000000",
          "#c8102e"};
}

QColor seriesColor(std::size_t index, bool dark) {
  // The first is the press, and none is the release. Any two differ by more than 20 in CIELAB, also as seen
  // without one kind of cones.
  constexpr std::array<const char*, seriesColors> onLight{"#0072b2", "#c5426e", "#325910",
                                                          "#8a136f", "#241a20", "#a78654"},
      onDark{"#56b4e9", "#e2d071", "#c5308e", "#1b8013", "#f5fdfb", "#965e58"};
  return (dark ? onDark : onLight)[index % seriesColors];
}

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

}  // namespace detent::editor
