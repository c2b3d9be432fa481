// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/wheel_guard.h"

#include <memory>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QTabBar>

namespace detent::editor {
namespace {

bool changesByWheel(const QWidget& widget) {
  return qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QAbstractSpinBox*>(&widget) ||
         qobject_cast<const QTabBar*>(&widget) ||
         (qobject_cast<const QAbstractSlider*>(&widget) && !qobject_cast<const QScrollBar*>(&widget));
}

/// The control that contains a widget: a click on a field reaches its line edit, a click on a slider the
/// slider itself.
QWidget* controlAround(QWidget* widget) {
  for (; widget; widget = widget->parentWidget()) {
    if (changesByWheel(*widget)) return widget;
    if (widget->isWindow()) break;
  }
  return nullptr;
}

/// For a widget inside a table's header, which has nothing to scroll, the table's viewport; null for all
/// others.
QWidget* tableBelowHead(QObject* watched) {
  const auto* head = watched->isWidgetType() ? qobject_cast<const QHeaderView*>(watched->parent()) : nullptr;
  auto* table = head ? qobject_cast<QAbstractItemView*>(head->parentWidget()) : nullptr;
  return table ? table->viewport() : nullptr;
}

bool hasKeyboard(const QWidget& control) {
  if (!(control.focusPolicy() & Qt::ClickFocus)) return true;  // a click does not move the focus to it
  const QWidget* focus = QApplication::focusWidget();
  return focus && (focus == &control || control.isAncestorOf(focus));
}

}  // namespace

WheelGuard::WheelGuard(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Polish:  // otherwise Qt gives the focus to the widget under the wheel
      if (auto* widget = qobject_cast<QWidget*>(watched); widget && widget->focusPolicy() == Qt::WheelFocus)
        widget->setFocusPolicy(Qt::StrongFocus);
      return false;
    case QEvent::MouseButtonPress:
      if (auto* widget = qobject_cast<QWidget*>(watched)) clicked_ = controlAround(widget);
      return false;
    case QEvent::Wheel: {
      if (QWidget* table = tableBelowHead(watched)) {
        const std::unique_ptr<QEvent> turned(event->clone());
        QCoreApplication::sendEvent(table, turned.get());
        event->setAccepted(turned->isAccepted());
        return true;
      }
      const auto* widget = qobject_cast<QWidget*>(watched);
      if (!widget || !changesByWheel(*widget) || (widget == clicked_ && hasKeyboard(*widget))) return false;
      event->ignore();  // Qt passes the event on to the parent
      return true;
    }
    default:
      return false;
  }
}

}  // namespace detent::editor
