// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/keyed_page.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QScrollBar>

namespace detent::editor {

namespace {

constexpr int margin_px = 36, keyedSpacing_px = 18, mostWidth_px = 1100;

template <class Widget>
Widget* large(Widget* widget, int points) {
  QFont font = widget->font();
  font.setPointSize(points);
  widget->setFont(font);
  return widget;
}

}  // namespace

KeyedPage::KeyedPage(QWidget* parent) : QWidget(parent) {
  auto* inner = new QWidget;
  inner->setMaximumWidth(mostWidth_px);  // keeps the page in the middle of a wide screen
  auto* outer = new QHBoxLayout(this);
  outer->setContentsMargins(margin_px, margin_px, margin_px, margin_px);
  outer->addWidget(inner);
  column_ = new QVBoxLayout(inner);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(keyedSpacing_px);
}

QLabel* KeyedPage::addText(const char* name, const QString& text, int points, Qt::Alignment alignment,
                           int stretch) {
  auto* label = large(new QLabel(text), points);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setAlignment(alignment);
  column_->addWidget(label, stretch);
  return label;
}

void KeyedPage::addLongText(const char* name, const QString& text, int points) {
  QLabel* label = addText(name, text, points, Qt::AlignLeft | Qt::AlignVCenter);
  column_->removeWidget(label);
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(label);
  column_->addWidget(area, 1);
  QScrollBar* bar = area->verticalScrollBar();
  const auto moves = [this, bar](int key, QAbstractSlider::SliderAction action) {
    keys_.push_back({key, [bar, action] { bar->triggerAction(action); }});
  };
  moves(Qt::Key_Down, QAbstractSlider::SliderSingleStepAdd);
  moves(Qt::Key_Up, QAbstractSlider::SliderSingleStepSub);
  moves(Qt::Key_PageDown, QAbstractSlider::SliderPageStepAdd);
  moves(Qt::Key_PageUp, QAbstractSlider::SliderPageStepSub);
}

QPushButton* KeyedPage::made(const PageButton& button) {
  const QString text =
      button.key.name.isEmpty() ? button.text : QStringLiteral("%1   [%2]").arg(button.text, button.key.name);
  auto* widget = large(new QPushButton(text), button.points);
  widget->setObjectName(button.name);
  widget->setMinimumSize(widget->sizeHint().width() + keyedSpacing_px, button.height_px);
  widget->setFocusPolicy(Qt::NoFocus);  // the page handles the keys itself
  return widget;
}

QPushButton* KeyedPage::makeButton(const PageButton& button, const std::function<void()>& act) {
  QPushButton* widget = made(button);
  connect(widget, &QPushButton::clicked, this, act);
  if (button.key.key != 0) keys_.push_back({button.key.key, act});
  return widget;
}

QPushButton* KeyedPage::addButton(const PageButton& button, const std::function<void()>& act) {
  QPushButton* widget = makeButton(button, act);
  column_->addWidget(widget);
  return widget;
}

QPushButton* KeyedPage::makePad(const PageButton& button, const std::function<void()>& act) {
  QPushButton* widget = made(button);
  connect(widget, &QPushButton::pressed, this, act);
  if (button.key.key != 0) keys_.push_back({button.key.key, act});
  return widget;
}

QPushButton* KeyedPage::makeFeelButton(const PageButton& button, const std::function<void()>& act) {
  QPushButton* widget = makePad(button, act);
  widget->setCheckable(true);
  widget->setStyleSheet(
      "QPushButton:checked { border: 5px solid palette(highlight); border-radius: 4px; background: "
      "palette(button); }");
  connect(widget, &QPushButton::clicked, widget, [widget] { widget->setChecked(true); });
  return widget;
}

bool KeyedPage::press(int key) const {
  if (!isEnabled()) return false;
  if (key == Qt::Key_Enter) key = Qt::Key_Return;
  if (key == Qt::Key_Comma) key = Qt::Key_Period;  // both decimal signs count as one key
  for (const Bound& bound : keys_) {
    if (bound.key != key) continue;
    bound.act();
    return true;
  }
  return false;
}

}  // namespace detent::editor
