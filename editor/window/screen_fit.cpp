// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/screen_fit.h"

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
