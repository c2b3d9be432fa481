// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/kept_graphs.h"

#include <algorithm>
#include <utility>

namespace detent::importer {
namespace {

ViewOptions viewOptionsFor(const QualitySettings& settings, const ImportHints& hints, double magnification) {
  ViewOptions view = settings.view;
  if (hints.dpi) {  // a given resolution is used exactly, without widening or limit
    view.maxScale_px_per_unit = *hints.dpi / 72.0;
    view.minFrameWidth_px = 16384;
  }
  view.maxScale_px_per_unit *= magnification;
  view.minFrameWidth_px = std::min(16384.0, magnification * view.minFrameWidth_px);
  return view;
}

std::size_t bytesOf(const PageView& view) {
  std::size_t bytes = view.raster.rgb.size();
  for (const VectorPath& path : view.paths) {
    for (const auto& line : path.polylines) bytes += line.size() * sizeof(Point);
  }
  return bytes;
}

}  // namespace

LocateKey locateKeyOf(Quality quality, const ImportHints& hints, double magnification) {
  return {viewOptionsFor(settingsFor(quality), hints, magnification), hints.axes, hints.frame, magnification};
}

ListedGraph PageGraphs::listed(int page, std::size_t index) const {
  const LocatedGraph& graph = located.graphs[index];
  const Found<AxisCalibration>& found =
      axes[index].asLocated ? axes[index].asLocated->calibration : graph.axes.calibration;
  return {page,
          static_cast<int>(index) + 1,
          unit,
          graph.candidate.value.pageBox,
          graph.candidate.value.quarterTurns,
          found.value.x,
          found.value.y,
          std::min({graph.candidate.confidence, graph.frame.confidence, found.confidence})};
}

Result<PageGraphs*> KeptGraphs::located(int page, const LocateKey& key, const Progress& progress) {
  const Key at{page, !key.frame.empty(), key.magnification};
  if (const auto kept = graphs_.find(at); kept != graphs_.end() && kept->second.key == key) {
    kept->second.usedAt = ++clock_;
    return &kept->second;
  }
  StepClock time(seconds_, ImportStep::locate);
  auto onPage = pages_.page(page, progress);
  if (!onPage) return onPage.failure();
  auto found =
      locateGraphs(pages_.document(), **onPage, {key.view, key.axes, key.frame, key.magnification}, progress);
  if (!found) return found.failure();
  // An interrupted search must not be stored as complete.
  if (progress.isCancelled()) return pages_.cancelled();
  PageGraphs fresh{key, std::move(found).value(), {}, (*onPage)->unit, ++clock_, clock_};
  for (std::size_t i = 0; i < fresh.located.graphs.size(); ++i) fresh.axes.push_back({key.axes, {}});
  return &graphs_.insert_or_assign(at, std::move(fresh)).first->second;
}

Result<PageGraphs*> KeptGraphs::locatedBeforeHints(int page, LocateKey key, const Progress& progress) {
  const bool frameGiven = !key.frame.empty();
  const auto kept = graphs_.find({page, frameGiven, key.magnification});
  if (frameGiven && kept != graphs_.end() && !kept->second.located.graphs.empty()) {
    LocateKey asKept = key;
    asKept.axes = kept->second.key.axes;
    if (asKept == kept->second.key) return located(page, asKept, progress);
  }
  if (!frameGiven) key.axes = {};
  return located(page, key, progress);
}

Result<Done> KeptGraphs::readAxesWith(const AxisHints& hints, PageGraphs& onPage, std::size_t index,
                                      const Progress& progress) {
  LocatedGraph& graph = onPage.located.graphs[index];
  GraphAxes& reading = onPage.axes[index];
  if (reading.hints == hints) return Done{};
  if (!reading.asLocated) reading.asLocated = graph.axes;
  AxesFound axes = *reading.asLocated;
  if (!(hints == onPage.key.axes)) {
    StepClock time(seconds_, ImportStep::axes);
    auto read = readAxes(graph.view, graph.frame.value, hints, progress);
    if (!read) return read.failure();
    axes = std::move(read).value();
    useNoTicksOfGivenRanges(axes.calibration.value, hints);
  }
  axes.texts = std::move(graph.axes.texts);
  axes.otherLines = std::move(graph.axes.otherLines);
  graph.axes = std::move(axes);
  reading.hints = hints;
  return Done{};
}

void KeptGraphs::readAllTexts(LocatedGraph& graph, const Progress& progress) {
  if (graph.textsComplete) return;
  StepClock time(seconds_, ImportStep::texts);
  readGraphTexts(graph.view, graph.frame.value, graph.axes, progress);
  graph.textsComplete = !progress.isCancelled();
}

Result<Done> KeptGraphs::restoreView(int page, PageGraphs& onPage, std::size_t index,
                                     const Progress& progress) {
  LocatedGraph& graph = onPage.located.graphs[index];
  if (!graph.view.raster.empty()) return Done{};
  StepClock time(seconds_, ImportStep::view);
  auto read = pages_.page(page, progress);
  if (!read) return read.failure();
  auto view = viewOf(pages_.document(), **read, graph.candidate.value, onPage.key.view, progress);
  if (!view) return view.failure();
  graph.view = std::move(view).value();
  return Done{};
}

void KeptGraphs::freeViews(const LocatedGraph* keep) {
  constexpr std::size_t mostBytes = std::size_t{24} << 20;
  std::vector<PageGraphs*> byAge;
  std::size_t bytes = 0;
  for (auto& each : graphs_) {
    byAge.push_back(&each.second);
    for (const LocatedGraph& graph : each.second.located.graphs) bytes += bytesOf(graph.view);
  }
  std::sort(byAge.begin(), byAge.end(),
            [](const PageGraphs* a, const PageGraphs* b) { return a->usedAt < b->usedAt; });
  for (PageGraphs* onPage : byAge) {
    for (LocatedGraph& graph : onPage->located.graphs) {
      if (bytes <= mostBytes) return;
      if (&graph == keep) continue;
      bytes -= bytesOf(graph.view);
      graph.view = {};
    }
  }
}

Result<GraphList> listGraphs(KeptGraphs& graphs, std::optional<int> page, const LocateKey& key,
                             const Progress& progress) {
  GraphList listed;
  const int first = page.value_or(1), last = page.value_or(graphs.pages().count());
  std::optional<Failure> firstFault;
  int unreadable = 0;
  for (int number = first; number <= last; ++number) {
    if (progress.report) progress.report(double(number - first) / (last - first + 1), ImportStep::locate);
    auto located = graphs.located(number, key, progress);
    const std::vector<Remark> unread = graphs.pages().remarksOn(number);
    listed.remarks.insert(listed.remarks.end(), unread.begin(), unread.end());
    if (!located) {
      const bool onlyThisPage = located.failure().code == FailureCode::unreadableInput && first < last;
      if (!onlyThisPage || progress.isCancelled()) return located.failure();
      if (!firstFault) firstFault = located.failure();
      ++unreadable;
      continue;  // an unreadable page is named and does not end the list
    }
    const LocatedPage& onPage = (*located)->located;
    for (std::size_t i = 0; i < onPage.graphs.size(); ++i)
      listed.graphs.push_back((*located)->listed(number, i));
    listed.rejected.insert(listed.rejected.end(), onPage.rejected.begin(), onPage.rejected.end());
    graphs.freeViews(nullptr);
  }
  if (unreadable == last - first + 1) return *firstFault;
  return listed;
}

}  // namespace detent::importer
