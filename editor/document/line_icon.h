// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Icons of actions: editor/icons/*.svg, drawn in the colours of the window.

#include <QIcon>

namespace detent::editor {

/// What stands in editor/icons under this name: sharp at every scale, `currentColor` in the window's text colour, press and
/// release in theirs, light and dark as the window is when it is painted. Null where there is none. GUI thread.
QIcon lineIcon(const QString& name);

}  // namespace detent::editor
