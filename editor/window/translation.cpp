// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/translation.h"

#include <QFile>
#include <QLibraryInfo>
#include <QTranslator>

namespace detent::editor {
namespace {

/// lupdate stores texts under the class or namespace of the calling function. A function outside of a QObject
/// requests them under another name. So a text that is missing under its name is searched under the others.
class Translator : public QTranslator {
 public:
  Translator(const QStringList& contexts, QObject* parent) : QTranslator(parent) {
    for (const QString& context : contexts) contexts_ << context.toUtf8();
  }
  QString translate(const char* context, const char* source, const char* disambiguation,
                    int n) const override {
    QString text = QTranslator::translate(context, source, disambiguation, n);
    for (auto other = contexts_.begin(); text.isNull() && other != contexts_.end(); ++other)
      text = QTranslator::translate(*other, source, disambiguation, n);
    return text;
  }

 private:
  QByteArrayList contexts_;
};

QStringList linesOf(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
}

}  // namespace

QLocale chosenLocale(const QSettings& settings, const QString& folder) {
  const QString code = settings.value(languageKey).toString();
  const bool carried =
      code == QLatin1String("en") || QFile::exists(QStringLiteral("%1/detent_%2.qm").arg(folder, code));
  return carried ? QLocale(code) : QLocale();
}

bool installTranslation(QCoreApplication& application, const QLocale& locale, const QString& folder) {
  auto* own = new Translator(linesOf(folder + QStringLiteral("/contexts.txt")), &application);
  if (!own->load(locale, QStringLiteral("detent"), QStringLiteral("_"), folder)) {
    delete own;
    return false;  // Qt's texts in another language than ours would be a mixture
  }
  auto* qt = new QTranslator(&application);
  if (qt->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
               QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(qt);
  QCoreApplication::installTranslator(own);
  return true;
}

}  // namespace detent::editor
