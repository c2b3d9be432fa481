// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Autosave and recovery: one folder per running editor with a file per modified document
// (docs/develop/decisions/1060-recovery-and-conflicts.md).

#include <memory>
#include <QHash>
#include <QImage>
#include <QList>
#include <QLockFile>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/files/recovery_file.h"

namespace detent::editor {

/// A document that an editor which is no longer running left unsaved.
struct LeftBehind {
  QString file;
  RecoveryRecord record;
};

/// An import that a dead editor left unfinished: the text it was kept as (importing/import_draft.h).
struct LeftImport {
  QString file;
  QByteArray text;
};

/// Keeps a recovery file for every modified document that it watches, and finds those of editors that have
/// crashed. An editor's files are guarded by a lock with its process id, so running editors never take each
/// other's files. GUI thread; a separate thread writes the files.
class RecoveryStore : public QObject {
  Q_OBJECT

 public:
  /// Longest time a change stays unwritten (plus the writing itself). A change after a quiet time starts it.
  static constexpr int writeAfter_ms = 2000;

  /// `folder` is created when something is written for the first time. Nothing is read or locked here.
  explicit RecoveryStore(QString folder, QObject* parent = nullptr);
  /// Waits for the writer. Files of documents that are still watched stay, as after a kill.
  ~RecoveryStore() override;

  const QString& folder() const { return folder_; }

  /// Watches until forget(); a document that is modified now is written soon.
  void watch(ButtonDocument& document);
  /// Deletes a button's recovery file, because the user has saved or discarded the changes.
  void forget(ButtonDocument& document);
  /// Writes all pending changes and returns when they are on the disk.
  void flush();

  /// Documents of dead editors, newest first. They stay reserved for this editor until it ends. Files that
  /// cannot be read are named in `unreadable` and stay where they are.
  QList<LeftBehind> leftBehind(QStringList* unreadable = nullptr);
  /// Deletes the file, because the document was recovered or is not wanted.
  void discard(const LeftBehind& left);

  /// Stores the pasted picture of an unfinished import (once per import) and returns its path; the path is
  /// empty without a picture.
  QString keepPicture(const QImage& picture);
  void keepImport(const QByteArray& text);
  /// Called when the import is finished or discarded.
  void dropImport();
  /// Imports of dead editors, as the last leftBehind() found them.
  const QList<LeftImport>& leftImports() const { return leftImports_; }
  void discard(const LeftImport& left);

 signals:
  /// A recovery file could not be written; `sentence` is for the status bar. Emitted only once until a write
  /// succeeds.
  void failed(const QString& sentence);

 private:
  struct Watched {
    std::unique_ptr<QTimer> timer;
    QString file;
    bool onDisk = false;
  };
  void documentChanged(ButtonDocument& document);
  void write(ButtonDocument& document);
  void removeFile(Watched& watched);
  bool openSession();
  void report(const QString& sentence);

  QString folder_;
  QString session_;  // name of this editor's folder
  std::unique_ptr<QLockFile> lock_;
  std::vector<std::unique_ptr<QLockFile>> reserved_;
  QHash<ButtonDocument*, std::shared_ptr<Watched>> watched_;
  QThreadPool writer_;  // one thread, so that requests are executed in order
  QList<LeftImport> leftImports_;
  int nextFile_ = 1;
  bool failing_ = false;
};

}  // namespace detent::editor
