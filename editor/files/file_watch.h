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
/// The hash of contents in memory.
QByteArray contentHash(const QByteArray& contents);

/// Compares contents, so a touched file, or one written again unchanged, does not count as changed. Folders
/// are watched too, to notice programs that rename a new file over the old one. GUI thread.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(QObject* parent = nullptr);

  /// Takes the file's present contents as known; called again after saving.
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
  QTimer settle_;                     // delay until another program has finished writing
  QHash<QString, QByteArray> known_;  // hash of the contents; empty: the file was gone
};

}  // namespace detent::editor
