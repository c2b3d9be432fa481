// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/sheet_controller.h"

#include <QLocale>

#include "editor/document/form_widgets.h"
#include "editor/document/kept_page.h"
#include "editor/files/document_files.h"
#include "editor/files/input_kind.h"
#include "editor/importing/import_dialog.h"

namespace detent::editor {

SheetController::SheetController(const ControllerContext& context, QObject* parent)
    : QObject(parent), at_(context), pages_(context.settings) {
  connectPages();
  draftSoon_.setSingleShot(true);
  draftSoon_.setInterval(RecoveryStore::writeAfter_ms);
  connect(&draftSoon_, &QTimer::timeout, this, &SheetController::keepDraft);
}

SheetController::~SheetController() { delete importing_; }

// ---- importing

void SheetController::importFiles(const QStringList& paths) {
  for (const QString& path : paths) {
    waiting_.emplace_back();
    waiting_.back().path = path;
  }
  startNext();
}

void SheetController::importGraph(const QString& path, GraphId graph) {
  waiting_.emplace_back();
  waiting_.back().path = path;
  if (graph.page > 0) waiting_.back().current = graph;
  startNext();
}

void SheetController::startNext() {
  if (waiting_.empty() || (importing_ && importing_->isVisible())) return;
  const ImportDraft next = waiting_.front();
  waiting_.pop_front();
  shownDialog().continueDraft(next);
}

void SheetController::importPicture(const QImage& picture) { shownDialog().openPicture(picture); }

ImportDialog& SheetController::shownDialog() {
  ImportDialog& shown = dialog();
  bringUp(shown);
  return shown;
}

// A new dialogue for each import, so that closing one frees the memory of its pages.
ImportDialog& SheetController::dialog() {
  if (importing_ && importing_->isVisible()) return *importing_;
  delete importing_;
  importing_ = new ImportDialog(at_.view, &at_.window);
  connect(importing_, &ImportDialog::imported, this, &SheetController::addImported);
  connect(importing_, &ImportDialog::opened, this, &SheetController::opened);
  connect(importing_, &ImportDialog::unreadable, this, &SheetController::unreadable);
  connect(importing_, &ImportDialog::draftChanged, this, [this] {
    if (!draftSoon_.isActive()) draftSoon_.start();
  });
  connect(importing_, &QDialog::finished, this, [this] {
    draftSoon_.stop();
    pastedFile_.clear();
    at_.recovery.dropImport();
  });
  importing_->setLeaveQuestion([this] {
    return at_.prompts.confirm(importing_, tr("Discard the corrections of this datasheet?"), tr("Discard"));
  });
  connect(importing_, &QDialog::accepted, &at_.window, &QWidget::activateWindow);
  connect(importing_, &QDialog::finished, this, &SheetController::startNext, Qt::QueuedConnection);
  return *importing_;
}

void SheetController::addImported(std::shared_ptr<const importer::ImportReport> report) {
  const auto& provenance = report->button.provenance();
  const QString path = importing_ ? importing_->draft().path : QString();
  if (provenance && importing_) pages_.remember(*provenance, path);
  emit imported(path, *report);
  at_.tabs.add(importedDocument(std::move(report)));
  at_.recovery.flush();  // saved at once, because an import may have cost an hour of work
}

void SheetController::openImported(const QString& path, const Button& button) {
  if (button.provenance()) pages_.remember(*button.provenance(), path);
  auto document = std::make_unique<ButtonDocument>(button);
  document->history().stack().resetClean();
  bringPageBack(at_.tabs.add(std::move(document)).document());
}

// ---- corrections by hand

// Stores the draft within two seconds, like changes of a document.
void SheetController::keepDraft() {
  if (!importing_ || !importing_->isVisible()) return;
  ImportDraft draft = importing_->draft();
  if (draft.empty()) return at_.recovery.dropImport();
  if (!importing_->pastedPicture().isNull() && pastedFile_.isEmpty())
    pastedFile_ = at_.recovery.keepPicture(importing_->pastedPicture());
  draft.picture = pastedFile_;
  at_.recovery.keepImport(textOf(draft));
}

void SheetController::offerInterrupted() {
  for (const LeftImport& left : at_.recovery.leftImports()) {
    const auto draft = draftFrom(left.text);
    if (!draft) {
      at_.recovery.discard(left);
      continue;
    }
    const QString name = draft->path.isEmpty() ? tr("a pasted picture") : shownPath(draft->path);
    at_.notices.say("import:" + left.file, NoticeBar::Kind::information,
                    tr("An import was interrupted; the corrections made to %1 are kept.").arg(name),
                    {{"continueImport", tr("Continue"),
                      [this, left, draft] {
                        shownDialog().continueDraft(*draft);
                        keepDraft();  // stored under this editor's name before the old draft is deleted
                        at_.recovery.flush();
                        at_.recovery.discard(left);
                      }},
                     {"discardImport", tr("Discard"), [this, left] { at_.recovery.discard(left); }}});
  }
}

// ---- pages that come back

void SheetController::attend(ButtonDocument& document) { pages_.attend(document); }

void SheetController::bringPageBack(ButtonDocument& document) { pages_.bringBack(document); }

void SheetController::keepPage(ButtonDocument& document, bool keep) {
  const auto page = document.page();
  if (keep && !page) return;
  auto cutout = keep ? cutoutOf(*page) : std::nullopt;
  if (keep && !cutout) return emit done(tr("This page is too large to be kept in a button's file."));
  if (cutout)
    emit done(tr("The page will be saved with the button; the file grows by %1.")
                  .arg(QLocale().formattedDataSize(static_cast<qint64>(cutout->png.size() * 4 / 3))));
  document.setCutout(std::move(cutout));
  document.history().stack().resetClean();
}

NoticeBar::Choice SheetController::findSheetChoice(ButtonDocument& document) {
  return {"findSheet", tr("Find datasheet…"), [this, known = QPointer<ButtonDocument>(&document)] {
            const QStringList chosen =
                at_.prompts.filesToOpen(&at_.window, tr("Find datasheet"), at_.folder(), importFilters());
            if (known && !chosen.isEmpty()) pages_.bringBackFrom(*known, chosen.front());
          }};
}

void SheetController::connectPages() {
  const auto say = [this](ButtonDocument* document, NoticeBar::Kind kind, const QString& sentence) {
    if (DocumentTab* tab = at_.tabs.tabOf(document))
      tab->notices().say("page", kind, sentence, {findSheetChoice(*document)});
  };
  connect(&pages_, &PageReturn::returned, this, [this](ButtonDocument* document) {
    if (DocumentTab* tab = at_.tabs.tabOf(document)) tab->notices().dismiss("page");
    emit done(tr("Datasheet page of %1 restored.").arg(document->title()));
  });
  connect(&pages_, &PageReturn::missing, this, [say](ButtonDocument* document, const QString& name) {
    QString sentence = tr("The datasheet %1, from which this button was read, is neither next to the file of "
                          "the button nor at its last location.")
                           .arg(name);
    if (document->sheet()) sentence += ' ' + tr("The page shown is the one kept in the button's file.");
    say(document, NoticeBar::Kind::information, sentence);
  });
  connect(&pages_, &PageReturn::refused, this, [say](ButtonDocument* document, const QString& sentence) {
    say(document, NoticeBar::Kind::trouble, sentence);
  });
}

}  // namespace detent::editor
