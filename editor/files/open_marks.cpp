// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/open_marks.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>

namespace detent::editor {
namespace {

// Links and names of one file give one mark.
QString realPath(const QString& path) {
  const QString real = QFileInfo(path).canonicalFilePath();
  return real.isEmpty() ? path : real;
}

QString lockName(const QString& path) {
  const QByteArray name = QCryptographicHash::hash(realPath(path).toUtf8(), QCryptographicHash::Sha1).toHex();
  return QString::fromLatin1(name) + QStringLiteral(".lock");
}

}  // namespace

OpenMarks::OpenMarks(QString folder, QObject* parent) : QObject(parent), folder_(std::move(folder)) {
  again_.setInterval(tryAgain_ms);
  connect(&again_, &QTimer::timeout, this, [this] {
    bool waiting = false;
    for (auto& [document, mark] : marks_) {
      if (mark.other) take(*document, mark);
      waiting = waiting || mark.other;
    }
    if (!waiting) again_.stop();
  });
}

OpenMarks::~OpenMarks() = default;

void OpenMarks::watch(ButtonDocument& document) {
  connect(&document, &ButtonDocument::titleChanged, this, [this, &document] { follow(document); });
  follow(document);
}

void OpenMarks::forget(ButtonDocument& document) {
  document.disconnect(this);
  marks_.erase(&document);
}

std::optional<qint64> OpenMarks::otherEditor(const ButtonDocument& document) const {
  for (const auto& [marked, mark] : marks_)
    if (marked == &document) return mark.other;
  return {};
}

void OpenMarks::follow(ButtonDocument& document) {
  Mark& mark = marks_[&document];
  if (mark.path == document.path()) return;
  mark.path = document.path();
  mark.lock.reset();
  take(document, mark);
}

void OpenMarks::take(ButtonDocument& document, Mark& mark) {
  const std::optional<qint64> before = mark.other;
  mark.other.reset();
  if (!mark.path.isEmpty() && QDir().mkpath(folder_)) {
    auto lock = std::make_unique<QLockFile>(QDir(folder_).filePath(lockName(mark.path)));
    lock->setStaleLockTime(0);  // a lock is stale only if its process has ended
    if (lock->tryLock(0)) {
      mark.lock = std::move(lock);
    } else {
      qint64 process = 0;
      QString host, program;
      // A folder that cannot be written to gives no marks, and blocks nobody.
      if (lock->getLockInfo(&process, &host, &program)) mark.other = process;
    }
  }
  if (mark.other) again_.start();
  if (mark.other.has_value() != before.has_value()) emit otherEditorChanged(&document);
}

}  // namespace detent::editor
