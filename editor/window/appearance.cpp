// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/appearance.h"

#include "editor/document/graph_colors.h"

namespace detent::editor {
namespace {

struct Grounds {
  QColor window, base, alternate, button, text, disabled, highlight, highlightedText, link, tip, border;
};

QPalette paletteOf(const Grounds& grounds) {
  QPalette palette(grounds.button, grounds.window);
  palette.setColor(QPalette::WindowText, grounds.text);
  palette.setColor(QPalette::Base, grounds.base);
  palette.setColor(QPalette::AlternateBase, grounds.alternate);
  palette.setColor(QPalette::Text, grounds.text);
  palette.setColor(QPalette::ButtonText, grounds.text);
  palette.setColor(QPalette::BrightText, grounds.text);
  palette.setColor(QPalette::Highlight, grounds.highlight);
  palette.setColor(QPalette::HighlightedText, grounds.highlightedText);
  palette.setColor(QPalette::Link, grounds.link);
  palette.setColor(QPalette::LinkVisited, grounds.link);
  palette.setColor(QPalette::ToolTipBase, grounds.tip);
  palette.setColor(QPalette::ToolTipText, grounds.text);
  palette.setColor(QPalette::PlaceholderText, grounds.disabled);
  palette.setColor(QPalette::Mid, grounds.border);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, grounds.disabled);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, grounds.border);
  return palette;
}

}  // namespace

QPalette lightPalette() {
  return paletteOf({"#f3f4f6", "#ffffff", "#f6f7f9", "#eceef1", "#1d2126", "#5f666f", "#0067a8", "#ffffff",
                    "#005a94", "#ffffff", "#c3c8ce"});
}

QPalette darkPalette() {
  return paletteOf({"#24282d", "#1b1e22", "#212529", "#2f343a", "#dfe3e8", "#8d949d", "#2a74a9", "#ffffff",
                    "#7cc4f0", "#2f343a", "#454b53"});
}

QPalette paletteFor(Appearance appearance, const QPalette& system) {
  switch (appearance) {
    case Appearance::light:
      return lightPalette();
    case Appearance::dark:
      return darkPalette();
    case Appearance::system:
      break;
  }
  return isDark(system) ? darkPalette() : lightPalette();
}

}  // namespace detent::editor
