// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A document may show a graph several times; the best drawn one is imported (importer/graph_copies.h).

#include "importer/session/chosen_graph.h"
#include "importer/session/kept_tracings.h"

namespace detent::importer {

/// Compares the chosen graph with others on equal axes. If some show the same curves, chooses the best of
/// them and adds a remark.
void preferBetterCopy(ChosenGraph& choice, const ImportRequest& request, const LocateKey& key,
                      KeptGraphs& graphs, KeptTracings& tracings, StepSeconds& seconds,
                      const Progress& progress);

}  // namespace detent::importer
