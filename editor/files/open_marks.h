// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Marks of the files that each running editor has open, so that two editors can warn before one overwrites
// the other's file.

#include <map>
#include <memory>
#include <optional>
#include <QLockFile>
#include <QObject>
#include <QTimer>

#include "editor/document/button_document.h"

namespace detent::editor {

/// One lock file per open button file, in a folder of the user (never beside the file), named by the file's
/// real path. The mark of an editor that has crashed is ignored. A document whose file is marked tries again
/// every few seconds, and gets the mark when the other editor closes the file. GUI thread.
class OpenMarks : public QObject {
  Q_OBJECT

 public:
  static constexpr int tryAgain_ms = 3000;

  /// `folder` is made when the first file is marked.
  explicit OpenMarks(QString folder, QObject* parent = nullptr);
  ~OpenMarks() override;

  /// Follows the document's path until forget().
  void watch(ButtonDocument& document);
  void forget(ButtonDocument& document);
  /// Process id of the other editor that has this document's file open.
  std::optional<qint64> otherEditor(const ButtonDocument& document) const;

 signals:
  /// Another editor has opened or closed this document's file.
  void otherEditorChanged(detent::editor::ButtonDocument* document);

 private:
  struct Mark {
    QString path;
    std::unique_ptr<QLockFile> lock;  // null: not taken
    std::optional<qint64> other;
  };
  void follow(ButtonDocument& document);
  void take(ButtonDocument& document, Mark& mark);

  QString folder_;
  std::map<ButtonDocument*, Mark> marks_;
  QTimer again_;
};

}  // namespace detent::editor
