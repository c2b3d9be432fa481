// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Every graph of an input, one after the other: detent-import --all and --batch, and the editor's batch.

#include <functional>
#include <vector>

#include "importer/importer.h"

namespace detent::importer {

/// Attempts every graph of request.path in reading order. A force meter's log is one graph; an input in which
/// no graph is found is attempted once, and that attempt says why. `take` gets each attempt, the request that
/// it answers, and the number of graphs. Returns the remarks of the search for graphs. Failure: the input
/// cannot be opened or searched, or the search was cancelled.
Result<std::vector<Remark>> attemptAllGraphs(
    const ImportRequest& request, const Progress& progress,
    const std::function<void(const ImportAttempt& attempt, const ImportRequest& one, std::size_t graphs)>&
        take);

}  // namespace detent::importer
