// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/batch_import.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <new>
#include <QCoreApplication>
#include <QDataStream>
#include <QFile>
#include <QFileInfo>
#include <QThread>
#include <QTimer>
#include <utility>

#include "editor/files/document_files.h"
#include "editor/importing/finding_words.h"
#include "importer/all_graphs.h"
#include "model/file/button_file.h"

namespace detent::editor {
namespace {

constexpr int batchTimeLimit_s = 120;  // per file, as detent-import --batch has it

BatchResult refusal(GraphId graph, const Failure& failure, const QString& file, const DisplayUnits& units) {
  return {graph, {}, 0, {}, adviceFor(failure, file, units).problem};
}

BatchResult resultOf(const importer::ImportAttempt& attempt, const importer::ImportRequest& one,
                     const QString& file, const DisplayUnits& units) {
  const GraphId graph{one.page.value_or(0), one.graph.value_or(0)};
  if (attempt.report) return resultOf(graph, *attempt.report, units);
  BatchResult refused = refusal(graph, attempt.report.failure(), file, units);
  if (attempt.question) refused.question = inWords(*attempt.question);
  return refused;
}

/// One result for each switch of a plot with several; none for any other attempt.
std::vector<BatchResult> resultsOfSwitches(const importer::ImportAttempt& attempt,
                                           importer::ImportRequest one, const QString& file,
                                           const DisplayUnits& units) {
  std::vector<BatchResult> results;
  if (attempt.report || !attempt.evidence ||
      attempt.report.failure().reason != importer::nameOf(importer::DoubtCode::severalSwitches))
    return results;
  auto session = importer::ImportSession::open(one.path);
  for (const importer::PlotSwitch& each : attempt.evidence->switches) {
    if (!session) break;
    const auto number = static_cast<int>(results.size()) + 1;
    one.hints.strokes.curve = std::to_string(number);
    results.push_back(resultOf(session->attempt(one, {}), one, file, units));
    results.back().curve = number;
    results.back().curveName = QString::fromStdString(each.name);
  }
  return results;
}

std::vector<BatchResult> resultsOf(const QString& path, const DisplayUnits& units) {
  const QString file = QFileInfo(path).fileName();
  std::vector<BatchResult> results;
  importer::ImportRequest request;
  request.path = QFile::encodeName(path).toStdString();
  request.asks = true;
  request.timeLimit.emplace(batchTimeLimit_s);
  try {
    const auto searched = importer::attemptAllGraphs(
        request, {},
        [&](const importer::ImportAttempt& attempt, const importer::ImportRequest& one, std::size_t) {
          std::vector<BatchResult> switches = resultsOfSwitches(attempt, one, file, units);
          if (switches.empty()) switches.push_back(resultOf(attempt, one, file, units));
          std::ranges::move(switches, std::back_inserter(results));
        });
    if (!searched) results.push_back(refusal({}, searched.failure(), file, units));
  } catch (const std::bad_alloc&) {
    results = {{{}, {}, 0, {}, BatchImport::tr("The file needs more memory than is available.")}};
  }
  return results;
}

/// Results that the worker has written; nothing if they are not complete.
std::vector<BatchResult> resultsFrom(const QByteArray& written) {
  QDataStream stream(written);
  std::vector<BatchResult> results;
  while (!stream.atEnd()) {
    BatchResult result;
    QByteArray button;
    stream >> result.graph.page >> result.graph.graph >> button >> result.confidence >> result.question >>
        result.reason >> result.curve >> result.curveName;
    if (stream.status() != QDataStream::Ok) return {};
    if (!button.isEmpty()) {
      const auto read = buttonFromJson(button.toStdString(), {});
      if (!read) return {};
      result.button = *read;
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace

BatchResult resultOf(GraphId graph, const importer::ImportReport& report, const DisplayUnits& units) {
  return {graph,
          report.button,
          report.confidence,
          {},
          causeOf(report, units),
          false,
          static_cast<int>(report.curve.value_or(0))};
}

int importForBatch(const QStringList& words) {
  const auto length = lengthUnitFrom(words.value(1).toStdString());
  const auto force = forceUnitFrom(words.value(2).toStdString());
  QFile out;
  if (!length || !force || !out.open(stdout, QIODevice::WriteOnly))
    return static_cast<int>(FailureCode::wrongUsage);
  QDataStream stream(&out);
  for (const BatchResult& result : resultsOf(words.value(0), {*length, *force}))
    stream << result.graph.page << result.graph.graph
           << (result.button ? buttonText(*result.button).toUtf8() : QByteArray()) << result.confidence
           << result.question << result.reason << result.curve << result.curveName;
  return 0;
}

BatchImport::~BatchImport() {
  left_ = 0;  // emits nothing any more
  cancel();
}

void BatchImport::start(const QStringList& paths, const DisplayUnits& units) {
  cancel();
  paths_ = paths;
  units_ = units;
  next_ = 0;
  left_ = static_cast<int>(paths.size());
  for (int i = std::max(1, QThread::idealThreadCount() - 1); i > 0; --i) startNext();
}

void BatchImport::startNext() {
  if (next_ >= paths_.size()) return;
  const int file = next_++;
  auto* process = new QProcess(this);
  running_ << process;
  process->setProcessChannelMode(QProcess::ForwardedErrorChannel);
  connect(process, &QProcess::started, this, [this, file] { emit started(file); });
  connect(process, &QProcess::finished, this, [this, process, file] { take(*process, file); });
  connect(process, &QProcess::errorOccurred, this, [this, process, file](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) take(*process, file);
  });
  // A reader that does not even see its time limit.
  QTimer::singleShot(std::chrono::seconds(2 * batchTimeLimit_s), process, &QProcess::kill);
  process->start(QCoreApplication::applicationFilePath(),
                 {batchWorkerOption, paths_[file], units_.lengthSymbol(), units_.forceSymbol()});
}

void BatchImport::take(QProcess& process, int file) {
  running_.removeOne(&process);
  process.deleteLater();
  std::vector<BatchResult> results;
  if (process.exitStatus() == QProcess::NormalExit) results = resultsFrom(process.readAllStandardOutput());
  if (results.empty())
    results = {{{}, {}, 0, {}, tr("The program that reads files crashed on this one, or did not finish.")}};
  --left_;
  emit finished(file, results);
  if (left_ == 0) return emit ended();
  startNext();
}

void BatchImport::cancel() {
  for (QProcess* process : std::exchange(running_, {})) {
    process->disconnect(this);
    process->kill();
    process->waitForFinished();
    process->deleteLater();
  }
  if (std::exchange(left_, 0) > 0) emit ended();
}

}  // namespace detent::editor
