// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/better_copy.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "importer/graph_copies.h"

namespace detent::importer {
namespace {

/// A graph read up to its strokes.
struct CopyReading {
  ChosenGraph choice;
  StrokePair strokes;
  CopyRank rank;
};

}  // namespace

void preferBetterCopy(ChosenGraph& choice, const ImportRequest& request, const LocateKey& key,
                      KeptGraphs& graphs, KeptTracings& tracings, StepSeconds& seconds,
                      const Progress& progress) {
  if (choice.rivals.empty()) return;
  const TraceOptions options = settingsFor(request.quality).trace;
  const auto read = [&](ChosenGraph copy) -> std::optional<CopyReading> {
    makeReady(copy, graphs, progress);
    const LocatedGraph& graph = copy.located();
    const auto curves = tracings.traces(copy, request.hints.trace, options, progress);
    if (!curves) return {};
    StepClock time(seconds, ImportStep::copies);
    auto strokes = strokesAmong(**curves, graph, request.hints.strokes);
    if (!strokes) return {};
    const Box frame = graph.frame.value.box();
    const CopyRank rank{std::min(graph.confidence(), strokes->confidence), strokes->value.press.fromVector,
                        frame.width() * frame.height()};
    return CopyReading{copy, std::move(strokes->value), rank};
  };

  const auto first = read(choice);
  if (!first) return;
  CopyReading best = *first;
  std::vector<std::pair<int, int>> positions{{choice.page, choice.graph}};
  for (std::size_t i = 0; i < std::min(choice.rivals.size(), KeptTracings::mostCopies); ++i) {
    const auto [page, index] = choice.rivals[i];
    auto onPage = graphs.located(page, key, progress);
    if (!onPage || index >= (*onPage)->located.graphs.size() || progress.isCancelled()) continue;
    if (!graphs.restoreView(page, **onPage, index, progress)) continue;
    ChosenGraph rival = choice;
    rival.page = page, rival.graph = static_cast<int>(index) + 1;
    rival.onPage = *onPage, rival.index = index;
    const auto reading = read(rival);
    if (!reading) continue;
    const auto apart = distanceBetween(first->strokes, reading->strokes);
    if (!apart || *apart > copiesWithin) continue;
    positions.emplace_back(rival.page, rival.graph);
    if (isBetterCopy(reading->rank, best.rank)) best = *reading;
  }
  if (positions.size() == 1) return;
  std::sort(positions.begin(), positions.end());
  std::vector<Message> all;
  for (const auto& [page, graph] : positions) all.push_back(placeOf(page, graph));
  best.choice.graphCount -= static_cast<int>(positions.size()) - 1;
  best.choice.remarks.push_back(
      {RemarkCode::sameGraphSeveralTimes, {positions.size(), std::move(all), best.choice.page}});
  choice = std::move(best.choice);
}

}  // namespace detent::importer
