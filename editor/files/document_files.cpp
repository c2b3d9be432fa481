// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/files/document_files.h"

#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <QRegularExpression>

#include "editor/files/exports.h"
#include "editor/files/file_watch.h"
#include "editor/files/input_kind.h"
#include "editor/files/native_path.h"
#include "model/file/button_file.h"
#include "model/file/curve_csv.h"
#include "model/file/text_file.h"

namespace detent::editor {
namespace {

// Paths are bytes to the model, UTF-8 by this program's locale.
Result<Button> buttonFromCsv(const QString& path) {
  auto text = readTextFile(nativePath(path));
  if (!text) return text.failure();
  auto graph = graphFromCsv(*text, nativePath(path));
  if (!graph) return graph.failure();
  return Button::fromStates(QFileInfo(path).completeBaseName().toStdString(),
                            {ButtonState{"", *std::move(graph), {}, {}, {}}});
}

}  // namespace

Result<std::unique_ptr<ButtonDocument>> openDocument(const QString& path) {
  const auto kind = inputKindOf(path);
  if (!kind) return kind.failure();
  if (*kind == InputKind::page)
    return Failure{FailureCode::wrongUsage, path.toStdString(), "",
                   Message("this file is a page to import, not a button"),
                   Message("Import the file with File > Import a datasheet")};
  if (*kind == InputKind::curveCsv) {
    auto button = buttonFromCsv(path);
    if (!button) return button.failure();
    return std::make_unique<ButtonDocument>(*std::move(button));
  }
  if (QFileInfo(path).suffix().toLower() == "png")
    return documentFromText(QImageReader(path).text(buttonInPicture), path);
  const QByteArray hash = contentHash(path);
  auto file = readWholeButtonFile(nativePath(path));
  if (!file) return file.failure();
  auto document = std::make_unique<ButtonDocument>(std::move(file->button));
  document->setCutout(std::move(file->cutout));
  document->setAnnotations(std::move(file->annotations));
  document->setPath(QFileInfo(path).absoluteFilePath());
  document->setKnownContent(hash);
  return document;
}

std::unique_ptr<ButtonDocument> importedDocument(std::shared_ptr<const importer::ImportReport> report) {
  auto document = std::make_unique<ButtonDocument>(report->button);
  document->setOrigin(std::move(report));
  document->history().stack().resetClean();
  return document;
}

Result<Done> saveDocument(ButtonDocument& document, const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  const std::string text =
      jsonFrom(document.history().committed(), document.cutout(), document.annotations());
  if (auto written = writeTextFileAtomically(nativePath(absolute), text); !written) return written.failure();
  // The hash of the text written above, not of the file: another program may have changed the file since.
  document.setKnownContent(contentHash(QByteArray::fromStdString(text)));
  document.setPath(absolute);
  document.history().markSaved();
  return Done{};
}

DiskState diskStateOf(const ButtonDocument& document) {
  const QByteArray now = contentHash(document.path());
  if (now == document.knownContent()) return DiskState::asKnown;
  return now.isEmpty() ? DiskState::gone : DiskState::changed;
}

Result<Done> reloadDocument(ButtonDocument& document) {
  // Taken before the file is read, so that a change by another program in between is noticed later.
  const QByteArray hash = contentHash(document.path());
  auto file = readWholeButtonFile(nativePath(document.path()));
  if (!file) return file.failure();
  document.setKnownContent(hash);
  document.setCutout(std::move(file->cutout));
  if (document.history().dragging()) document.history().cancelDrag();
  document.annotate(std::move(file->annotations), ButtonDocument::tr("Reload from disk"));
  document.history().replace(file->button, ButtonDocument::tr("Reload from disk"));
  document.history().markSaved();
  return Done{};
}

QString buttonText(const Button& button) { return QString::fromStdString(jsonFrom(button)); }

Result<std::unique_ptr<ButtonDocument>> documentFromText(const QString& text, const QString& source) {
  auto button = buttonFromJson(text.toStdString(), source.toStdString());
  if (!button) return button.failure();
  auto document = std::make_unique<ButtonDocument>(*std::move(button));
  document->history().stack().resetClean();
  return document;
}

QString withButtonEnding(const QString& path) {
  if (path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) return path;
  if (path.endsWith(QLatin1String(".button"), Qt::CaseInsensitive)) return path + ".json";
  return path + ".button.json";
}

QString suggestedPath(const ButtonDocument& document, const QString& folder, const QString& ending) {
  static const QRegularExpression unsafe(QStringLiteral(R"([/\\:*?"<>|\x00-\x1f])"));
  QString name = document.title();
  name.replace(unsafe, QStringLiteral("-"));
  while (name.startsWith('.')) name.remove(0, 1);
  if (name.isEmpty()) name = QStringLiteral("button");
  name.truncate(120);
  // The path is proposed beside the button's own file, because the last folder may be that of a page.
  const QDir place = document.path().isEmpty() ? QDir(folder) : QFileInfo(document.path()).dir();
  QString path = place.filePath(name + ending);
  for (int n = 2; QFileInfo::exists(path); ++n)
    path = place.filePath(name + QLatin1Char(' ') + QString::number(n) + ending);
  return path;
}

}  // namespace detent::editor
