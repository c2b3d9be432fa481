// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/page_return.h"

#include <algorithm>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "editor/document/message_words.h"

namespace detent::editor {
namespace {

constexpr qint64 largestSheet_bytes = qint64(1) << 30;  // what no datasheet is; hashing it would take long

QString placeKey(const Provenance& provenance) {
  return QStringLiteral("sheets/") + QString::fromStdString(provenance.sourceSha256);
}

bool isSheet(const QString& path, const std::string& sha256) {
  QFile file(path);
  QCryptographicHash hash(QCryptographicHash::Sha256);
  return QFileInfo(path).isFile() && file.size() <= largestSheet_bytes && file.open(QIODevice::ReadOnly) &&
         hash.addData(&file) && hash.result().toHex().toStdString() == sha256;
}

bool wasGiven(const Provenance& provenance, const char* option) {
  return std::any_of(provenance.given.begin(), provenance.given.end(),
                     [&](const std::string& given) { return given.rfind(option, 0) == 0; });
}

/// Where the curves were drawn or masked by hand they are not traced again, but frame and axes are: the page
/// comes back without traced points.
Result<importer::ImportReport> pageAlone(const Button& button,
                                         std::shared_ptr<const importer::GraphEvidence> evidence,
                                         const Failure& why) {
  if (!evidence) return why;
  importer::ImportReport report(button);
  report.evidence = std::move(evidence);
  return report;
}

importer::Quality qualityOf(const std::string& name) {
  if (name == "draft") return importer::Quality::draft;
  return name == "precise" ? importer::Quality::precise : importer::Quality::standard;
}

}  // namespace

importer::ImportRequest requestAgain(const Provenance& provenance) {
  importer::ImportRequest request;
  request.page = provenance.page;
  request.graph = provenance.graph;
  request.quality = qualityOf(provenance.quality);
  request.acceptDoubt = true;  // a person has accepted it once
  importer::ImportHints& hints = request.hints;
  if (wasGiven(provenance, "--frame") && provenance.frame.size() == 4)
    hints.frame = {{provenance.frame[0], provenance.frame[1]}, {provenance.frame[2], provenance.frame[3]}};
  if (wasGiven(provenance, "--x-axis") && provenance.xAxis) {
    hints.axes.xMin = provenance.xAxis->min;
    hints.axes.xMax = provenance.xAxis->max;
  }
  if (wasGiven(provenance, "--y-axis") && provenance.yAxis) {
    hints.axes.yMin = provenance.yAxis->min;
    hints.axes.yMax = provenance.yAxis->max;
  }
  if (wasGiven(provenance, "--x-unit") && provenance.xAxis)
    hints.axes.xUnit = lengthUnitFrom(provenance.xAxis->unit);
  if (wasGiven(provenance, "--y-unit") && provenance.yAxis)
    hints.axes.yUnit = forceUnitFrom(provenance.yAxis->unit);
  hints.strokes.swap = wasGiven(provenance, "--swap-strokes");
  return request;
}

PageReturn::PageReturn(QSettings& places, QObject* parent) : QObject(parent), places_(places) {
  thread_.setMaxThreadCount(1);
}

PageReturn::~PageReturn() {
  stop_ = true;
  thread_.clear();
  thread_.waitForDone();
}

void PageReturn::remember(const Provenance& provenance, const QString& path) {
  if (!provenance.sourceSha256.empty() && !path.isEmpty()) places_.setValue(placeKey(provenance), path);
}

void PageReturn::bringBack(ButtonDocument& document) {
  const auto& provenance = document.button().provenance();
  if (!provenance || provenance->sourceSha256.empty() || document.origin()) return;
  QStringList places;
  if (!document.path().isEmpty())
    places << QFileInfo(document.path()).dir().filePath(QString::fromStdString(provenance->sourceFile));
  if (const QString last = places_.value(placeKey(*provenance)).toString(); !last.isEmpty()) places << last;
  ask(document, places, false);
}

void PageReturn::bringBackFrom(ButtonDocument& document, const QString& path) { ask(document, {path}, true); }

PageReturn::Answer PageReturn::lookAndRead(const Button& button, const QStringList& places,
                                           const std::atomic<bool>& stop) {
  const Provenance& provenance = *button.provenance();
  Answer answer;
  for (const QString& place : places)
    if (answer.path.isEmpty() && !stop && isSheet(place, provenance.sourceSha256)) answer.path = place;
  if (answer.path.isEmpty() || stop) return answer;
  importer::ImportRequest request = requestAgain(provenance);
  request.path = QFile::encodeName(answer.path).toStdString();
  importer::Progress progress;
  progress.cancelled = [&stop] { return stop.load(); };
  auto session = importer::ImportSession::open(request.path);
  auto imported = session ? session->importGraph(request, progress) : session.failure();
  if (!imported) answer.failure = imported.failure();
  if (!imported && session) imported = pageAlone(button, session->evidenceOfFailure(), imported.failure());
  if (imported) answer.report = std::make_shared<const importer::ImportReport>(*std::move(imported));
  return answer;
}

void PageReturn::ask(ButtonDocument& document, const QStringList& places, bool chosen) {
  thread_.start(
      [this, guarded = QPointer<ButtonDocument>(&document), button = document.button(), places, chosen] {
        Answer answer = lookAndRead(button, places, stop_);
        if (stop_) return;
        QMetaObject::invokeMethod(
            this,
            [this, guarded, answer = std::move(answer), chosen] {
              if (guarded) take(*guarded, answer, chosen);
            },
            Qt::QueuedConnection);
      });
}

void PageReturn::take(ButtonDocument& document, const Answer& answer, bool chosen) {
  const auto& provenance = document.button().provenance();
  if (!provenance || document.origin()) return;
  const QString name = QString::fromStdString(provenance->sourceFile);
  if (answer.path.isEmpty()) {
    if (chosen)
      return emit refused(&document, tr("This is not the sheet the button was read from, %1.").arg(name));
    return emit missing(&document, name);
  }
  remember(*provenance, answer.path);
  if (!answer.report)
    return emit refused(&document, tr("%1 is there, but the graph was not read again. %2")
                                       .arg(name, answer.failure ? sentenceOf(*answer.failure) : QString()));
  document.setOrigin(answer.report);
  emit returned(&document);
}

}  // namespace detent::editor
