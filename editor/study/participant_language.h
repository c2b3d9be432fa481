// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The participant's language, independent of the editor's.

#include <QStringList>
#include <QTranslator>

namespace detent::editor {

/// Texts of one class in one language. GUI thread.
class ParticipantLanguage {
 public:
  /// `code`: "en", "de". English if the program has no texts in this language.
  explicit ParticipantLanguage(const QString& code);
  const QString& code() const { return code_; }
  QString words(const char* text) const;

  /// Codes of the available languages, English first.
  static QStringList carried();

 private:
  QString code_;
  QTranslator texts_;
};

}  // namespace detent::editor
