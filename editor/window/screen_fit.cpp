// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/screen_fit.h"

#include <algorithm>
#include <QCoreApplication>
#include <QEvent>
#include <QMainWindow>
#include <QScreen>
#include <QTabBar>

namespace detent::editor {
namespace {

void fit(QWidget& window) {
  const QSize most = window.screen()->availableSize() - roomForFrame_px;
  if (window.size() != window.size().boundedTo(most)) window.resize(window.size().boundedTo(most));
  // Other windows are placed by the window manager.
  const bool placed =
      window.testAttribute(Qt::WA_Moved) && (window.windowFlags() & Qt::WindowType_Mask) == Qt::Dialog;
  if (!placed) return;
  const QRect screen = window.screen()->availableGeometry();
  const QPoint last =
      screen.bottomRight() + QPoint(1, 1) -
      QPoint(window.width() + roomForFrame_px.width(), window.height() + roomForFrame_px.height());
  const auto inside = [](int at, int least, int most_px) { return std::max(least, std::min(at, most_px)); };
  const QPoint at(inside(window.x(), screen.left(), last.x()), inside(window.y(), screen.top(), last.y()));
  if (at != window.pos()) window.move(at);
}

bool hasFrame(const QWidget& widget) {
  const Qt::WindowFlags type = widget.windowFlags() & Qt::WindowType_Mask;
  return widget.isWindow() && (type == Qt::Window || type == Qt::Dialog);
}

}  // namespace

ScreenFit::ScreenFit(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool ScreenFit::eventFilter(QObject* watched, QEvent* event) {
  if (!watched->isWidgetType()) return false;
  auto& widget = static_cast<QWidget&>(*watched);
  if (event->type() == QEvent::Show && !event->spontaneous() && hasFrame(widget)) fit(widget);
  if (auto* tabs = qobject_cast<QTabBar*>(&widget);
      event->type() == QEvent::Polish && tabs && qobject_cast<QMainWindow*>(tabs->parentWidget())) {
    tabs->setElideMode(Qt::ElideNone);
    tabs->setUsesScrollButtons(true);
  }
  return false;
}

}  // namespace detent::editor
