// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/appearance.h"

#include <cmath>
#include <QAbstractItemView>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>

#include "editor/document/graph_colors.h"

namespace detent::editor {
namespace {

struct PaletteColors {
  QColor window, base, alternate, button, text, disabled, highlight, highlightedText, link, tip, border;
};

QPalette paletteOf(const PaletteColors& colors) {
  QPalette palette(colors.button, colors.window);
  palette.setColor(QPalette::WindowText, colors.text);
  palette.setColor(QPalette::Base, colors.base);
  palette.setColor(QPalette::AlternateBase, colors.alternate);
  palette.setColor(QPalette::Text, colors.text);
  palette.setColor(QPalette::ButtonText, colors.text);
  palette.setColor(QPalette::BrightText, colors.text);
  palette.setColor(QPalette::Highlight, colors.highlight);
  palette.setColor(QPalette::HighlightedText, colors.highlightedText);
  palette.setColor(QPalette::Link, colors.link);
  palette.setColor(QPalette::LinkVisited, colors.link);
  palette.setColor(QPalette::ToolTipBase, colors.tip);
  palette.setColor(QPalette::ToolTipText, colors.text);
  palette.setColor(QPalette::PlaceholderText, colors.disabled);
  palette.setColor(QPalette::Mid, colors.border);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, colors.disabled);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, colors.border);
  return palette;
}

QColor between(const QColor& from, const QColor& to, float share) {
  return QColor::fromRgbF(std::lerp(from.redF(), to.redF(), share),
                          std::lerp(from.greenF(), to.greenF(), share),
                          std::lerp(from.blueF(), to.blueF(), share));
}

