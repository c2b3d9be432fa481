// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Contents of the window while no button is open.

#include <QAction>
#include <QListWidget>
#include <QWidget>

namespace detent::editor {

/// Ways to begin, and the files opened last. GUI thread.
class WelcomePage : public QWidget {
  Q_OBJECT

 public:
  /// One large button per action.
  explicit WelcomePage(const QList<QAction*>& ways, QWidget* parent = nullptr);
  void setRecent(const QStringList& paths);

 signals:
  void fileChosen(const QString& path);

 private:
  QListWidget* recent_ = nullptr;
  QWidget* recentSection_ = nullptr;
};

}  // namespace detent::editor
