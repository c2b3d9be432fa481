// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/recent_files.h"

#include <algorithm>
#include <QFileInfo>

namespace detent::editor {
namespace {

const QString key = QStringLiteral("files/recent");

}  // namespace

RecentFiles::RecentFiles(QSettings& settings, QObject* parent) : QObject(parent), settings_(settings) {}

QStringList RecentFiles::paths() const { return settings_.value(key).toStringList().mid(0, kept); }

void RecentFiles::add(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList all = paths();
  all.removeAll(absolute);
  all.prepend(absolute);
  store(all.mid(0, kept));
}

void RecentFiles::remove(const QString& path) {
  QStringList all = paths();
  if (all.removeAll(QFileInfo(path).absoluteFilePath()) > 0) store(all);
}

QStringList distinctNames(const QStringList& paths) {
  QStringList names;
  for (const QString& path : paths) {
    int parts = 1;
    const auto alike = [&](const QString& other) {
      return other != path && other.section('/', -parts) == path.section('/', -parts);
    };
    while (std::any_of(paths.begin(), paths.end(), alike)) ++parts;
    names << path.section('/', -parts);
  }
  return names;
}

void RecentFiles::clear() { store({}); }

void RecentFiles::store(const QStringList& paths) {
  settings_.setValue(key, paths);
  emit changed();
}

}  // namespace detent::editor
