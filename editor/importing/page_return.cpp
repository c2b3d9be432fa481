// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/page_return.h"

#include <algorithm>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "editor/document/kept_page.h"
#include "editor/document/message_words.h"

namespace detent::editor {
namespace {

constexpr qint64 largestSheet_bytes = qint64(1) << 30;  // no datasheet is larger; hashing would take long

QString placeKey(const Provenance& provenance) {
  return QStringLiteral("sheets/") + QString::fromStdString(provenance.sourceSha256);
}

bool isSheet(const QString& path, const std::string& sha256) {
  QFile file(path);
  QCryptographicHash hash(QCryptographicHash::Sha256);
  return QFileInfo(path).isFile() && file.size() <= largestSheet_bytes && file.open(QIODevice::ReadOnly) &&
         hash.addData(&file) && hash.result().toHex().toStdString() == sha256;
}

/// The value given with an option, empty for a switch; nothing if it was not given.
std::optional<std::string> given(const Provenance& provenance, const std::string& option) {
  for (const std::string& each : provenance.given) {
    if (each == option) return std::string();
    if (each.starts_with(option + ' ')) return each.substr(option.size() + 1);
  }
  return {};
}

/// Imports frame and axes only: curves that were drawn or masked by hand cannot be traced again, so the page
/// has no traced points.
Result<importer::ImportReport> pageAlone(const Button& button,
                                         std::shared_ptr<const importer::GraphEvidence> evidence,
                                         const Failure& why) {
  if (!evidence) return why;
  importer::ImportReport report(button);
  report.evidence = std::move(evidence);
  return report;
}

QString notReadAgain(const Button& button, const std::optional<Failure>& why) {
  return PageReturn::tr("%1 was found, but the graph could not be read again. %2")
      .arg(QString::fromStdString(button.provenance()->sourceFile), why ? sentenceOf(*why) : QString());
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
  request.acceptDoubt = true;  // a user accepted this import before
  importer::ImportHints& hints = request.hints;
  if (given(provenance, "--frame") && provenance.frame.size() == 4)
    hints.frame = {{provenance.frame[0], provenance.frame[1]}, {provenance.frame[2], provenance.frame[3]}};
  if (given(provenance, "--x-axis") && provenance.xAxis) {
    hints.axes.xMin = provenance.xAxis->min;
    hints.axes.xMax = provenance.xAxis->max;
  }
  if (given(provenance, "--y-axis") && provenance.yAxis) {
    hints.axes.yMin = provenance.yAxis->min;
    hints.axes.yMax = provenance.yAxis->max;
  }
  if (given(provenance, "--x-unit") && provenance.xAxis)
    hints.axes.xUnit = lengthUnitFrom(provenance.xAxis->unit);
  if (given(provenance, "--y-unit") && provenance.yAxis)
    hints.axes.yUnit = forceUnitFrom(provenance.yAxis->unit);
  hints.strokes.swap = given(provenance, "--swap-strokes").has_value();
  hints.strokes.noRelease = given(provenance, "--no-release").has_value();
  hints.strokes.curve = given(provenance, "--curve").value_or("");
  return request;
}

PageReturn::PageReturn(QSettings& folders, QObject* parent) : QObject(parent), places_(folders) {
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

QString PageReturn::lastPlaceOf(const Button& button) const {
  return places_.value(placeKey(*button.provenance())).toString();
}

void PageReturn::bringBack(ButtonDocument& document) {
  const auto& provenance = document.button().provenance();
  if (document.origin() || document.sheet()) return;
  if (!provenance || provenance->sourceSha256.empty()) return showKept(document);
  QStringList folders;
  if (!document.path().isEmpty())
    folders << QFileInfo(document.path()).dir().filePath(QString::fromStdString(provenance->sourceFile));
  if (const QString last = lastPlaceOf(document.button()); !last.isEmpty()) folders << last;
  ask(document, folders, false);
}

void PageReturn::bringBackFrom(ButtonDocument& document, const QString& path) { ask(document, {path}, true); }

void PageReturn::readAgain(const Button& button, Answer& answer, const importer::Progress& progress) {
  importer::ImportRequest request = requestAgain(*button.provenance());
  request.path = QFile::encodeName(answer.path).toStdString();
  auto session = importer::ImportSession::open(request.path);
  importer::ImportAttempt attempt =
      session ? session->attempt(request, progress) : importer::ImportAttempt{session.failure(), {}};
  Result<importer::ImportReport>& imported = attempt.report;
  if (!imported) {
    answer.failure = imported.failure();
    imported = pageAlone(button, attempt.evidence, *answer.failure);
  }
  if (imported) answer.report = std::make_shared<const importer::ImportReport>(*std::move(imported));
}

PageReturn::Answer PageReturn::findAndRead(const Button& button, const QStringList& folders, bool traced,
                                           const std::atomic<bool>& stop) {
  Answer answer;
  importer::Progress progress;
  progress.cancelled = [&stop] { return stop.load(); };
  for (const QString& place : folders)
    if (answer.path.isEmpty() && !stop && isSheet(place, button.provenance()->sourceSha256))
      answer.path = place;
  if (answer.path.isEmpty() || stop) return answer;
  if (!traced) {
    if (const auto sheet = importer::Document::open(QFile::encodeName(answer.path).toStdString()))
      answer.page = placedPage(button, *sheet, progress);
  }
  if (!answer.page && !stop) readAgain(button, answer, progress);
  return answer;
}

void PageReturn::start(ButtonDocument& document, const QStringList& folders, bool traced,
                       std::function<void(ButtonDocument&, const Answer&)> take) {
  thread_.start([this, guarded = QPointer<ButtonDocument>(&document), button = document.button(), folders,
                 traced, take = std::move(take)] {
    Answer answer = findAndRead(button, folders, traced, stop_);
    if (stop_) return;
    QMetaObject::invokeMethod(
        this,
        [guarded, answer = std::move(answer), take] {
          if (guarded) take(*guarded, answer);
        },
        Qt::QueuedConnection);
  });
}

void PageReturn::ask(ButtonDocument& document, const QStringList& folders, bool chosen) {
  start(document, folders, false,
        [this, chosen](ButtonDocument& itself, const Answer& answer) { take(itself, answer, chosen); });
}

void PageReturn::trace(ButtonDocument& document) {
  if (!tracing_.insert(&document).second) return;
  start(document, {lastPlaceOf(document.button())}, true,
        [this](ButtonDocument& itself, const Answer& answer) {
          if (!answer.report) {
            PlacedPage page = *itself.sheet();
            page.readable = false;
            itself.setSheet(std::move(page));
            return emit refused(&itself, notReadAgain(itself.button(), answer.failure));
          }
          itself.setOrigin(answer.report);
          emit returned(&itself);
        });
}

void PageReturn::attend(ButtonDocument& document) {
  connect(&document, &ButtonDocument::originWanted, this, [this, itself = &document] { trace(*itself); });
  connect(&document, &QObject::destroyed, this, [this, gone = &document] { tracing_.erase(gone); });
}

void PageReturn::showKept(ButtonDocument& document) {
  if (document.sheet() || !document.cutout()) return;
  if (auto page = placedFrom(*document.cutout())) document.setSheet(std::move(page));
}

void PageReturn::take(ButtonDocument& document, const Answer& answer, bool chosen) {
  const auto& provenance = document.button().provenance();
  if (!provenance || document.origin()) return;
  const QString name = QString::fromStdString(provenance->sourceFile);
  if (answer.path.isEmpty()) {
    if (chosen)
      return emit refused(&document,
                          tr("The button was read from another datasheet, %1. Choose that file.").arg(name));
    showKept(document);
    return emit missing(&document, name);
  }
  remember(*provenance, answer.path);
  if (!answer.page && !answer.report) {
    showKept(document);
    return emit refused(&document, notReadAgain(document.button(), answer.failure));
  }
  if (answer.page)
    document.setSheet(answer.page);
  else
    document.setOrigin(answer.report);
  emit returned(&document);
}

}  // namespace detent::editor
