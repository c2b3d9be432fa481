// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/recovery_store.h"

#include <algorithm>
#include <QDir>
#include <QUuid>

#include "editor/document/message_words.h"
#include "editor/files/input_kind.h"
#include "editor/files/native_path.h"
#include "model/file/text_file.h"

namespace detent::editor {
namespace {

const QString ending = QStringLiteral(".recovery.json");
const QString importFile = QStringLiteral("import.draft.json");
const QString importPicture = QStringLiteral("import.draft.png");

std::unique_ptr<QLockFile> lockOf(const QString& sessionFolder) {
  auto lock = std::make_unique<QLockFile>(sessionFolder + ".lock");
  // a lock is stale only if its process has ended, however long an editor stays open
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

RecoveryStore::RecoveryStore(QString folder, QObject* parent)
    : QObject(parent),
      folder_(std::move(folder)),
      session_(QDir(folder_).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces))) {
  writer_.setMaxThreadCount(1);
}

RecoveryStore::~RecoveryStore() {
  writer_.waitForDone();
  if (!lock_) return;
  QDir().rmdir(session_);  // removes the folder only if it is empty
  lock_->unlock();
}

// Lock first, folder second: a folder without a lock belongs to a dead editor.
bool RecoveryStore::openSession() {
  if (lock_) return true;
  QDir().mkpath(folder_);
  auto lock = lockOf(session_);
  if (!lock->tryLock(0) || !QDir().mkpath(session_)) return false;
  lock_ = std::move(lock);
  return true;
}

void RecoveryStore::watch(ButtonDocument& document) {
  if (watched_.contains(&document)) return;
  auto entry = std::make_shared<Watched>();
  entry->timer = std::make_unique<QTimer>();
  entry->timer->setSingleShot(true);
  entry->timer->setInterval(writeAfter_ms);
  watched_.insert(&document, entry);
  connect(entry->timer.get(), &QTimer::timeout, this, [this, &document] { write(document); });
  for (const auto change :
       {&ButtonDocument::titleChanged, &ButtonDocument::cutoutChanged, &ButtonDocument::annotationsChanged})
    connect(&document, change, this, [this, &document] { documentChanged(document); });
  documentChanged(document);
}

// Starts the document's timer. Further changes do not restart it, so that it also fires during a long drag.
void RecoveryStore::documentChanged(ButtonDocument& document) {
  const auto entry = watched_.value(&document);
  if (!entry) return;
  if (!document.history().modified()) {
    entry->timer->stop();
    removeFile(*entry);
  } else if (!entry->timer->isActive()) {
    entry->timer->start();
  }
}

void RecoveryStore::write(ButtonDocument& document) {
  const auto entry = watched_.value(&document);
  if (!entry || !document.history().modified()) return;
  if (!openSession()) {
    report(tr("Autosave is off: the folder %1 cannot be written. Save manually.")
               .arg(QDir::toNativeSeparators(folder_)));
    return;
  }
  if (entry->file.isEmpty()) entry->file = QDir(session_).filePath(QString::number(nextFile_++) + ending);
  entry->onDisk = true;
  const RecoveryRecord record{document.history().committed(),  document.path(),         document.title(),
                              QDateTime::currentDateTimeUtc(), document.knownContent(), document.cutout(),
                              document.annotations()};
  writer_.start([this, record, file = entry->file] {
    const auto written = writeTextFileAtomically(nativePath(file), recoveryText(record));
    const QString sentence = written ? QString() : sentenceOf(written.failure());
    QMetaObject::invokeMethod(
        this, [this, sentence] { report(sentence); }, Qt::QueuedConnection);
  });
}

void RecoveryStore::report(const QString& sentence) {
  if (sentence.isEmpty())
    failing_ = false;
  else if (!std::exchange(failing_, true))
    emit failed(sentence);
}

// Removed on the writer's thread, so that an earlier write cannot create the file again.
void RecoveryStore::removeFile(Watched& watched) {
  if (!std::exchange(watched.onDisk, false)) return;
  writer_.start([file = watched.file] { QFile::remove(file); });
}

void RecoveryStore::forget(ButtonDocument& document) {
  const auto entry = watched_.take(&document);
  if (!entry) return;
  document.disconnect(this);
  removeFile(*entry);
}

void RecoveryStore::flush() {
  for (auto it = watched_.begin(); it != watched_.end(); ++it) {
    if (!it.value()->timer->isActive()) continue;
    it.value()->timer->stop();
    write(*it.key());
  }
  writer_.waitForDone();
}

QList<LeftBehind> RecoveryStore::leftBehind(QStringList* unreadable) {
  QList<LeftBehind> all;
  leftImports_.clear();
  const QStringList sessions = QDir(folder_).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
  for (const QString& name : sessions) {
    const QString session = QDir(folder_).filePath(name);
    if (session == session_) continue;
    auto lock = lockOf(session);
    if (!lock->tryLock(0)) continue;  // the editor of this folder is running
    const QStringList files = QDir(session).entryList({"*" + ending}, QDir::Files);
    for (const QString& fileName : files) {
      const QString file = QDir(session).filePath(fileName);
      const auto text = readTextFile(nativePath(file));
      auto record = text ? recoveryFromText(*text, file) : Result<RecoveryRecord>(text.failure());
      if (record)
        all.append({file, *std::move(record)});
      else if (unreadable)
        unreadable->append(sentenceOf(record.failure()));
    }
    QFile import(QDir(session).filePath(importFile));
    const bool hasImport = import.open(QIODevice::ReadOnly);
    if (hasImport) leftImports_.append({import.fileName(), import.readAll()});
    if (files.isEmpty() && !hasImport) QDir(session).removeRecursively();
    if (files.isEmpty() && !hasImport)
      lock->unlock();
    else
      reserved_.push_back(std::move(lock));
  }
  std::sort(all.begin(), all.end(),
            [](const LeftBehind& a, const LeftBehind& b) { return a.record.written > b.record.written; });
  return all;
}

QString RecoveryStore::keepPicture(const QImage& picture) {
  if (picture.isNull() || !openSession()) return {};
  QString file = QDir(session_).filePath(importPicture);
  writer_.start([file, picture] { picture.save(file); });
  return file;
}

void RecoveryStore::keepImport(const QByteArray& text) {
  if (!openSession()) return;
  writer_.start([file = nativePath(QDir(session_).filePath(importFile)), text] {
    (void)writeTextFileAtomically(file, text.toStdString());  // write() reports a failing disk, once
  });
}

void RecoveryStore::dropImport() {
  if (!lock_) return;
  writer_.start([session = session_] {
    QFile::remove(QDir(session).filePath(importFile));
    QFile::remove(QDir(session).filePath(importPicture));
  });
}

void RecoveryStore::discard(const LeftImport& left) {
  const QDir session = QFileInfo(left.file).dir();
  QFile::remove(left.file);
  QFile::remove(session.filePath(importPicture));
  QDir().rmdir(session.path());
}

void RecoveryStore::discard(const LeftBehind& left) {
  QFile::remove(left.file);
  const QString session = QFileInfo(left.file).absolutePath();
  QDir().rmdir(session);  // the folder's lock is released later, with the reservation
}

}  // namespace detent::editor
