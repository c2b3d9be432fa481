// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One unsaved document on the disk, so that a killed editor loses nothing that is older than a few seconds.

#include <QDateTime>
#include <QString>

#include "model/file/button_file.h"

namespace detent::editor {

/// Contents of a recovery file. `path` is empty for a document that was never saved.
struct RecoveryRecord {
  Button button;
  QString path;
  QString title;
  QDateTime written;  ///< UTC
  /// ButtonDocument::knownContent(), so that the guard against writing over somebody's change outlives the
  /// editor.
  QByteArray knownContent = {};
  std::optional<PageCutout> cutout = {};
  Annotations annotations = {};
};

/// One JSON object: format, version, path, title, time, and the text of the button file.
std::string recoveryText(const RecoveryRecord& record);
/// Failure unreadableInput names what is wrong with it; newer versions are refused.
Result<RecoveryRecord> recoveryFromText(const std::string& text, const QString& subject);

}  // namespace detent::editor
