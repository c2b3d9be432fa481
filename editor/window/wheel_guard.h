// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ignores wheel events on combo boxes without focus.

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace detent::editor {

/// While it exists, the wheel changes a combo box, a number field, a slider or a tab bar only if the last
/// click was on it and it still has the focus. Over any other control it scrolls the area that contains it.
/// Over a table's header it scrolls the table. Scroll bars and plots are not affected, because the wheel
/// changes no value there. One for the whole application. GUI thread.
class WheelGuard : public QObject {
 public:
  explicit WheelGuard(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QPointer<QWidget> clicked_;  ///< the control of the last click; null if that was on none
};

}  // namespace detent::editor
