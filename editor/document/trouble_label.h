// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A label for what is wrong.

#include <QEvent>
#include <QGuiApplication>
#include <QLabel>

#include "editor/document/described.h"
#include "editor/document/graph_colors.h"

namespace detent::editor {

/// A sentence on what is wrong, in the colour of refusals; hidden while there is none. GUI thread.
class TroubleLabel : public QLabel {
 public:
  explicit TroubleLabel(const QString& name) {
    described(this, name);
    setWordWrap(true);
    setMargin(6);
    say({});
    followTheme();
  }
  void say(const QString& why) {
    setText(why);
    setAccessibleName(why);
    setVisible(!why.isEmpty());
  }

 protected:
  void changeEvent(QEvent* event) override {
    QLabel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) followTheme();
  }

 private:
  void followTheme() {
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, graphColors(isDark(QGuiApplication::palette())).refused);
    setPalette(colors);
  }
};

}  // namespace detent::editor
