// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <optional>
#include <utility>

#include "importer/importer.h"
#include "importer/session/graph_reader.h"
#include "importer/session/import_log.h"
#include "importer/session/import_plot.h"

namespace detent::importer {

struct ImportSession::Impl {
  Impl(std::string ofFile, std::string name) : path(std::move(ofFile)), fileName(std::move(name)) {}

  std::string path, fileName;
  std::optional<GraphReader> document = {};  // empty: a force log

  Failure wrongUsage(Message problem, Remedies remedies) const {
    return {FailureCode::wrongUsage, fileName, "", std::move(problem), std::move(remedies)};
  }
};

ImportSession::ImportSession(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ImportSession::ImportSession(ImportSession&&) noexcept = default;
ImportSession& ImportSession::operator=(ImportSession&&) noexcept = default;
ImportSession::~ImportSession() = default;

Result<ImportSession> ImportSession::open(const std::string& path, const PageLimits& limits) {
  auto impl = std::make_unique<Impl>(path, std::filesystem::path(path).filename().string());
  if (!isForceLogPath(path)) {
    auto document = Document::open(path, limits);
    if (!document) return document.failure();
    impl->document.emplace(std::move(document).value(), impl->fileName);
  }
  return ImportSession(std::move(impl));
}

Result<ImportSession> ImportSession::fromBytes(std::vector<unsigned char> bytes, const std::string& name,
                                               const PageLimits& limits) {
  auto document = Document::fromBytes(std::move(bytes), name, limits);
  if (!document) return document.failure();
  auto impl = std::make_unique<Impl>(std::string(), name);
  impl->document.emplace(std::move(document).value(), name);
  return ImportSession(std::move(impl));
}

int ImportSession::pageCount() const { return impl_->document ? impl_->document->pages().count() : 0; }
bool ImportSession::isForceLog() const { return !impl_->document; }

Result<const Page*> ImportSession::page(int number, const Progress& progress) {
  if (isForceLog())
    return impl_->wrongUsage(Message("a force log has no pages"),
                             Message("Import the log without a page number"));
  return impl_->document->pages().page(number, progress);
}

Result<std::vector<ListedRecord>> ImportSession::records(const ImportHints& hints, const Progress& progress) {
  if (!isForceLog())
    return impl_->wrongUsage(Message("a page has no recordings to choose from"),
                             Message("List the graphs of the page"));
  return recordsOfLog(impl_->path, hints, progress);
}

Result<GraphList> ImportSession::list(std::optional<int> page, Quality quality, const ImportHints& hints,
                                      const Progress& progress) {
  if (isForceLog())
    return impl_->wrongUsage(Message("a force log has no pages to list"),
                             Message("Import the log without listing"));
  return listGraphs(impl_->document->graphs(), page, locateKeyOf(quality, hints), progress);
}

Result<std::vector<PlotSwitch>> ImportSession::switches(const ListedGraph& graph, Quality quality,
                                                        const ImportHints& hints, const Progress& progress) {
  if (isForceLog()) return impl_->wrongUsage(Message("a force log has no switches to choose from"), {});
  ImportRequest request;
  request.page = graph.page, request.graph = graph.graph;
  request.quality = quality;
  request.hints = hints;
  return impl_->document->switches(request, progress);
}

ImportAttempt ImportSession::attempt(const ImportRequest& request, const Progress& progress) {
  ImportAttempt made = isForceLog() ? importLog(impl_->path, request, progress)
                                    : importPlot(*impl_->document, request, progress);
  if (request.asks && !isForceLog() && !request.acceptDoubt)
    made.question = openQuestion(*impl_->document, made, request, progress);
  const auto restOf = [&](Remedies& remedies) { remedies = leftToTry(remedies, request.hints); };
  if (!made.report && !made.report.failure().reason.empty()) {
    Failure doubted = made.report.failure();
    restOf(doubted.remedies);
    made.report = std::move(doubted);
  } else if (made.report && made.report->doubt) {
    restOf(made.report->doubt->remedies);
  }
  return made;
}

Result<ImportReport> ImportSession::importGraph(const ImportRequest& request, const Progress& progress) {
  return attempt(request, progress).report;
}

}  // namespace detent::importer
