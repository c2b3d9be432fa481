// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/file_watch.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace detent::editor {
namespace {

constexpr int settle_ms = 150;

}  // namespace

QByteArray contentHash(const QString& path) {
  QFile file(path);
  QCryptographicHash hash(QCryptographicHash::Sha1);
  if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file)) return {};
  return hash.result();
}

QByteArray contentHash(const QByteArray& contents) {
  return QCryptographicHash::hash(contents, QCryptographicHash::Sha1);
}

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
  settle_.setSingleShot(true);
  settle_.setInterval(settle_ms);
  const auto soon = [this] { settle_.start(); };
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, soon);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, soon);
  connect(&settle_, &QTimer::timeout, this, &FileWatch::check);
}

void FileWatch::watch(const QString& path) {
  known_[path] = contentHash(path);
  watchOnDisk(path);
}

void FileWatch::forget(const QString& path) {
  known_.remove(path);
  watcher_.removePath(path);
  const QString folder = QFileInfo(path).absolutePath();
  for (auto it = known_.cbegin(); it != known_.cend(); ++it)
    if (QFileInfo(it.key()).absolutePath() == folder) return;
  watcher_.removePath(folder);
}

// A file that was replaced by a rename must be added again, because the watcher follows the old file.
void FileWatch::watchOnDisk(const QString& path) {
  if (QFileInfo::exists(path) && !watcher_.files().contains(path)) watcher_.addPath(path);
  const QString folder = QFileInfo(path).absolutePath();
  if (QFileInfo::exists(folder) && !watcher_.directories().contains(folder)) watcher_.addPath(folder);
}

void FileWatch::check() {
  const QStringList paths = known_.keys();
  for (const QString& path : paths) {
    watchOnDisk(path);
    const QByteArray now = contentHash(path), before = known_.value(path);
    if (now == before) continue;
    known_[path] = now;
    if (now.isEmpty())
      emit vanished(path);
    else
      emit changedOutside(path);
  }
}

}  // namespace detent::editor
