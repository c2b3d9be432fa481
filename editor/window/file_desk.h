// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Everything that goes between the tabs and the disk: opening, importing, saving, closing, recovering.

#include <deque>
#include <QImage>
#include <QPointer>
#include <QSettings>
#include <QTimer>

#include "editor/files/file_watch.h"
#include "editor/files/open_marks.h"
#include "editor/files/recent_files.h"
#include "editor/files/recovery_store.h"
#include "editor/importing/page_return.h"
#include "editor/window/prompts.h"
#include "editor/window/tab_area.h"

class QMimeData;

namespace detent::editor {

class ImportDialog;

/// What a FileDesk works with; all of it outlives the desk.
struct FileDeskPlaces {
  QWidget& window;  ///< parent of dialogues
  TabArea& tabs;
  NoticeBar& notices;  ///< for what belongs to no tab
  ViewSettings& view;
  QSettings& settings;
  Prompts& prompts;
  RecoveryStore& recovery;
};

/// Troubles are said as notices where they happen; nothing here changes a document that is open because
/// another file is broken. GUI thread.
class FileDesk : public QObject {
  Q_OBJECT

 public:
  explicit FileDesk(const FileDeskPlaces& places, QObject* parent = nullptr);
  ~FileDesk() override;

  RecentFiles& recent() { return recent_; }

  void newButton();
  void openByDialog();
  void importByDialog();
  /// Buttons in tabs, pages one after the other in the import dialogue.
  void open(const QStringList& paths);
  /// A button file; null if it cannot be opened (said).
  DocumentTab* openButton(const QString& path);
  void importPicture(const QImage& picture);
  /// Files or a picture from clipboard or drop; false if there is nothing of use in it.
  bool take(const QMimeData& data);
  static bool canTake(const QMimeData& data);

  /// These give false if it was cancelled or failed.
  bool save(DocumentTab& tab);
  bool saveAs(DocumentTab& tab);
  bool saveAll();
  bool close(DocumentTab& tab);
  /// Before the program ends: one question for all.
  bool closeAll();

  void exportCsv(DocumentTab& tab);
  void exportSvg(DocumentTab& tab);
  void exportPng(DocumentTab& tab);
  void exportWav(DocumentTab& tab);

  /// Says what dead editors left, with a choice; nothing if they left nothing.
  void offerRecovery();

 signals:
  /// Something was done: a sentence for the status bar.
  void done(const QString& sentence);

 private:
  void startImport();
  ImportDialog& importDialog();
  void addImported(std::shared_ptr<const importer::ImportReport> report);
  bool write(DocumentTab& tab, const QString& path);
  void sayChangedOnDisk(DocumentTab& tab, const QString& sentence);
  void sayNotSaved(DocumentTab& tab, const QString& why);
  void sayOtherEditor(ButtonDocument& document);
  NoticeBar::Choice saveAsChoice(DocumentTab& tab);
  void reload(DocumentTab& tab);
  void connectPages();
  void keepDraft();
  void offerImports();
  NoticeBar::Choice findSheetChoice(ButtonDocument& document);
  void exportTo(DocumentTab& tab, const QString& title, const QString& filter, const QString& ending,
                const std::function<Result<Done>(const QString&)>& write);
  void sayLeftBehind(const QList<LeftBehind>& left);
  void discardLeftBehind(const QList<LeftBehind>& left);
  void recover(const QList<LeftBehind>& left);
  void recoverOne(const LeftBehind& left);
  void changedOutside(const QString& path);
  void vanished(const QString& path);
  void trouble(const QString& id, const QString& sentence);
  QString folder() const;
  void rememberFolder(const QString& path);

  FileDeskPlaces at_;
  RecentFiles recent_;
  FileWatch watch_;
  OpenMarks marks_;
  PageReturn pages_;
  QTimer draftSoon_;
  QString pastedFile_;     ///< where the pasted picture of the import dialogue is kept
  QString importingFrom_;  ///< path of the sheet in the import dialogue; empty for a pasted picture
  QPointer<ImportDialog> importing_;
  std::deque<QString> toImport_;
};

}  // namespace detent::editor
