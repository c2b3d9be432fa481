// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The files opened and saved last, kept between runs.

#include <QObject>
#include <QSettings>
#include <QStringList>

namespace detent::editor {

/// The list, newest first, without duplicates, with at most `kept` files. Missing files stay listed (a drive
/// may be disconnected) until opening them fails. GUI thread; two running editors share the list through the
/// settings.
class RecentFiles : public QObject {
  Q_OBJECT

 public:
  static constexpr int kept = 12;

  /// `settings` must outlive this.
  explicit RecentFiles(QSettings& settings, QObject* parent = nullptr);

  QStringList paths() const;
  void add(const QString& path);
  void remove(const QString& path);
  void clear();

 signals:
  void changed();

 private:
  void store(const QStringList& paths);
  QSettings& settings_;
};

/// Names of files, each with as many of its folders as tell it apart from the others.
QStringList distinctNames(const QStringList& paths);

}  // namespace detent::editor
