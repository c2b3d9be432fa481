// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/translation.h"

#include <QLibraryInfo>
#include <QTranslator>

namespace detent::editor {
namespace {

/// lupdate files texts of functions that belong to no class under their namespace, whatever context they ask
/// with: those of the editor, and the patterns of messages of importer and model.
class Translator : public QTranslator {
 public:
  using QTranslator::QTranslator;
  QString translate(const char* context, const char* source, const char* disambiguation,
                    int n) const override {
    QString text = QTranslator::translate(context, source, disambiguation, n);
    for (const char* space : {"detent::editor", "detent::importer", "detent"})
      if (text.isNull()) text = QTranslator::translate(space, source, disambiguation, n);
    return text;
  }
};

}  // namespace

bool installTranslation(QCoreApplication& application, const QLocale& locale, const QString& folder) {
  auto* own = new Translator(&application);
  if (!own->load(locale, QStringLiteral("detent"), QStringLiteral("_"), folder)) {
    delete own;
    return false;  // Qt's texts in another language than ours would be half a translation
  }
  auto* qt = new QTranslator(&application);
  if (qt->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
               QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    application.installTranslator(qt);
  application.installTranslator(own);
  return true;
}

}  // namespace detent::editor
