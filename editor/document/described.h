// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Names of a widget or action: object name, tool tip and accessible name.

#include <QString>

namespace detent::editor {

/// Returns the widget or action with its name, and tool tip and accessible name if given. An action has no
/// accessible name: its text is read out.
template <class Widget>
Widget* described(Widget* widget, const QString& name, const QString& tip = {},
                  const QString& accessible = {}) {
  widget->setObjectName(name);
  if (!tip.isEmpty()) widget->setToolTip(tip);
  if constexpr (requires { widget->setAccessibleName(accessible); })
    if (!accessible.isEmpty()) widget->setAccessibleName(accessible);
  return widget;
}

}  // namespace detent::editor
