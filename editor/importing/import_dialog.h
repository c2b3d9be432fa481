// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The dialogue that turns a datasheet into a button: pages and graphs, findings drawn over the page, and
// corrections of every finding.

#include <functional>
#include <memory>
#include <QDialog>

#include "editor/document/view_settings.h"
#include "editor/importing/import_draft.h"
#include "importer/importer.h"

namespace detent::editor {

/// Opens a file or a pasted picture for correction and import. One per import; may be used again. GUI thread;
/// a separate thread does the work, and the dialogue never waits for it.
class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  /// `settings` (units of what is shown) must outlive it.
  explicit ImportDialog(ViewSettings& settings, QWidget* parent = nullptr);
  ~ImportDialog() override;

  /// A picture, PDF, SVG or force meter's CSV. Returns at once; faults of the file are reported in the
  /// dialogue. If corrections would be lost, the leave question comes first.
  void openFile(const QString& path);
  /// A pasted image.
  void openPicture(const QImage& picture);
  /// Continues an interrupted import.
  void continueDraft(const ImportDraft& draft);
  ImportDraft draft() const;
  /// Null unless a picture was pasted.
  const QImage& pastedPicture() const;
  /// Called before closing discards corrections; without it they are discarded silently.
  void setLeaveQuestion(std::function<bool()> mayLeave) { mayLeave_ = std::move(mayLeave); }
  void reject() override;
  /// Closing ends all work.
  void done(int result) override;

 signals:
  /// Emitted once per accepted graph. Shared and never changed.
  void imported(std::shared_ptr<const importer::ImportReport> report);
  /// A file was opened.
  void opened(const QString& path);
  /// A file could not be read.
  void unreadable(const QString& path);
  /// The result of draft() has changed, or may have.
  void draftChanged();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  bool mayGiveUp() const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::function<bool()> mayLeave_;
};

}  // namespace detent::editor
