// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Connects sheets and tabs: imports one after the other, keeps corrections, and finds the sheets of saved
// buttons again.

#include <deque>
#include <QImage>
#include <QPointer>
#include <QTimer>

#include "editor/importing/import_draft.h"
#include "editor/importing/page_return.h"
#include "editor/window/controller_context.h"

namespace detent::editor {

class ImportDialog;

/// One import dialogue at a time; further sheets wait for their turn. GUI thread.
class SheetController : public QObject {
  Q_OBJECT

 public:
  explicit SheetController(const ControllerContext& context, QObject* parent = nullptr);
  ~SheetController() override;

  void importFiles(const QStringList& paths);
  /// Opens a sheet in the import dialogue and selects one of its graphs.
  void importGraph(const QString& path, GraphId graph);
  void importPicture(const QImage& picture);
  /// Opens a button that was imported elsewhere from this sheet in a tab with its page, as unsaved work.
  void openImported(const QString& path, const Button& button);
  /// Call when a tab for the document was added: its sheet is traced again when its points are needed.
  void attend(ButtonDocument& document);
  /// Shows the page of the button behind its curves; if it cannot be found, the tab says so.
  void bringPageBack(ButtonDocument& document);
  /// Makes the button's file hold the page too, from the next save on.
  void keepPage(ButtonDocument& document, bool keep);
  /// Shows the imports that crashed editors left unfinished, with a choice. Call after the recovery store was
  /// searched.
  void offerInterrupted();

 signals:
  /// Something was done: a sentence for the status bar.
  void done(const QString& sentence);
  /// A graph of this sheet was imported in the import dialogue.
  void imported(const QString& path, const importer::ImportReport& report);
  /// The sheet is open in the import dialogue and could be read.
  void opened(const QString& path);
  void unreadable(const QString& path);

 private:
  void startNext();
  ImportDialog& dialog();
  ImportDialog& shownDialog();
  void addImported(std::shared_ptr<const importer::ImportReport> report);
  void keepDraft();
  void connectPages();
  NoticeBar::Choice findSheetChoice(ButtonDocument& document);

  ControllerContext at_;
  PageReturn pages_;
  QTimer draftSoon_;
  QString pastedFile_;  ///< file of the picture pasted into the import dialogue
  QPointer<ImportDialog> importing_;
  std::deque<ImportDraft> waiting_;  ///< drafts without corrections so far
};

}  // namespace detent::editor
