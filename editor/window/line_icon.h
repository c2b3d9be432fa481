// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Icons of the tool bar: lines in the text's own colour, sharp at every scale, right in light and dark.

#include <QIcon>

namespace detent::editor {

/// The icon for an action's object name; a null icon for names without one.
QIcon lineIcon(const QString& actionName);

}  // namespace detent::editor
