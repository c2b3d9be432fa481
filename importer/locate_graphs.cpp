// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/locate_graphs.h"

#include <algorithm>

namespace detent::importer {
namespace {

/// Below this a listed graph would more often be a dimension drawing than a force graph
/// (docs/decisions/0800-import-confidence.md).
constexpr double listBar = 0.3;

Result<LocatedGraph> readCandidate(const Document& document, const Page& page,
                                   Found<FrameCandidate> candidate, const LocateOptions& options,
                                   const Progress& progress) {
  auto view = document.view(page, candidate.value.regionBox, candidate.value.quarterTurns, options.view);
  if (!view) return view.failure();
  auto frame = locatePlotFrame(*view, page, candidate.value, progress);
  if (!frame) return frame.failure();
  auto axes = readAxes(*view, frame->value, options.axes, progress);
  if (!axes) return axes.failure();
  return LocatedGraph{std::move(candidate), std::move(view).value(), std::move(frame).value(),
                      std::move(axes).value()};
}

RejectedFrame rejection(const FrameCandidate& candidate, const Result<LocatedGraph>& graph,
                        const std::string& source) {
  if (!graph) return {candidate.pageBox, candidate.quarterTurns, graph.failure()};
  return {candidate.pageBox, candidate.quarterTurns,
          failureOf({DoubtCode::ratherADrawing,
                     {messagesOf(graph->axes.calibration.evidence)},
                     {{RemedyKind::giveFrame, "if it is a force graph"}}},
                    source, "plot frame")};
}

/// Of two rejections the more telling one: doubt about numbers that were read beats "no numbers".
bool moreTelling(const Failure& a, const std::optional<Failure>& b) {
  return !b || (a.code == FailureCode::notCertain && b->code != FailureCode::notCertain);
}

}  // namespace

double LocatedGraph::confidence() const {
  return std::min({candidate.confidence, frame.confidence, axes.calibration.confidence});
}

std::vector<StepFinding> LocatedGraph::findings() const {
  return {{ImportStep::locate, std::min(candidate.confidence, frame.confidence), frame.by, frame.evidence},
          {ImportStep::axes, axes.calibration.confidence, axes.calibration.by, axes.calibration.evidence}};
}

Result<LocatedPage> locateGraphs(const Document& document, const Page& page, const LocateOptions& options,
                                 const Progress& progress) {
  const bool frameGiven = !options.frameCorners.empty();
  std::vector<Found<FrameCandidate>> candidates;
  if (frameGiven) {
    auto given = frameFromCorners(options.frameCorners, page);
    if (!given) return given.failure();
    candidates.push_back(std::move(given).value());
  } else {
    candidates = findPlotFrames(page, document, progress);
  }

  LocatedPage located;
  for (const auto& candidate : candidates) {
    if (progress.isCancelled()) return Failure::cancelled(page.source);
    auto graph = readCandidate(document, page, candidate, options, progress);
    if (graph && (frameGiven || graph->confidence() >= listBar)) {
      located.graphs.push_back(std::move(graph).value());
      continue;
    }
    located.rejected.push_back(rejection(candidate.value, graph, page.source));
    if (!graph && moreTelling(graph.failure(), located.bestRejection)) {
      located.bestRejection = graph.failure();
    }
  }
  return located;
}

}  // namespace detent::importer
