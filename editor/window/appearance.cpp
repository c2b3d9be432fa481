// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/appearance.h"

#include <cmath>
#include <QProxyStyle>
#include <QStyleOption>

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

QColor between(const QColor& from, const QColor& to, float share) {
  return QColor::fromRgbF(std::lerp(from.redF(), to.redF(), share),
                          std::lerp(from.greenF(), to.greenF(), share),
                          std::lerp(from.blueF(), to.blueF(), share));
}

class OutlinedStyle : public QProxyStyle {
 public:
  OutlinedStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    const auto draw = [&](const QStyleOption& seen) {
      QProxyStyle::drawPrimitive(element, &seen, painter, widget);
    };
    switch (element) {
      case PE_FrameLineEdit:
        return drawOutlined<QStyleOptionFrame>(*option, draw);
      case PE_IndicatorCheckBox:
      case PE_IndicatorRadioButton:
      case PE_PanelButtonCommand:
        return drawOutlined<QStyleOptionButton>(*option, draw);
      default:
        return draw(*option);
    }
  }

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override {
    const auto draw = [&](const QStyleOption& seen) {
      QProxyStyle::drawComplexControl(control, static_cast<const QStyleOptionComplex*>(&seen), painter,
                                      widget);
    };
    switch (control) {
      case CC_SpinBox:
        return drawOutlined<QStyleOptionSpinBox>(*option, draw);
      case CC_ComboBox:
        return drawOutlined<QStyleOptionComboBox>(*option, draw);
      case CC_Slider:
        return drawOutlined<QStyleOptionSlider>(*option, draw);
      default:
        return draw(*option);
    }
  }

 private:
  template <class Option, class Draw>
  static void drawOutlined(const QStyleOption& option, const Draw& draw) {
    const auto* given = qstyleoption_cast<const Option*>(&option);
    if (!given) return draw(option);
    Option seen(*given);
    outline(seen);
    draw(seen);
  }

  /// Fusion's outline is the window's colour, darkened; that of a focused control the highlight's.
  static void outline(QStyleOption& option) {
    constexpr int darkened = 140;        // by Fusion, per cent
    constexpr float towardsText = 0.6F;  // boxes get it a tenth lighter
    QPalette& palette = option.palette;
    const auto group = static_cast<QPalette::ColorGroup>(option.state & State_Enabled ? QPalette::Active
                                                                                      : QPalette::Disabled);
    const QColor wanted = between(palette.color(group, QPalette::Window),
                                  palette.color(group, QPalette::WindowText), towardsText);
    palette.setColor(QPalette::Highlight, palette.color(QPalette::Link));
    palette.setColor(QPalette::Window, wanted.lighter(darkened));
  }
};

}  // namespace

QStyle* outlinedStyle() { return new OutlinedStyle; }

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
