// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Help > Keyboard shortcuts: made from the actions themselves, so it cannot be out of date.

#include <QAction>
#include <QDialog>

namespace detent::editor {

/// One line of the list.
struct ShortcutRow {
  QString group, name, keys;
};

/// Name without mnemonics, keys as the desktop writes them; actions without a shortcut are left out.
std::vector<ShortcutRow> shortcutRows(const QString& group, const QList<QAction*>& actions);

/// Can be searched. GUI thread.
class ShortcutDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutDialog(const std::vector<ShortcutRow>& rows, QWidget* parent = nullptr);
};

}  // namespace detent::editor
