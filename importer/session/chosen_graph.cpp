// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/chosen_graph.h"

#include <algorithm>
#include <optional>

#include "importer/graph_copies.h"
#include "importer/graph_title.h"
#include "importer/rising_axes.h"

namespace detent::importer {
namespace {

/// One numbered graph of a page, with its axes read by the request's hints; nothing if the page without hints
/// does not have it.
Result<std::optional<ChosenGraph>> chooseNumbered(KeptGraphs& graphs, const ImportRequest& request,
                                                  const LocateKey& key, const Progress& progress) {
  auto onPage = graphs.locatedBeforeHints(*request.page, key, progress);
  if (!onPage) return onPage.failure();
  const auto index = key.frame.empty() ? static_cast<std::size_t>(*request.graph - 1) : std::size_t{0};
  if (index >= (*onPage)->located.graphs.size()) return std::optional<ChosenGraph>{};
  if (auto made = graphs.restoreView(*request.page, **onPage, index, progress); !made) return made.failure();
  if (auto read = graphs.readAxesWith(key.axes, **onPage, index, progress); !read) return read.failure();
  return std::optional<ChosenGraph>{ChosenGraph{*request.page, *request.graph, *onPage, index, {}, 1, {}}};
}

Failure nothingFound(const KeptPages& pages, const ImportRequest& request, int graphCount,
                     const std::optional<Failure>& rejection) {
  if (request.graph && graphCount > 0) {
    return pages.failure(FailureCode::wrongUsage, Message("graph %1", *request.graph),
                         Message("there is no such graph"), RemedyKind::chooseGraph);
  }
  if (rejection) return *rejection;
  const std::vector<Remark> unread = pages.remarks();
  return pages.failure(
      FailureCode::noForceGraph, request.page ? placeOf(*request.page) : Message(),
      unread.empty() ? Message("no force graph found")
                     : Message("no force graph found (%1)", messageOf(unread.front())),
      {{RemedyKind::giveFrame, "if there is one"}, {RemedyKind::choosePage, "if the document has several"}});
}

Result<ChosenGraph> chooseBest(KeptGraphs& graphs, const ImportRequest& request, const LocateKey& key,
                               const Progress& progress) {
  const int pageCount = graphs.pages().count();
  ChosenGraph best;
  std::optional<Failure> bestRejection;
  int graphCount = 0;
  struct Seen {
    int page;
    std::size_t index;
    AxisCalibration axes;
  };
  std::vector<Seen> seen;
  const int first = request.page.value_or(1), last = request.page.value_or(pageCount);
  for (int number = first; number <= last; ++number) {
    auto onPage = graphs.located(number, key, progress);
    if (!onPage) {
      if (request.page || pageCount == 1 || progress.isCancelled()) return onPage.failure();
      // an unreadable page is reported and does not end the search
      best.remarks.push_back(unreadablePage(number, onPage.failure()));
      continue;
    }
    const auto& found = (*onPage)->located.graphs;
    const auto& rejection = (*onPage)->located.bestRejection;
    if (rejection && !bestRejection) bestRejection = rejection;
    graphCount += static_cast<int>(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool frameGiven = !key.frame.empty();
      if (request.graph && *request.graph != static_cast<int>(i) + 1 && !frameGiven) continue;
      seen.push_back({number, i, found[i].axes.calibration.value});
      if (!best.onPage || found[i].confidence() > best.located().confidence()) {
        best.page = number, best.graph = static_cast<int>(i) + 1, best.onPage = *onPage, best.index = i;
        if (frameGiven) best.graph = request.graph.value_or(1);
      }
    }
    graphs.freeViews(best.onPage ? &best.located() : nullptr);
  }
  if (!best.onPage) return nothingFound(graphs.pages(), request, graphCount, bestRejection);
  if (auto made = graphs.restoreView(best.page, *best.onPage, best.index, progress); !made)
    return made.failure();
  best.graphCount = request.graph ? 1 : graphCount;
  for (const Seen& other : seen)
    if (best.graphCount > 1 && (other.page != best.page || other.index != best.index) &&
        haveSameAxes(best.located().axes.calibration.value, other.axes))
      best.rivals.emplace_back(other.page, other.index);
  return best;
}

}  // namespace

Result<ChosenGraph> chooseGraph(KeptGraphs& graphs, const ImportRequest& request, const LocateKey& key,
                                const Progress& progress) {
  if (request.page && request.graph && *request.graph > 0) {
    auto numbered = chooseNumbered(graphs, request, key, progress);
    if (!numbered) return numbered.failure();
    if (*numbered) return std::move(**numbered);
  }
  return chooseBest(graphs, request, key, progress);
}

Result<ChosenGraph> chooseGraphAt(KeptGraphs& graphs, const GraphPlace& place, const LocateKey& key,
                                  const Progress& progress) {
  const Failure notThere = graphs.pages().failure(FailureCode::noForceGraph, {}, "no force graph found", {});
  auto onPage = graphs.located(place.page, key, progress);
  if (!onPage) return notThere;
  const auto& onIt = (*onPage)->located.graphs;
  const auto shared = [&](const LocatedGraph& graph) {
    const Box box = graph.candidate.value.pageBox, common = box.common(place.pageBox);
    return common.empty() ? 0 : common.area() / box.joined(place.pageBox).area();
  };
  const auto best = std::ranges::max_element(onIt, {}, shared);
  constexpr double sameFrame = 0.5;  // share of the joint area of both frames
  if (best == onIt.end() || shared(*best) < sameFrame) return notThere;
  const auto index = static_cast<std::size_t>(best - onIt.begin());
  if (!graphs.restoreView(place.page, **onPage, index, progress)) return notThere;
  return ChosenGraph{place.page, place.graph, *onPage, index, place.remarks, 1, {}};
}

void makeReady(ChosenGraph& choice, KeptGraphs& graphs, const Progress& progress) {
  graphs.readAllTexts(choice.located(), progress);
  if (choice.mirrored) return;
  if (auto rising = mirroredToRise(choice.located()))
    choice.mirrored = std::make_shared<LocatedGraph>(std::move(*rising));
}

std::string buttonName(const ChosenGraph& choice, const KeptPages& pages) {
  const bool alone = pages.count() == 1 && choice.onPage->located.graphs.size() == 1;
  const std::string title = alone ? std::string() : titleAbove(choice.asRead());
  return title.empty() ? pages.stem() : pages.stem() + " " + title;
}

Failure placed(Failure failure, const ChosenGraph& choice, const KeptPages& pages) {
  if (failure.subject.empty()) failure.subject = pages.fileName();
  if (failure.place.empty()) failure.place = pages.placeOfGraph(choice.page, choice.graph);
  return failure;
}

void remarkOnOtherGraphs(ChosenGraph& choice) {
  if (choice.graphCount <= 1) return;
  choice.remarks.push_back({RemarkCode::severalGraphs,
                            {choice.graphCount, choice.page, choice.graph},
                            {{RemedyKind::choosePage, {}},
                             {RemedyKind::chooseGraph, "for another"},
                             {RemedyKind::importAll, "for each"}}});
}

}  // namespace detent::importer
