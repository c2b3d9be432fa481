// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/batch_import.h"

#include <algorithm>
#include <new>
#include <QFile>
#include <QFileInfo>
#include <utility>

#include "editor/importing/finding_words.h"
#include "importer/all_graphs.h"

namespace detent::editor {
namespace {

constexpr double batchTimeLimit_s = 120;  // per file, as detent-import --batch has it

BatchResult refusal(GraphId graph, const Failure& failure, const QString& file, const DisplayUnits& units) {
  return {graph, {}, 0, {}, adviceFor(failure, file, units).problem};
}

BatchResult resultOf(const importer::ImportAttempt& attempt, const importer::ImportRequest& one,
                     const QString& file, const DisplayUnits& units) {
  const GraphId graph{one.page.value_or(0), one.graph.value_or(0)};
  if (attempt.report)
    return {graph, attempt.report->button, attempt.report->confidence, {}, causeOf(*attempt.report, units)};
  BatchResult refused = refusal(graph, attempt.report.failure(), file, units);
  if (attempt.question) refused.question = inWords(*attempt.question);
  return refused;
}

std::vector<BatchResult> resultsOf(const QString& path, const DisplayUnits& units,
                                   const importer::Progress& progress) {
  const QString file = QFileInfo(path).fileName();
  std::vector<BatchResult> results;
  importer::ImportRequest request;
  request.path = QFile::encodeName(path).toStdString();
  request.asks = true;
  request.timeLimit.emplace(batchTimeLimit_s);
  try {
    const auto searched = importer::attemptAllGraphs(
        request, progress,
        [&](const importer::ImportAttempt& attempt, const importer::ImportRequest& one, std::size_t) {
          results.push_back(resultOf(attempt, one, file, units));
        });
    if (!searched) results.push_back(refusal({}, searched.failure(), file, units));
  } catch (const std::bad_alloc&) {
    results = {{{}, {}, 0, {}, BatchImport::tr("The file needs more memory than is available.")}};
  }
  return results;
}

}  // namespace

BatchImport::BatchImport(QObject* parent) : QObject(parent) {
  workers_.setMaxThreadCount(std::max(1, QThread::idealThreadCount() - 1));
  workers_.setThreadPriority(QThread::LowPriority);
}

BatchImport::~BatchImport() {
  left_ = 0;  // emits nothing any more
  cancel();
  workers_.waitForDone();
}

void BatchImport::start(const QStringList& paths, const DisplayUnits& units) {
  cancel();
  const auto cancelled = std::make_shared<std::atomic<bool>>(false);
  cancelled_ = cancelled;
  ++batch_;
  left_ = static_cast<int>(paths.size());
  for (int file = 0; file < left_; ++file)
    workers_.start([this, cancelled, batch = batch_, file, path = paths[file], units] {
      if (cancelled->load()) return;
      QMetaObject::invokeMethod(this, [this, batch, file] {
        if (batch == batch_ && left_ > 0) emit started(file);
      });
      importer::Progress progress;
      progress.cancelled = [cancelled] { return cancelled->load(std::memory_order_relaxed); };
      auto results = resultsOf(path, units, progress);
      QMetaObject::invokeMethod(
          this, [this, batch, file, results = std::move(results)] { take(batch, file, results); });
    });
}

void BatchImport::take(int batch, int file, const std::vector<BatchResult>& results) {
  if (batch != batch_ || left_ == 0) return;
  emit finished(file, results);
  if (--left_ == 0) emit ended();
}

void BatchImport::cancel() {
  workers_.clear();
  if (cancelled_) cancelled_->store(true);
  if (std::exchange(left_, 0) > 0) emit ended();
}

}  // namespace detent::editor
