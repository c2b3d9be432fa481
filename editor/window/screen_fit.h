// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Fits windows to small screens: none is larger than its screen or beyond its edge, and tabs of panels show
// their whole names.

#include <QObject>
#include <QWidget>

namespace detent::editor {

/// Space around a window for the window manager's frame.
inline constexpr QSize roomForFrame_px{8, 40};

/// While it exists, a window that opens larger than its screen is reduced to the screen's size, and one that
/// was placed beyond an edge is moved inside, Qt's windows too. Names of panels in tabs are not cut off;
/// without enough space the tabs scroll. One for the whole application. GUI thread.
class ScreenFit : public QObject {
 public:
  explicit ScreenFit(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace detent::editor
