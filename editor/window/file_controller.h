// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Between the tabs and their files: opening, saving, closing, and what other programs do to an open file.

#include "editor/files/file_watch.h"
#include "editor/files/open_marks.h"
#include "editor/files/recent_files.h"
#include "editor/window/controller_context.h"
#include "editor/window/export_controller.h"
#include "editor/window/recovery_controller.h"
#include "editor/window/sheet_controller.h"

class QMimeData;

namespace detent::editor {

class BatchDialog;

/// Shows errors as notices beside the document they belong to. A broken file never changes an open document.
/// GUI thread.
class FileController : public QObject {
  Q_OBJECT

 public:
  explicit FileController(const ControllerContext& context, QObject* parent = nullptr);

  RecentFiles& recent() { return recent_; }
  ExportController& exports() { return exports_; }
  SheetController& sheets() { return sheets_; }

  void newButton();
  void openByDialog();
  void importByDialog();
  /// Imports many sheets at once, in a window beside this one.
  void importMany();
  /// Imports the datasheet that comes with the program.
  void importSample();
  /// Opens buttons in tabs, and sheets one after the other in the import dialogue.
  void open(const QStringList& paths);
  /// Opens a button file in a tab; null if it cannot be opened, which is reported.
  DocumentTab* openButton(const QString& path);
  /// Opens files or a picture from the clipboard or a drop; returns false if there is nothing usable.
  bool take(const QMimeData& data);
  static bool canTake(const QMimeData& data);

  /// Return false if the user cancelled or an error occurred.
  bool save(DocumentTab& tab);
  bool saveAs(DocumentTab& tab);
  bool saveAll();
  bool close(DocumentTab& tab);
  /// Closes all tabs before the program ends, with one question about all unsaved changes.
  bool closeAll();

  /// Offers the buttons and imports that crashed editors left; does nothing if there are none.
  void offerRecovery();

 signals:
  /// Something was done: a sentence for the status bar.
  void done(const QString& sentence);

 private:
  void connectTabs();
  bool write(DocumentTab& tab, const QString& path);
  void reload(DocumentTab& tab);
  void changedOutside(const QString& path);
  void vanished(const QString& path);
  void sayChangedOnDisk(DocumentTab& tab, const QString& sentence);
  void sayNotSaved(DocumentTab& tab, const QString& why);
  void sayOtherEditor(DocumentTab& tab);
  NoticeBar::Choice saveAsChoice(DocumentTab& tab);
  void trouble(const QString& id, const QString& sentence);

  ControllerContext at_;
  RecentFiles recent_;
  FileWatch watch_;
  OpenMarks marks_;
  SheetController sheets_;
  RecoveryController leftBehind_;
  ExportController exports_;
  BatchDialog* batch_ = nullptr;  ///< the window's; made when it is first needed
};

}  // namespace detent::editor
