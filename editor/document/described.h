// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a widget or an action is known by: its object name, its tool tip and its accessible name.

#include <QString>

namespace detent::editor {

/// The widget or action itself, named; tool tip and accessible name where they are given. An action has no accessible
/// name: its text is read out.
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
