// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ignores wheel events on combo boxes without focus.

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace detent::editor {

/// While it lives, the wheel changes a choice, a number field, a slider or the tab shown only where the last
/// click was and the keyboard still is; over all others it scrolls what they stand in. Scroll bars and plots
/// are not meant: they show, and change nothing. Over the head of a table it scrolls the table. One for the
/// whole application. GUI thread.
class WheelGuard : public QObject {
 public:
  explicit WheelGuard(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QPointer<QWidget> clicked_;  ///< the control of the last click; null where that was on none
};

}  // namespace detent::editor
