// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/recovery_controller.h"

#include <QLocale>

#include "editor/files/document_files.h"

namespace detent::editor {

RecoveryController::RecoveryController(const ControllerContext& context, QObject* parent)
    : QObject(parent), at_(context) {}

void RecoveryController::offer() {
  QStringList unreadable;
  const QList<LeftBehind> left = at_.recovery.leftBehind(&unreadable);
  for (const QString& sentence : unreadable)
    at_.notices.say("recovery:" + sentence, NoticeBar::Kind::trouble, sentence);
  if (!left.isEmpty()) say(left);
}

void RecoveryController::say(const QList<LeftBehind>& left) {
  QStringList names;
  for (const LeftBehind& one : left)
    names << tr("%1 (%2)").arg(one.record.title,
                               QLocale().toString(one.record.written.toLocalTime(), QLocale::ShortFormat));
  at_.notices.say("recovery", NoticeBar::Kind::information,
                  tr("Detent ended unexpectedly and kept unsaved changes: %1").arg(names.join(", ")),
                  {{"recover", tr("Recover"), [this, left] { recover(left); }},
                   {"discardRecovery", tr("Discard…"), [this, left] { discard(left); }}});
}

void RecoveryController::discard(const QList<LeftBehind>& left) {
  if (!at_.prompts.confirm(&at_.window, tr("Discard the unsaved changes permanently?"), tr("Discard")))
    return say(left);
  for (const LeftBehind& one : left) at_.recovery.discard(one);
}

// Stores each document under this editor's name before the old file is deleted.
void RecoveryController::recover(const QList<LeftBehind>& left) {
  for (const LeftBehind& one : left) emit recovered(&recoverOne(one.record));
  at_.recovery.flush();
  for (const LeftBehind& one : left) at_.recovery.discard(one);
}

// The recovered changes do not belong to a file that another program has written since, so saving it asks
// first.
void RecoveryController::recoverInto(ButtonDocument& document, const RecoveryRecord& record) {
  document.history().replace(record.button, tr("Recover unsaved changes"));
  if (record.cutout != document.cutout()) {
    document.setCutout(record.cutout);
    // the cut-out may be the only unsaved change, and it is no undo step
    document.history().stack().resetClean();
  }
  document.annotate(record.annotations, tr("Recover unsaved changes"));
  if (!record.knownContent.isEmpty()) document.setKnownContent(record.knownContent);
}

// Opens the saved file first, so that undo leads back to it.
DocumentTab& RecoveryController::recoverOne(const RecoveryRecord& record) {
  DocumentTab* open = at_.tabs.withPath(record.path);
  // the tabs of the last session are open again at this time
  if (open && !open->document().history().modified()) {
    recoverInto(open->document(), record);
    at_.tabs.show(open->document());
    return *open;
  }
  if (!open && QFileInfo::exists(record.path)) {
    if (auto saved = openDocument(record.path)) {
      DocumentTab& tab = at_.tabs.add(*std::move(saved));
      recoverInto(tab.document(), record);
      return tab;
    }
  }
  auto document = std::make_unique<ButtonDocument>(record.button);
  document->setCutout(record.cutout);
  document->setAnnotations(record.annotations);
  if (!open) document->setPath(record.path);
  document->history().stack().resetClean();
  return at_.tabs.add(std::move(document));
}

}  // namespace detent::editor
