// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Labels, buttons and steps that several windows share.

#include <QAction>
#include <QLabel>
#include <QPushButton>

#include "editor/document/described.h"

namespace detent::editor {

/// A label that wraps its text, which can be selected and copied.
inline QLabel* wrappingLabel(const QString& name) {
  auto* label = described(new QLabel, name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

/// A button of a dialogue that the Enter key in another field does not press.
inline QPushButton* plainButton(const QString& name, const QString& text, const QString& tip) {
  auto* button = described(new QPushButton(text), name, tip);
  button->setAutoDefault(false);
  return button;
}

/// A button that triggers an action, with its text and tool tip; named `prefix` and the action's name.
inline QPushButton* buttonOf(QAction& action, const QString& prefix) {
  auto* button = described(new QPushButton(action.text()), prefix + action.objectName(), action.toolTip());
  QObject::connect(button, &QPushButton::clicked, &action, &QAction::trigger);
  return button;
}

/// Shows a window in front of the others, with the keyboard.
inline void bringUp(QWidget& window) {
  window.show();
  window.raise();
  window.activateWindow();
}

}  // namespace detent::editor
