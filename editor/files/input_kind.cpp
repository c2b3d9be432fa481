// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/input_kind.h"

#include <algorithm>
#include <QCollator>
#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>

#include "editor/files/exports.h"

namespace detent::editor {
namespace {

const QStringList& pageEndings() {
  static const QStringList endings = {"png",  "jpg", "jpeg", "bmp", "tif", "tiff",
                                      "webp", "gif", "pdf",  "svg", "svgz"};
  return endings;
}

QString pagePatterns() {
  QStringList patterns;
  for (const QString& ending : pageEndings()) patterns << "*." + ending;
  return patterns.join(' ');
}

const char* const tablePatterns = "*.csv *.tsv *.xlsx *.ods";

Failure unreadable(const QString& path, const QString& problem, const QString& remedy) {
  return {FailureCode::unreadableInput, QDir::toNativeSeparators(path).toStdString(), "",
          problem.toStdString(), remedy.toStdString()};
}

struct InputKinds {
  Q_DECLARE_TR_FUNCTIONS(InputKinds)
};

// The first line without byte order mark, spaces and line end.
QByteArray firstLine(const QByteArray& bytes) {
  QByteArray line = bytes.left(bytes.indexOf('\n') < 0 ? bytes.size() : bytes.indexOf('\n'));
  if (line.startsWith("\xEF\xBB\xBF")) line.remove(0, 3);
  return line.trimmed();
}

// JSON that other programs wrote about a graph, as the importer reads it: projects of digitizers, a tester's
// record, a data package.
bool isForeignJson(const QByteArray& start) {
  if (start.contains("\"detent-button\"")) return false;
  for (const char* key : {"\"axesColl\"", "\"wpd\"", "\"datasetColl\"", "\"down_x\"", "\"resources\""})
    if (start.contains(key)) return true;
  return false;
}

}  // namespace

Result<InputKind> inputKindOf(const QString& path) {
  const QFileInfo info(path);
  if (!info.exists())
    return unreadable(path, InputKinds::tr("the file was not found"),
                      InputKinds::tr("Check the name; the file may have been moved or renamed"));
  if (info.isDir())
    return unreadable(path, InputKinds::tr("this is a folder, not a file"),
                      InputKinds::tr("Choose a file in this folder"));
  if (!info.isFile())  // a pipe would wait for its writer
    return unreadable(path, InputKinds::tr("this is not an ordinary file"),
                      InputKinds::tr("Save the content to an ordinary file and open that file"));
  const QString ending = info.suffix().toLower();
  if (ending == "png" && !QImageReader(path).text(buttonInPicture).isEmpty()) return InputKind::button;
  if (pageEndings().contains(ending)) return InputKind::page;

  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    return unreadable(path, InputKinds::tr("the file cannot be opened: %1").arg(file.errorString()),
                      InputKinds::tr("Check the permissions of the file"));
  const QByteArray start = file.read(4096);
  if (firstLine(start) == "stroke,displacement_mm,force_N") return InputKind::curveCsv;
  if (ending == "json" || start.trimmed().startsWith('{'))
    return isForeignJson(start) ? InputKind::page : InputKind::button;
  return InputKind::page;
}

QStringList importFilters() {
  return {InputKinds::tr("Datasheets, pictures and force meters' logs") + " (" + pagePatterns() + " " +
              tablePatterns + " *.tar *.wpd.json)",
          InputKinds::tr("All files") + " (*)"};
}

QStringList openFilters() {
  const QString buttons = "*.button.json *.json", csv = "*.csv", recorded = "*.tsv *.xlsx *.ods *.tar";
  return {InputKinds::tr("All supported files") + " (" + buttons + " " + csv + " " + recorded + " " +
              pagePatterns() + ")",
          InputKinds::tr("Buttons") + " (" + buttons + ")",
          InputKinds::tr("Datasheets and pictures") + " (" + pagePatterns() + ")",
          InputKinds::tr("Force-displacement CSV") + " (" + csv + ")", InputKinds::tr("All files") + " (*)"};
}

QStringList sheetsBelow(const QString& folder) {
  const QStringList patterns = (pagePatterns() + ' ' + tablePatterns).split(' ');
  QStringList paths;
  for (QDirIterator each(folder, patterns, QDir::Files, QDirIterator::Subdirectories); each.hasNext();)
    paths << each.next();
  QCollator order{QLocale(QLocale::English)};  // the C locale cannot sort numbers
  order.setNumericMode(true);
  std::sort(paths.begin(), paths.end(), order);
  return paths;
}

}  // namespace detent::editor