/// Fusion with outlines that can be seen, flat surfaces and one spacing.
class OutlinedStyle : public QProxyStyle {
 public:
  OutlinedStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    switch (metric) {
      case PM_LayoutLeftMargin:
      case PM_LayoutTopMargin:
      case PM_LayoutRightMargin:
      case PM_LayoutBottomMargin:
      case PM_LayoutHorizontalSpacing:
      case PM_LayoutVerticalSpacing:
        return spacing_px;
      case PM_DockWidgetTitleMargin:
        return spacing_px / 2;
      default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
  }

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
        return drawOutlined<QStyleOptionButton>(*option, draw);
      case PE_PanelButtonCommand:
        return drawButton(*option, *painter);
      case PE_IndicatorTabClose:
        return drawCross(*option, *painter);
      case PE_Frame:
        // lists need no frame, because their background differs from the window's
        if (qobject_cast<const QAbstractItemView*>(widget)) return;
        return draw(*option);
      default:
        return draw(*option);
    }
  }

  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override {
    switch (element) {
      case CE_PushButtonLabel:
        if (isPrimary(*option)) {
          QStyleOptionButton label(*qstyleoption_cast<const QStyleOptionButton*>(option));
          label.palette.setColor(QPalette::ButtonText, label.palette.color(QPalette::HighlightedText));
          return QProxyStyle::drawControl(element, &label, painter, widget);
        }
        break;
      case CE_TabBarTabShape:
        return drawTab(*option, *painter);
      case CE_ToolBar:
        return painter->fillRect(option->rect, option->palette.window());
      case CE_HeaderSection:
        painter->fillRect(option->rect, option->palette.window());
        return painter->fillRect(lowestLine(option->rect), option->palette.mid());
      case CE_DockWidgetTitle:
        painter->save();
        makeBold(*painter);
        QProxyStyle::drawControl(element, option, painter, widget);
        return painter->restore();
      default:
        break;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
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
      case CC_ScrollBar:
        if (const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option))
          return drawScrollBar(*bar, *painter, widget);
        return draw(*option);
      default:
        return draw(*option);
    }
  }

 private:
  static constexpr int spacing_px = 8;
  static constexpr double radius_px = 4;

  static void makeBold(QPainter& painter) {
    QFont font = painter.font();
    font.setBold(true);
    painter.setFont(font);
  }

  static QRect lowestLine(const QRect& rect) { return {rect.left(), rect.bottom(), rect.width(), 1}; }

  /// The button that Enter presses, in the accent colour.
  static bool isPrimary(const QStyleOption& option) {
    const auto* button = qstyleoption_cast<const QStyleOptionButton*>(&option);
    return button && (button->features & QStyleOptionButton::DefaultButton) && (option.state & State_Enabled);
  }

  static void drawButton(const QStyleOption& option, QPainter& painter) {
    constexpr int hovered = 106, pressed = 112;  // per cent darker
    const bool primary = isPrimary(option);
    QColor fill = option.palette.color(primary ? QPalette::Highlight : QPalette::Button);
    if (option.state & (State_Sunken | State_On))
      fill = fill.darker(pressed);
    else if (option.state & State_MouseOver)
      fill = fill.darker(hovered);
    const bool focused = (option.state & State_HasFocus) && (option.state & State_KeyboardFocusChange);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(focused ? option.palette.color(QPalette::Link) : outlineOf(option), focused ? 2 : 1));
    painter.setBrush(fill);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), radius_px, radius_px);
    painter.restore();
  }

  /// A flat groove with a handle that is as visible as outlines; Fusion's has nearly the groove's colour.
  void drawScrollBar(const QStyleOptionSlider& bar, QPainter& painter, const QWidget* widget) const {
    const auto place = [&](SubControl part) { return subControlRect(CC_ScrollBar, &bar, part, widget); };
    const auto isAt = [&](SubControl part, StateFlag state) {
      return (bar.activeSubControls & part) && (bar.state & state);
    };
    const QColor background = bar.palette.color(QPalette::Window);
    painter.save();
    painter.fillRect(bar.rect, background);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    if (bar.maximum > bar.minimum) {
      const bool grasped =
          isAt(SC_ScrollBarSlider, State_Sunken) || isAt(SC_ScrollBarSlider, State_MouseOver);
      painter.setBrush(grasped ? bar.palette.color(QPalette::WindowText) : outlineOf(bar));
      painter.drawRoundedRect(QRectF(place(SC_ScrollBarSlider)).adjusted(2, 2, -2, -2), radius_px, radius_px);
    }
    const bool lies = bar.orientation == Qt::Horizontal;
    PrimitiveElement back = lies ? PE_IndicatorArrowLeft : PE_IndicatorArrowUp;
    PrimitiveElement forth = lies ? PE_IndicatorArrowRight : PE_IndicatorArrowDown;
    if (lies && bar.direction == Qt::RightToLeft) std::swap(back, forth);
    for (const auto& [part, arrow] : {std::pair{SC_ScrollBarSubLine, back}, {SC_ScrollBarAddLine, forth}}) {
      QStyleOption button(bar);
      button.rect = place(part);
      if (isAt(part, State_Sunken)) painter.fillRect(button.rect, bar.palette.mid());
      proxy()->drawPrimitive(arrow, &button, &painter, widget);
    }
    painter.restore();
  }

  /// The chosen tab has the background of its page and a line in the accent colour.
  static void drawTab(const QStyleOption& option, QPainter& painter) {
    constexpr int line_px = 2;
    const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(&option);
    const bool chosen = option.state & State_Selected;
    if (chosen || (option.state & State_MouseOver))
      painter.fillRect(option.rect, chosen ? option.palette.base() : option.palette.button());
    if (!chosen) return;
    QRect line = option.rect;
    if (tab && tab->shape == QTabBar::RoundedSouth)
      line.setBottom(line.top() + line_px - 1);
    else
      line.setTop(line.bottom() - line_px + 1);
    painter.fillRect(line, option.palette.link());
  }

  static void drawCross(const QStyleOption& option, QPainter& painter) {
    const QPointF middle = QRectF(option.rect).center();
    constexpr double half_px = 3.5;
    const bool pointedAt = option.state & State_MouseOver;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (pointedAt) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(option.palette.mid());
      painter.drawRoundedRect(option.rect, radius_px, radius_px);
    }
    painter.setPen(
        QPen(option.palette.color(pointedAt ? QPalette::WindowText : QPalette::PlaceholderText), 1.4));
    for (const double up : {-half_px, half_px})
      painter.drawLine(middle + QPointF(-half_px, -up), middle + QPointF(half_px, up));
    painter.restore();
  }

  template <class Option, class Draw>
  static void drawOutlined(const QStyleOption& option, const Draw& draw) {
    const auto* given = qstyleoption_cast<const Option*>(&option);
    if (!given) return draw(option);
    Option seen(*given);
    outline(seen);
    draw(seen);
  }

  /// Fusion derives a control's outline from the window's colour, darkened, and that of a focused control
  /// from the highlight's.
  static void outline(QStyleOption& option) {
    constexpr int darkened = 140;  // by Fusion, per cent
    const QColor wanted = outlineOf(option);
    option.palette.setColor(QPalette::Highlight, option.palette.color(QPalette::Link));
    option.palette.setColor(QPalette::Window, wanted.lighter(darkened));
  }

  static QColor outlineOf(const QStyleOption& option) {
    constexpr float towardsText = 0.6F;  // boxes get it a tenth lighter
    const auto group = static_cast<QPalette::ColorGroup>(option.state & State_Enabled ? QPalette::Active
                                                                                      : QPalette::Disabled);
    return between(option.palette.color(group, QPalette::Window),
                   option.palette.color(group, QPalette::WindowText), towardsText);
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
