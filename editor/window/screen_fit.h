// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Windows on small screens: none larger than its screen, and panels' tabs with their whole names.

#include <QObject>
#include <QWidget>

namespace detent::editor {

/// Around what is ours: the window manager's frame.
inline constexpr QSize roomForFrame_px{8, 40};

/// While it lives, a window that comes up larger than its screen is made as large as that; also those of Qt.
/// Names of panels in tabs are not cut: where there is no room the tabs scroll. One for the whole
/// application. GUI thread.
class ScreenFit : public QObject {
 public:
  explicit ScreenFit(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace detent::editor
