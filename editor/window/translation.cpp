#include "editor/window/translation.h"

#include <QLibraryInfo>
#include <QTranslator>

namespace detent::editor {

bool installTranslation(QCoreApplication& application, const QLocale& locale, const QString& folder) {
  auto* own = new QTranslator(&application);
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
