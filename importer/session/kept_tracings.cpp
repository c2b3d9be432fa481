// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/kept_tracings.h"

#include <algorithm>
#include <string>
#include <utility>

#include "importer/strokes/spotted_name.h"

namespace detent::importer {
namespace {

/// Replaces the requested name by the number of its switch if the text engine did not read the name, but the
/// legend's picture resembles it.
StrokeHints asSeen(StrokeHints hints, const std::vector<CurveTrace>& curves, const PageView& view) {
  const std::vector<PlotSwitch> switches = switchesAmong(curves);
  if (chosenSwitch(switches, curves, hints.curve)) return hints;
  if (const auto index = switchSpotted(switches, curves, view.raster, hints.curve))
    hints.curve = std::to_string(*index + 1);
  return hints;
}

}  // namespace

TraceHints hintsInView(TraceHints hints, const PageView& view) {
  const Homography toView = view.viewToPage.inverse();
  for (Box& mask : hints.masks_px) mask = toView.boxOf(mask);
  return hints;
}

trace::PlotScene sceneOf(const LocatedGraph& graph, const TraceHints& onView) {
  return {graph.view.raster, graph.frame.value, graph.axes.texts, onView.masks_px};
}

Result<Found<StrokePair>> strokesAmong(const std::vector<CurveTrace>& curves, const LocatedGraph& graph,
                                       const StrokeHints& hints) {
  return separateStrokes(curves, graph.axes, asSeen(hints, curves, graph.view));
}

Result<const std::vector<CurveTrace>*> KeptTracings::traces(const ChosenGraph& choice,
                                                            const TraceHints& hints,
                                                            const TraceOptions& options,
                                                            const Progress& progress) {
  const auto kept = std::find_if(tracings_.begin(), tracings_.end(), [&](const Tracing& each) {
    return each.locatedAs == choice.onPage->serial && each.graph == choice.graph && each.hints == hints &&
           each.spacing_px == options.pointSpacing_px;
  });
  if (kept != tracings_.end()) return &kept->traces;
  const LocatedGraph& graph = choice.located();
  StepClock time(seconds_, ImportStep::trace);
  const TraceHints onView = hintsInView(hints, graph.view);
  for (Tracing& each : tracings_) each.scene.reset();
  trace::PlotScene scene = sceneOf(graph, onView);
  auto found = traceCurves(graph.view, scene, graph.axes, onView, options, progress);
  if (!found) return found.failure();
  // An interrupted tracing must not be stored as complete.
  if (progress.isCancelled()) return Failure::cancelled({});
  if (tracings_.size() == 1 + mostCopies) tracings_.pop_front();
  tracings_.push_back(
      {choice.onPage->serial, choice.graph, hints, options.pointSpacing_px, std::move(found).value()});
  tracings_.back().scene = std::move(scene);
  return &tracings_.back().traces;
}

Explanation KeptTracings::explanationOf(const std::vector<CurveTrace>* curves, const ChosenGraph& choice) {
  const auto kept =
      std::ranges::find_if(tracings_, [&](const Tracing& each) { return &each.traces == curves; });
  if (kept == tracings_.end()) return {};
  if (!kept->explanation) {
    StepClock time(seconds_, ImportStep::strokes);
    const LocatedGraph& graph = choice.located();
    if (!kept->scene) kept->scene = sceneOf(graph, hintsInView(kept->hints, graph.view));
    kept->explanation = explain(*kept->scene, kept->traces);
    kept->scene.reset();
  }
  return *kept->explanation;
}

}  // namespace detent::importer
