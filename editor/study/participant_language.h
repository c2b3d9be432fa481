// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The language a participant reads, whatever the editor's is.

#include <QStringList>
#include <QTranslator>

namespace detent::editor {

/// Texts of one class in one language. GUI thread.
class ParticipantLanguage {
 public:
  /// "en", "de"; English where the program carries no such texts.
  explicit ParticipantLanguage(const QString& code);
  const QString& code() const { return code_; }
  QString words(const char* text) const;

  /// Codes that the program carries, English first.
  static QStringList carried();

 private:
  QString code_;
  QTranslator texts_;
};

}  // namespace detent::editor
