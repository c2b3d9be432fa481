// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Icons of actions: editor/icons/*.svg in the colours of the window.

#include <QIcon>

namespace detent::editor {

/// The icon of this name: sharp at every scale, `currentColor` in the window's text colour, press and release
/// in theirs, light or dark like the window when painted. Null if there is none. GUI thread.
QIcon lineIcon(const QString& name);

}  // namespace detent::editor
