// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/file_desk.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QMimeData>
#include <QStandardPaths>
#include <QUrl>

#include "editor/document/message_words.h"
#include "editor/files/document_files.h"
#include "editor/files/exports.h"
#include "editor/files/input_kind.h"
#include "editor/importing/import_dialog.h"

namespace detent::editor {
namespace {

constexpr QSize exportedPicture_px{2400, 1600};
constexpr double exportedPixelRatio = 2;

QString shown(const QString& path) { return QDir::toNativeSeparators(path); }

QString marksBeside(const QString& recoveryFolder) {
  return QFileInfo(recoveryFolder).dir().filePath(QStringLiteral("open-files"));
}

}  // namespace

FileDesk::FileDesk(const FileDeskPlaces& places, QObject* parent)
    : QObject(parent),
      at_(places),
      recent_(places.settings),
      marks_(marksBeside(places.recovery.folder())),
      pages_(places.settings) {
  connectPages();
  draftSoon_.setSingleShot(true);
  draftSoon_.setInterval(RecoveryStore::writeAfter_ms);
  connect(&draftSoon_, &QTimer::timeout, this, &FileDesk::keepDraft);
  connect(&marks_, &OpenMarks::otherEditorChanged, this,
          [this](ButtonDocument* document) { sayOtherEditor(*document); });
  connect(&watch_, &FileWatch::changedOutside, this, &FileDesk::changedOutside);
  connect(&watch_, &FileWatch::vanished, this, &FileDesk::vanished);
  connect(&at_.recovery, &RecoveryStore::failed, this,
          [this](const QString& sentence) { trouble("autosave", sentence); });
  connect(&at_.tabs, &TabArea::tabAdded, this, [this](DocumentTab* tab) {
    at_.recovery.watch(tab->document());
    marks_.watch(tab->document());
  });
  connect(&at_.tabs, &TabArea::tabClosing, this, [this](DocumentTab* tab) {
    at_.recovery.forget(tab->document());
    marks_.forget(tab->document());
    if (!tab->document().path().isEmpty()) watch_.forget(tab->document().path());
  });
}

FileDesk::~FileDesk() { delete importing_; }

NoticeBar::Choice FileDesk::findSheetChoice(ButtonDocument& document) {
  return {"findSheet", tr("Find the sheet…"), [this, known = QPointer<ButtonDocument>(&document)] {
            const QStringList chosen =
                at_.prompts.filesToOpen(&at_.window, tr("Find the sheet"), folder(), openFilters());
            if (known && !chosen.isEmpty()) pages_.bringBackFrom(*known, chosen.front());
          }};
}

void FileDesk::connectPages() {
  const auto say = [this](ButtonDocument* document, NoticeBar::Kind kind, const QString& sentence) {
    if (DocumentTab* tab = at_.tabs.tabOf(document))
      tab->notices().say("page", kind, sentence, {findSheetChoice(*document)});
  };
  connect(&pages_, &PageReturn::returned, this, [this](ButtonDocument* document) {
    if (DocumentTab* tab = at_.tabs.tabOf(document)) tab->notices().dismiss("page");
    emit done(tr("The page of %1 is behind the curves again.").arg(document->title()));
  });
  connect(&pages_, &PageReturn::missing, this, [say](ButtonDocument* document, const QString& name) {
    say(document, NoticeBar::Kind::information,
        tr("The sheet this button was read from, %1, is neither beside its file nor where it was last.")
            .arg(name));
  });
  connect(&pages_, &PageReturn::refused, this, [say](ButtonDocument* document, const QString& sentence) {
    say(document, NoticeBar::Kind::trouble, sentence);
  });
}

void FileDesk::trouble(const QString& id, const QString& sentence) {
  at_.notices.say(id, NoticeBar::Kind::trouble, sentence);
}

QString FileDesk::folder() const {
  const QString last = at_.settings.value("files/folder").toString();
  return QFileInfo(last).isDir() ? last : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void FileDesk::rememberFolder(const QString& path) {
  at_.settings.setValue("files/folder", QFileInfo(path).absolutePath());
}

// ---- opening

void FileDesk::newButton() {
  const auto button = at_.prompts.newButton(&at_.window);
  if (button) at_.tabs.add(std::make_unique<ButtonDocument>(*button));
}

void FileDesk::openByDialog() {
  open(at_.prompts.filesToOpen(&at_.window, tr("Open"), folder(), openFilters()));
}

void FileDesk::importByDialog() {
  QStringList filters = openFilters();
  filters.move(2, 0);  // datasheets first
  for (const QString& path : at_.prompts.filesToOpen(&at_.window, tr("Import"), folder(), filters)) {
    rememberFolder(path);
    toImport_.push_back(path);
  }
  startImport();
}

void FileDesk::open(const QStringList& paths) {
  for (const QString& path : paths) {
    const auto kind = inputKindOf(path);
    if (kind && *kind == InputKind::page)
      toImport_.push_back(QFileInfo(path).absoluteFilePath());
    else
      openButton(path);
    if (kind) rememberFolder(path);
  }
  startImport();
}

DocumentTab* FileDesk::openButton(const QString& path) {
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
  pages_.bringBack(tab.document());
  return &tab;
}

// One dialogue at a time; further pages wait for their turn.
void FileDesk::startImport() {
  if (toImport_.empty() || (importing_ && importing_->isVisible())) return;
  const QString path = toImport_.front();
  toImport_.pop_front();
  importingFrom_ = path;
  ImportDialog& dialog = importDialog();
  dialog.show();
  dialog.raise();
  dialog.activateWindow();
  dialog.openFile(path);
  recent_.add(path);
}

void FileDesk::importPicture(const QImage& picture) {
  importingFrom_.clear();
  ImportDialog& dialog = importDialog();
  dialog.show();
  dialog.raise();
  dialog.activateWindow();
  dialog.openPicture(picture);
}

// Made when it is first needed, and anew each time: what an import loaded is let go of with it.
ImportDialog& FileDesk::importDialog() {
  if (importing_ && importing_->isVisible()) return *importing_;
  delete importing_;
  importing_ = new ImportDialog(at_.view, &at_.window);
  connect(importing_, &ImportDialog::imported, this, &FileDesk::addImported);
  connect(importing_, &ImportDialog::draftChanged, this, [this] {
    if (!draftSoon_.isActive()) draftSoon_.start();
  });
  connect(importing_, &QDialog::finished, this, [this] {
    draftSoon_.stop();
    pastedFile_.clear();
    at_.recovery.dropImport();
  });
  importing_->setLeaveQuestion([this] {
    return at_.prompts.confirm(importing_, tr("Give up the corrections made to this sheet?"), tr("Give up"));
  });
  connect(importing_, &QDialog::finished, this, &FileDesk::startImport, Qt::QueuedConnection);
  return *importing_;
}

void FileDesk::addImported(std::shared_ptr<const importer::ImportReport> report) {
  if (const auto& provenance = report->button.provenance()) pages_.remember(*provenance, importingFrom_);
  at_.tabs.add(importedDocument(std::move(report)));
  at_.recovery.flush();  // it may have cost an hour: not even two seconds of it are risked
}

bool FileDesk::canTake(const QMimeData& data) { return data.hasUrls() || data.hasImage(); }

bool FileDesk::take(const QMimeData& data) {
  QStringList paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  if (!paths.isEmpty()) {
    open(paths);
    return true;
  }
  const QImage picture = qvariant_cast<QImage>(data.imageData());
  if (picture.isNull()) return false;
  importPicture(picture);
  return true;
}

// ---- saving and closing

NoticeBar::Choice FileDesk::saveAsChoice(DocumentTab& tab) {
  return {"saveAs", tr("Save as…"), [this, &tab] { saveAs(tab); }};
}

void FileDesk::sayNotSaved(DocumentTab& tab, const QString& why) {
  tab.notices().say("save", NoticeBar::Kind::trouble, tr("Not saved: %1").arg(why), {saveAsChoice(tab)});
}

void FileDesk::sayOtherEditor(ButtonDocument& document) {
  DocumentTab* tab = at_.tabs.tabOf(&document);
  if (!tab) return;
  const auto other = marks_.otherEditor(document);
  if (!other) return tab->notices().dismiss("otherEditor");
  tab->notices().say(
      "otherEditor", NoticeBar::Kind::information,
      tr("Another Detent window (process %1) has this file open. Whoever saves second is asked "
         "before the first one's changes are overwritten.")
          .arg(*other));
}

// Nothing is written over what somebody else has saved since: the person decides.
void FileDesk::sayChangedOnDisk(DocumentTab& tab, const QString& sentence) {
  tab.notices().say("disk", NoticeBar::Kind::trouble, sentence,
                    {{"overwrite", tr("Overwrite"),
                      [this, &tab] {
                        tab.document().setKnownContent(contentHash(tab.document().path()));
                        save(tab);
                      }},
                     saveAsChoice(tab),
                     {"reload", tr("Reload"), [this, &tab] { reload(tab); }}});
}

void FileDesk::reload(DocumentTab& tab) {
  const auto reloaded = reloadDocument(tab.document());
  if (reloaded)
    emit done(tr("Reloaded %1").arg(shown(tab.document().path())));
  else
    tab.notices().say("disk", NoticeBar::Kind::trouble,
                      tr("Not reloaded: %1").arg(sentenceOf(reloaded.failure())), {saveAsChoice(tab)});
}

bool FileDesk::write(DocumentTab& tab, const QString& path) {
  const QString before = tab.document().path();
  if (path == before && diskStateOf(tab.document()) == DiskState::changed) {
    at_.tabs.show(tab.document());
    sayChangedOnDisk(
        tab, tr("Not saved: another program has changed %1 since it was read here.").arg(shown(path)));
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
  rememberFolder(tab.document().path());
  emit done(tr("Saved %1").arg(shown(tab.document().path())));
  return true;
}

bool FileDesk::save(DocumentTab& tab) {
  return tab.document().path().isEmpty() ? saveAs(tab) : write(tab, tab.document().path());
}

bool FileDesk::saveAs(DocumentTab& tab) {
  at_.tabs.show(tab.document());  // the person sees what is being named
  const QString now = tab.document().path();
  const QString suggested = now.isEmpty() ? suggestedPath(tab.document(), folder(), ".button.json") : now;
  const QString chosen =
      at_.prompts.fileToSave(&at_.window, tr("Save as"), suggested, tr("Buttons") + " (*.button.json)");
  if (chosen.isEmpty()) return false;
  const QString path = withButtonEnding(QFileInfo(chosen).absoluteFilePath());
  // The dialogue asked about the name it saw, not about the one with the ending.
  if (path != QFileInfo(chosen).absoluteFilePath() && QFileInfo::exists(path) &&
      !at_.prompts.confirm(&at_.window, tr("%1 exists already.").arg(shown(path)), tr("Replace it")))
    return false;
  if (DocumentTab* other = at_.tabs.withPath(path); other && other != &tab) {
    sayNotSaved(
        tab, tr("%1 is open in another tab. Close it there first, or choose another name").arg(shown(path)));
    return false;
  }
  return write(tab, path);
}

bool FileDesk::saveAll() {
  for (DocumentTab* tab : at_.tabs.all())
    if (tab->document().history().modified() && !save(*tab)) return false;
  return true;
}

bool FileDesk::close(DocumentTab& tab) {
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

bool FileDesk::closeAll() {
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

// ---- exporting

void FileDesk::exportTo(DocumentTab& tab, const QString& title, const QString& filter, const QString& ending,
                        const std::function<Result<Done>(const QString&)>& write) {
  QString path =
      at_.prompts.fileToSave(&at_.window, title, suggestedPath(tab.document(), folder(), ending), filter);
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += ending;
  const auto written = write(path);
  if (!written) {
    tab.notices().say("export", NoticeBar::Kind::trouble,
                      tr("Not exported: %1").arg(sentenceOf(written.failure())));
    return;
  }
  tab.notices().dismiss("export");
  rememberFolder(path);
  emit done(tr("Exported %1").arg(shown(path)));
}

void FileDesk::exportCsv(DocumentTab& tab) {
  const ButtonDocument& document = tab.document();
  exportTo(tab, tr("Export samples"), tr("CSV, mm and N") + " (*.csv)", ".csv", [&](const QString& path) {
    return editor::exportCsv(document.button(), document.activeState(), path);
  });
}

void FileDesk::exportSvg(DocumentTab& tab) {
  exportTo(tab, tr("Export drawing"), tr("SVG drawing") + " (*.svg)", ".svg", [&](const QString& path) {
    return editor::exportSvg(tab.document().button(), at_.view.units(), path);
  });
}

void FileDesk::exportPng(DocumentTab& tab) {
  exportTo(tab, tr("Export picture"), tr("PNG picture") + " (*.png)", ".png", [&](const QString& path) {
    return editor::exportPng(tab.workspace().renderImage(exportedPicture_px, exportedPixelRatio), path);
  });
}

void FileDesk::exportWav(DocumentTab& tab) {
  exportTo(tab, tr("Export the vibration of a press"), tr("WAV sound") + " (*.wav)", ".wav",
           [&](const QString& path) { return editor::exportWav(tab.document().button(), path); });
}

// ---- recovery, other programs

void FileDesk::offerRecovery() {
  QStringList unreadable;
  const QList<LeftBehind> left = at_.recovery.leftBehind(&unreadable);
  for (const QString& sentence : unreadable) trouble("recovery:" + sentence, sentence);
  if (!left.isEmpty()) sayLeftBehind(left);
  offerImports();
}

// What a hand corrected is on the disk within two seconds, as a document's changes are.
void FileDesk::keepDraft() {
  if (!importing_ || !importing_->isVisible()) return;
  ImportDraft draft = importing_->draft();
  if (draft.empty()) return at_.recovery.dropImport();
  if (!importing_->pastedPicture().isNull() && pastedFile_.isEmpty())
    pastedFile_ = at_.recovery.keepPicture(importing_->pastedPicture());
  draft.picture = pastedFile_;
  at_.recovery.keepImport(textOf(draft));
}

void FileDesk::offerImports() {
  for (const LeftImport& left : at_.recovery.leftImports()) {
    const auto draft = draftFrom(left.text);
    if (!draft) {
      at_.recovery.discard(left);
      continue;
    }
    const QString name = draft->path.isEmpty() ? tr("a pasted picture") : shown(draft->path);
    at_.notices.say("import:" + left.file, NoticeBar::Kind::information,
                    tr("An import was interrupted; the corrections made to %1 are kept.").arg(name),
                    {{"continueImport", tr("Continue"),
                      [this, left, draft] {
                        importingFrom_ = draft->path;
                        ImportDialog& dialog = importDialog();
                        dialog.show();
                        dialog.raise();
                        dialog.activateWindow();
                        dialog.continueDraft(*draft);
                        keepDraft();  // on the disk under this editor's name before the old one goes
                        at_.recovery.flush();
                        at_.recovery.discard(left);
                      }},
                     {"discardImport", tr("Discard"), [this, left] { at_.recovery.discard(left); }}});
  }
}

void FileDesk::sayLeftBehind(const QList<LeftBehind>& left) {
  QStringList names;
  for (const LeftBehind& one : left)
    names << tr("%1 (%2)").arg(one.record.title,
                               QLocale().toString(one.record.written.toLocalTime(), QLocale::ShortFormat));
  at_.notices.say("recovery", NoticeBar::Kind::information,
                  tr("Detent ended without closing and kept what was not saved: %1").arg(names.join(", ")),
                  {{"recover", tr("Recover"), [this, left] { recover(left); }},
                   {"discardRecovery", tr("Discard…"), [this, left] { discardLeftBehind(left); }}});
}

void FileDesk::discardLeftBehind(const QList<LeftBehind>& left) {
  if (!at_.prompts.confirm(&at_.window, tr("Throw the unsaved changes away for good?"), tr("Throw away")))
    return sayLeftBehind(left);
  for (const LeftBehind& one : left) at_.recovery.discard(one);
}

// What was recovered is on the disk under this editor's name before the old file goes.
void FileDesk::recover(const QList<LeftBehind>& left) {
  for (const LeftBehind& one : left) recoverOne(one);
  at_.recovery.flush();
  for (const LeftBehind& one : left) at_.recovery.discard(one);
}

// On top of the file as it was saved, so that undo leads back to it.
void FileDesk::recoverOne(const LeftBehind& left) {
  const RecoveryRecord& record = left.record;
  // The last session's tabs are open again before recovery is chosen.
  if (DocumentTab* open = at_.tabs.withPath(record.path); open && !open->document().history().modified()) {
    open->document().history().apply(record.button, tr("Recover unsaved changes"));
    return at_.tabs.show(open->document());
  }
  auto saved = QFileInfo::exists(record.path) ? openDocument(record.path)
                                              : Result<std::unique_ptr<ButtonDocument>>(Failure{});
  if (saved && !at_.tabs.withPath(record.path)) {
    DocumentTab& tab = at_.tabs.add(*std::move(saved));
    watch_.watch(record.path);
    tab.document().history().apply(record.button, tr("Recover unsaved changes"));
    pages_.bringBack(tab.document());
    return;
  }
  auto document = std::make_unique<ButtonDocument>(record.button);
  if (!at_.tabs.withPath(record.path)) document->setPath(record.path);
  document->history().stack().resetClean();
  pages_.bringBack(at_.tabs.add(std::move(document)).document());
}

void FileDesk::changedOutside(const QString& path) {
  DocumentTab* tab = at_.tabs.withPath(path);
  if (!tab) return;
  const bool modified = tab->document().history().modified();
  tab->notices().say(
      "disk", NoticeBar::Kind::information,
      modified ? tr("Another program changed this file, and there are unsaved changes here. Reloading can be "
                    "undone.")
               : tr("Another program changed this file."),
      {{"reload", tr("Reload"), [this, tab] { reload(*tab); }},
       {"keepMine", tr("Keep mine"), [tab] {
          tab->document().history().stack().resetClean();
          // Said and answered: the next save is not asked about the same content again.
          tab->document().setKnownContent(contentHash(tab->document().path()));
        }}});
}

void FileDesk::vanished(const QString& path) {
  DocumentTab* tab = at_.tabs.withPath(path);
  if (!tab) return;
  tab->document().history().stack().resetClean();
  tab->notices().say("disk", NoticeBar::Kind::information,
                     tr("The file of this button was deleted or moved away. Saving writes it again."));
}

}  // namespace detent::editor
