// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/recovery_file.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace detent::editor {
namespace {

constexpr int recoveryVersion = 1;

Failure broken(const QString& subject, const Message& problem) {
  return {FailureCode::unreadableInput, subject.toStdString(), "", problem,
          Message("Detent wrote this file before it ended unexpectedly; you can delete it")};
}

}  // namespace

std::string recoveryText(const RecoveryRecord& record) {
  const QJsonObject object{
      {"format", "detent-recovery"},
      {"version", recoveryVersion},
      {"path", record.path},
      {"title", record.title},
      {"known_content", QString::fromLatin1(record.knownContent.toHex())},
      {"written", record.written.toUTC().toString(Qt::ISODateWithMs)},
      {"button", QString::fromStdString(jsonFrom(record.button, record.cutout, record.annotations))}};
  return QJsonDocument(object).toJson(QJsonDocument::Indented).toStdString();
}

Result<RecoveryRecord> recoveryFromText(const std::string& text, const QString& subject) {
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text), &error);
  if (error.error != QJsonParseError::NoError)
    return broken(subject, Message("the file is not a recovery file: %1", error.errorString().toStdString()));
  const QJsonObject object = document.object();
  if (object["format"].toString() != "detent-recovery")
    return broken(subject, Message("the file is not a recovery file: its format is not detent-recovery"));
  if (object["version"].toInt() != recoveryVersion)
    return broken(subject, Message("the recovery file has version %1, but only version 1 can be read",
                                   object["version"].toInt()));
  auto file = buttonFileFromJson(object["button"].toString().toStdString(), subject.toStdString());
  if (!file) return file.failure();
  return RecoveryRecord{std::move(file->button),
                        object["path"].toString(),
                        object["title"].toString(),
                        QDateTime::fromString(object["written"].toString(), Qt::ISODateWithMs),
                        QByteArray::fromHex(object["known_content"].toString().toLatin1()),
                        std::move(file->cutout),
                        std::move(file->annotations)};
}

}  // namespace detent::editor
