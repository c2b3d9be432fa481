// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/file_controller.h"

#include <QDir>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

#include "editor/document/form_widgets.h"
#include "editor/document/message_words.h"
#include "editor/files/document_files.h"
#include "editor/files/input_kind.h"
#include "editor/importing/batch_dialog.h"
#include "model/check.h"
#include "model/file/text_file.h"

namespace detent::editor {
namespace {

QString marksBeside(const QString& recoveryFolder) {
  return QFileInfo(recoveryFolder).dir().filePath(QStringLiteral("open-files"));
}

}  // namespace

FileController::FileController(const ControllerContext& context, QObject* parent)
    : QObject(parent),
      at_(context),
      recent_(context.settings),
      marks_(marksBeside(context.recovery.folder())),
      sheets_(context),
      leftBehind_(context),
      exports_(context) {
  connect(&sheets_, &SheetController::done, this, &FileController::done);
  connect(&exports_, &ExportController::done, this, &FileController::done);
  connect(&sheets_, &SheetController::opened, &recent_, &RecentFiles::add);
  connect(&sheets_, &SheetController::unreadable, &recent_, &RecentFiles::remove);
  connect(&leftBehind_, &RecoveryController::recovered, this, [this](DocumentTab* tab) {
    if (const QString path = tab->document().path(); !path.isEmpty()) watch_.watch(path);
    sheets_.bringPageBack(tab->document());
  });
  connect(&marks_, &OpenMarks::otherEditorChanged, this, [this](ButtonDocument* document) {
    if (DocumentTab* tab = at_.tabs.tabOf(document)) sayOtherEditor(*tab);
  });
  connect(&watch_, &FileWatch::changedOutside, this, &FileController::changedOutside);
  connect(&watch_, &FileWatch::vanished, this, &FileController::vanished);
  connect(&at_.recovery, &RecoveryStore::failed, this,
          [this](const QString& sentence) { trouble("autosave", sentence); });
  connectTabs();
}

void FileController::connectTabs() {
  connect(&at_.tabs, &TabArea::tabAdded, this, [this](DocumentTab* tab) {
    at_.recovery.watch(tab->document());
    marks_.watch(tab->document());
    sayOtherEditor(*tab);  // called here because the mark is found before the tab is in the area
    sheets_.attend(tab->document());
  });
  connect(&at_.tabs, &TabArea::tabClosing, this, [this](DocumentTab* tab) {
    at_.recovery.forget(tab->document());
    marks_.forget(tab->document());
    if (!tab->document().path().isEmpty()) watch_.forget(tab->document().path());
  });
}

void FileController::trouble(const QString& id, const QString& sentence) {
  at_.notices.say(id, NoticeBar::Kind::trouble, sentence);
}

// ---- opening

void FileController::newButton() {
  const auto button = at_.prompts.newButton(&at_.window);
  if (button) at_.tabs.add(std::make_unique<ButtonDocument>(*button));
}

void FileController::openByDialog() {
  open(at_.prompts.filesToOpen(&at_.window, tr("Open"), at_.folder(), openFilters()));
}

void FileController::importByDialog() {
  const QStringList chosen =
      at_.prompts.filesToOpen(&at_.window, tr("Import"), at_.folderToImport(), importFilters());
  if (!chosen.isEmpty()) at_.rememberImportOf(chosen.front());
  sheets_.importFiles(chosen);
}

void FileController::importMany() {
  if (!batch_) {
    BatchActions actions;
    actions.files = [this](QWidget* parent) {
      QStringList chosen =
          at_.prompts.filesToOpen(parent, tr("Import many files"), at_.folderToImport(), importFilters());
      if (!chosen.isEmpty()) at_.rememberImportOf(chosen.front());
      return chosen;
    };
    actions.folder = [this](QWidget* parent) {
      QString chosen = at_.prompts.folder(parent, tr("Import a folder"), at_.folderToImport());
      if (!chosen.isEmpty()) at_.rememberImportedFrom(chosen);
      return chosen;
    };
    actions.folderToSave = [this](QWidget* parent) {
      QString chosen = at_.prompts.folder(parent, tr("Save the buttons in"), at_.folderToSave());
      if (!chosen.isEmpty()) at_.rememberSavedIn(chosen);
      return chosen;
    };
    actions.correct = [this](const QString& path, GraphId graph) { sheets_.importGraph(path, graph); };
    actions.open = [this](const QString& path, const Button& button) { sheets_.openImported(path, button); };
    batch_ = new BatchDialog(at_.view, std::move(actions), &at_.window);
    connect(&sheets_, &SheetController::imported, batch_, &BatchDialog::takeChecked);
  }
  bringUp(*batch_);
}

// Imports a copy of the sample datasheet, so that it can be opened again and its page is found like any
// other.
void FileController::importSample() {
  const QString path =
      QFileInfo(at_.recovery.folder()).dir().filePath(tr("sample-datasheet") + QStringLiteral(".pdf"));
  QFile inside(QStringLiteral(":/samples/white-vector.pdf"));
  DETENT_CHECK(inside.open(QIODevice::ReadOnly), "the sample is in the program");
  QDir().mkpath(QFileInfo(path).path());
  const auto written =
      writeTextFileAtomically(QFile::encodeName(path).toStdString(), inside.readAll().toStdString());
  if (!written) return trouble("sample", sentenceOf(written.failure()));
  at_.notices.dismiss("sample");
  sheets_.importFiles({path});
}

void FileController::open(const QStringList& paths) {
  QStringList pages;
  for (const QString& path : paths) {
    const auto kind = inputKindOf(path);
    if (kind && *kind == InputKind::page) {
      pages << QFileInfo(path).absoluteFilePath();
      at_.rememberImportOf(path);
    } else {
      openButton(path);
      if (kind) at_.rememberFolderOf(path);
    }
  }
  sheets_.importFiles(pages);
}

DocumentTab* FileController::openButton(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  if (DocumentTab* open = at_.tabs.withPath(absolute)) {
    at_.tabs.show(open->document());
    return open;
  }
  auto document = openDocument(absolute);
  if (!document) {
    recent_.remove(absolute);
    trouble("open:" + absolute, tr("Not opened: %1").arg(sentenceOf(document.failure())));
    return nullptr;
  }
  at_.notices.dismiss("open:" + absolute);
  DocumentTab& tab = at_.tabs.add(*std::move(document));
  if (!tab.document().path().isEmpty()) watch_.watch(absolute);
  recent_.add(absolute);
  sheets_.bringPageBack(tab.document());
  return &tab;
}

bool FileController::canTake(const QMimeData& data) { return data.hasUrls() || data.hasImage(); }

bool FileController::take(const QMimeData& data) {
  QStringList paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  if (!paths.isEmpty()) {
    open(paths);
    return true;
  }
  const QImage picture = qvariant_cast<QImage>(data.imageData());
  if (picture.isNull()) return false;
  sheets_.importPicture(picture);
  return true;
}

// ---- saving and closing

NoticeBar::Choice FileController::saveAsChoice(DocumentTab& tab) {
  return {"saveAs", tr("Save as…"), [this, &tab] { saveAs(tab); }};
}

void FileController::sayNotSaved(DocumentTab& tab, const QString& why) {
  tab.notices().say("save", NoticeBar::Kind::trouble, tr("Not saved: %1").arg(why), {saveAsChoice(tab)});
}

void FileController::sayOtherEditor(DocumentTab& tab) {
  const auto other = marks_.otherEditor(tab.document());
  if (!other) return tab.notices().dismiss("otherEditor");
  tab.notices().say("otherEditor", NoticeBar::Kind::information,
                    tr("Another Detent window (process %1) has this file open. You'll be warned before "
                       "overwriting the other window's changes.")
                        .arg(*other));
}

// Asks before it overwrites a file that another program has changed since.
void FileController::sayChangedOnDisk(DocumentTab& tab, const QString& sentence) {
  tab.notices().say("disk", NoticeBar::Kind::trouble, sentence,
                    {{"overwrite", tr("Overwrite"),
                      [this, &tab, seen = contentHash(tab.document().path())] {
                        tab.document().setKnownContent(seen);
                        save(tab);
                      }},
                     saveAsChoice(tab),
                     {"reload", tr("Reload"), [this, &tab] { reload(tab); }}});
}

void FileController::reload(DocumentTab& tab) {
  const auto reloaded = reloadDocument(tab.document());
  if (reloaded)
    emit done(tr("Reloaded %1").arg(shownPath(tab.document().path())));
  else
    tab.notices().say("disk", NoticeBar::Kind::trouble,
                      tr("Not reloaded: %1").arg(sentenceOf(reloaded.failure())), {saveAsChoice(tab)});
}

bool FileController::write(DocumentTab& tab, const QString& path) {
  const QString before = tab.document().path();
  if (path == before && diskStateOf(tab.document()) == DiskState::changed) {
    at_.tabs.show(tab.document());
    sayChangedOnDisk(
        tab, tr("Not saved: another program has changed %1 since it was read here.").arg(shownPath(path)));
    return false;
  }
  const auto saved = saveDocument(tab.document(), path);
  if (!saved) {
    sayNotSaved(tab, sentenceOf(saved.failure()));
    return false;
  }
  if (!before.isEmpty() && before != tab.document().path()) watch_.forget(before);
  watch_.watch(tab.document().path());
  for (const char* notice : {"save", "disk"}) tab.notices().dismiss(notice);
  recent_.add(tab.document().path());
  at_.rememberSavedIn(QFileInfo(tab.document().path()).absolutePath());
  emit done(tr("Saved %1").arg(shownPath(tab.document().path())));
  return true;
}

bool FileController::save(DocumentTab& tab) {
  return tab.document().path().isEmpty() ? saveAs(tab) : write(tab, tab.document().path());
}

bool FileController::saveAs(DocumentTab& tab) {
  at_.tabs.show(tab.document());  // shows the button that is being named
  const QString now = tab.document().path();
  const QString suggested =
      now.isEmpty() ? suggestedPath(tab.document(), at_.folderToSave(), ".button.json") : now;
  const QString chosen =
      at_.prompts.fileToSave(&at_.window, tr("Save as"), suggested, tr("Buttons") + " (*.button.json)");
  if (chosen.isEmpty()) return false;
  const QString path = withButtonEnding(QFileInfo(chosen).absoluteFilePath());
  // The dialogue's question was about the typed name, not about that name with its ending.
  if (path != QFileInfo(chosen).absoluteFilePath() && QFileInfo::exists(path) &&
      !at_.prompts.confirm(&at_.window, tr("%1 exists already.").arg(shownPath(path)), tr("Replace it")))
    return false;
  if (DocumentTab* other = at_.tabs.withPath(path); other && other != &tab) {
    sayNotSaved(
        tab,
        tr("%1 is open in another tab. Close it there first, or choose another name").arg(shownPath(path)));
    return false;
  }
  return write(tab, path);
}

bool FileController::saveAll() {
  for (DocumentTab* tab : at_.tabs.all())
    if (tab->document().history().modified() && !save(*tab)) return false;
  return true;
}

bool FileController::close(DocumentTab& tab) {
  if (tab.document().history().dragging()) tab.document().history().cancelDrag();
  if (tab.document().history().modified()) {
    at_.tabs.show(tab.document());
    const SaveChoice choice = at_.prompts.unsaved(&at_.window, {tab.document().title()});
    if (choice == SaveChoice::cancel) return false;
    if (choice == SaveChoice::save && !save(tab)) return false;
  }
  at_.tabs.remove(tab);
  return true;
}

bool FileController::closeAll() {
  QStringList unsaved;
  for (DocumentTab* tab : at_.tabs.all()) {
    if (tab->document().history().dragging()) tab->document().history().cancelDrag();
    if (tab->document().history().modified()) unsaved << tab->document().title();
  }
  if (!unsaved.isEmpty()) {
    const SaveChoice choice = at_.prompts.unsaved(&at_.window, unsaved);
    if (choice == SaveChoice::cancel) return false;
    if (choice == SaveChoice::save && !saveAll()) return false;
  }
  for (DocumentTab* tab : at_.tabs.all()) at_.tabs.remove(*tab);
  return true;
}

// ---- recovery, other programs

void FileController::offerRecovery() {
  leftBehind_.offer();
  sheets_.offerInterrupted();
}

void FileController::changedOutside(const QString& path) {
  DocumentTab* tab = at_.tabs.withPath(path);
  if (!tab) return;
  const bool modified = tab->document().history().modified();
  tab->notices().say(
      "disk", NoticeBar::Kind::information,
      modified ? tr("Another program changed this file, and there are unsaved changes here. Reloading can be "
                    "undone.")
               : tr("Another program changed this file."),
      {{"reload", tr("Reload"), [this, tab] { reload(*tab); }},
       {"keepMine", tr("Keep my version"), [tab, seen = contentHash(path)] {
          tab->document().history().stack().resetClean();
          tab->document().setKnownContent(seen);  // the next save does not ask about the same content again
        }}});
}

void FileController::vanished(const QString& path) {
  DocumentTab* tab = at_.tabs.withPath(path);
  if (!tab) return;
  tab->document().history().stack().resetClean();
  tab->notices().say("disk", NoticeBar::Kind::information,
                     tr("The file of this button was deleted or moved away. Saving writes it again."));
}

}  // namespace detent::editor
