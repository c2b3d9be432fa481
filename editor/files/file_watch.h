// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Notices when another program changes a file that is open here.

#include <QFileSystemWatcher>
#include <QHash>
#include <QObject>
#include <QTimer>

namespace detent::editor {

/// SHA-1 of a file's contents; empty where it cannot be read. Any thread.
QByteArray contentHash(const QString& path);
/// The same of contents in memory.
QByteArray contentHash(const QByteArray& contents);

/// Compares contents, so touching a file or writing the same again is no change. Writers that rename a new
/// file over the old one are followed: folders are watched as well. GUI thread.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent = nullptr);

  /// From here on the present contents of the file are known; called again after saving.
  void watch(const QString& path);
  void forget(const QString& path);

 signals:
  /// Emitted once if the file has contents other than the known ones.
  void changedOutside(const QString& path);
  /// Emitted once if the file vanished; a file that comes back with other contents is a change.
  void vanished(const QString& path);

 private:
  void check();
  void watchOnDisk(const QString& path);

  QFileSystemWatcher watcher_;
  QTimer settle_;                     // writers are given a moment to finish
  QHash<QString, QByteArray> known_;  // hash of the contents; empty: the file was gone
};

}  // namespace detent::editor
