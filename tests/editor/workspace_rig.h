// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A workspace on a button, with mouse and keys to operate it.

#include <QApplication>
#include <QMouseEvent>
#include <QtTest>

#include "editor/canvas/graph_canvas.h"
#include "editor/document/button_document.h"
#include "editor/panels/graph_workspace.h"
#include "editor/tools/tool_box.h"
#include "model/templates.h"

namespace detent::editor::tests {

inline Button require(const Result<Button>& button) {
  if (!button) qFatal("%s", button.failure().sentence().c_str());
  return *button;
}

/// Shown offscreen, so that events, focus and layout are those of a user.
struct WorkspaceRig {
  explicit WorkspaceRig(const Button& button, QSize size = {900, 600})
      : document(button), workspace(document, settings) {
    workspace.resize(size);
    workspace.show();
    QCoreApplication::processEvents();
    workspace.activateWindow();
    canvas().setFocus();
    QCoreApplication::processEvents();
  }

  GraphCanvas& canvas() { return workspace.canvas(); }
  const Button& button() const { return document.button(); }
  int steps() const { return document.history().stack().count(); }
  const StrokeCurve& press() const { return document.graph().press(); }

  QPointF pixel(double displacement_mm, double force_N) {
    return canvas().mapping().toPixel(displacement_mm, force_N);
  }
  QPointF pixel(const MarkId& mark) {
    const auto at = placeOf(mark, canvas().state(), canvas().values());
    if (!at) qFatal("no such mark");
    return pixel(at->displacement_mm, at->force_N);
  }

  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
    send(canvas(), type, at, button, modifiers);
  }
  void send(QWidget& widget, QEvent::Type type, QPointF at, Qt::MouseButton button,
            Qt::KeyboardModifiers modifiers = {}) {
    if (type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick) down |= button;
    if (type == QEvent::MouseButtonRelease) down &= ~Qt::MouseButtons(button);
    QMouseEvent event(type, at, widget.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button,
                      down, modifiers);
    QCoreApplication::sendEvent(&widget, &event);
  }
  void press(QPointF at, Qt::KeyboardModifiers modifiers = {}) {
    mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, modifiers);
  }
  void move(QPointF at, Qt::KeyboardModifiers modifiers = {}) {
    mouse(QEvent::MouseMove, at, Qt::LeftButton, modifiers);
  }
  void release(QPointF at) { mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton); }
  void click(QPointF at) {
    press(at);
    release(at);
  }
  /// In three moves, as a hand does.
  void drag(QPointF from, QPointF to, Qt::KeyboardModifiers modifiers = {}) {
    press(from);
    for (const double share : {0.3, 0.7, 1.0}) move(from + share * (to - from), modifiers);
    release(to);
  }
  void key(int code, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&canvas(), static_cast<Qt::Key>(code), modifiers);
  }
  QAction* action(const QString& name) {
    for (const auto& actions : {workspace.toolActions(), workspace.editActions(), workspace.viewActions()})
      for (QAction* candidate : actions)
        if (candidate->objectName() == name) return candidate;
    qFatal("no action %s", qPrintable(name));
  }

  ViewSettings settings;
  ButtonDocument document;
  GraphWorkspace workspace;
  Qt::MouseButtons down = Qt::NoButton;
};

}  // namespace detent::editor::tests
