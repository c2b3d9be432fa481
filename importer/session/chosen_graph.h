// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Chooses the graph to import: the requested one, or the one with the highest confidence.

#include <memory>
#include <utility>
#include <vector>

#include "importer/session/kept_graphs.h"

namespace detent::importer {

/// The graph that an import reads.
struct ChosenGraph {
  int page = 1, graph = 1;
  PageGraphs* onPage = nullptr;
  std::size_t index = 0;
  std::vector<Remark> remarks;
  int graphCount = 1;                               ///< number of graphs to choose from
  std::vector<std::pair<int, std::size_t>> rivals;  ///< page and index of other graphs with equal axes
  /// the mirrored graph that is traced if the numbers fall
  std::shared_ptr<LocatedGraph> mirrored = nullptr;

  LocatedGraph& located() const { return mirrored ? *mirrored : asRead(); }
  /// the graph as printed, not mirrored
  LocatedGraph& asRead() const { return onPage->located.graphs[index]; }
};

/// Page, number and place of a graph, and the remarks on its choice.
struct GraphPlace {
  int page = 1, graph = 1;
  Box pageBox;
  std::vector<Remark> remarks;
};

/// The requested graph, or the one of the document with the highest confidence.
Result<ChosenGraph> chooseGraph(KeptGraphs& graphs, const ImportRequest& request, const LocateKey& key,
                                const Progress& progress);

/// The graph at the place where another search found it. Failure noForceGraph: this search finds none there.
Result<ChosenGraph> chooseGraphAt(KeptGraphs& graphs, const GraphPlace& place, const LocateKey& key,
                                  const Progress& progress);

/// Prepares a graph for tracing: reads its texts and mirrors it if its axes fall.
void makeReady(ChosenGraph& choice, KeptGraphs& graphs, const Progress& progress);

/// Name of the button. In a document with several graphs it contains the graph's title, so that their names
/// differ.
std::string buttonName(const ChosenGraph& choice, const KeptPages& pages);

/// The failure with the file as its subject and the graph as its place, unless it names them itself.
Failure placed(Failure failure, const ChosenGraph& choice, const KeptPages& pages);

/// Adds the remark that the document holds other graphs, if it does.
void remarkOnOtherGraphs(ChosenGraph& choice);

}  // namespace detent::importer
