// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One open button: its history, its file, the page it came from, and which of its states is worked on.

#include <memory>
#include <QByteArray>
#include <QObject>
#include <QString>

#include "editor/document/edit_history.h"
#include "importer/importer.h"

namespace detent::editor {

/// What a tab shows. Views draw its values and listen to its signals; only tools and operations call
/// `history()`. GUI thread.
class ButtonDocument : public QObject {
  Q_OBJECT

 public:
  explicit ButtonDocument(Button button, QObject* parent = nullptr);

  EditHistory& history() { return history_; }
  const EditHistory& history() const { return history_; }
  /// What is shown now, running drag included.
  const Button& button() const { return history_.button(); }

  /// The state that canvas, tools and panels work on; always one the button has.
  std::size_t activeState() const;
  void setActiveState(std::size_t state);
  const ForceGraph& graph() const { return button().states()[activeState()].graph; }

  /// Absolute; empty for a button that was never saved.
  const QString& path() const { return path_; }
  void setPath(const QString& path);
  /// Hash of what the file held when it was last read or written here; empty where there was none. Whoever
  /// writes compares it with the disk first (files/document_files.h).
  const QByteArray& knownContent() const { return knownContent_; }
  void setKnownContent(const QByteArray& hash) { knownContent_ = hash; }
  /// File name without suffixes, else the button's name, else "Untitled".
  QString title() const;

  /// Page, traced points and confidence of the import this button came from; null without one, and for
  /// buttons opened from a file. Shared and never changed.
  const std::shared_ptr<const importer::ImportReport>& origin() const { return origin_; }
  void setOrigin(std::shared_ptr<const importer::ImportReport> origin);

 signals:
  /// The button (or its preview) is another value now.
  void changed();
  void activeStateChanged();
  void originChanged();
  /// Path, name or unsaved mark.
  void titleChanged();

 private:
  EditHistory history_;
  std::size_t activeState_ = 0;
  QString path_;
  QByteArray knownContent_;
  std::shared_ptr<const importer::ImportReport> origin_;
};

}  // namespace detent::editor
