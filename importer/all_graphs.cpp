// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/all_graphs.h"

namespace detent::importer {

Result<std::vector<Remark>> attemptAllGraphs(
    const ImportRequest& request, const Progress& progress,
    const std::function<void(const ImportAttempt& attempt, const ImportRequest& one, std::size_t graphs)>&
        take) {
  auto session = ImportSession::open(request.path, request.limits);
  if (!session) return session.failure();
  GraphList listed;
  if (!session->isForceLog()) {
    auto found = session->list(request.page, request.quality, request.hints, progress);
    if (!found) return found.failure();
    listed = std::move(*found);
  }
  if (listed.graphs.empty()) take(session->attempt(request, progress), request, 1);
  for (const ListedGraph& graph : listed.graphs) {
    ImportRequest one = request;
    one.page = graph.page, one.graph = graph.graph;
    take(session->attempt(one, progress), one, listed.graphs.size());
  }
  return std::move(listed.remarks);
}

}  // namespace detent::importer
