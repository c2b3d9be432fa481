// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Traces the curves of graphs and keeps the tracings, as long as only later hints change.

#include <list>
#include <optional>
#include <vector>

#include "importer/session/chosen_graph.h"
#include "importer/trace/explanation.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer {

/// The plot of a graph, as tracers see it. Masks of the hints in view pixels.
trace::PlotScene sceneOf(const LocatedGraph& graph, const TraceHints& onView);

/// The hints with masks converted from page units to view pixels.
TraceHints hintsInView(TraceHints hints, const PageView& view);

/// Strokes among the curves of a graph. A switch may be requested by a name that only the legend's picture
/// shows.
Result<Found<StrokePair>> strokesAmong(const std::vector<CurveTrace>& curves, const LocatedGraph& graph,
                                       const StrokeHints& hints);

/// Tracings of a graph and of the possible copies that it is compared with. One thread at a time.
class KeptTracings {
 public:
  static constexpr std::size_t mostCopies = 4;  ///< that are compared with a graph

  /// `seconds` must outlive this object.
  explicit KeptTracings(StepSeconds& seconds) : seconds_(seconds) {}

  /// The curves of the graph. Valid until `1 + mostCopies` others were traced.
  Result<const std::vector<CurveTrace>*> traces(const ChosenGraph& choice, const TraceHints& hints,
                                                const TraceOptions& options, const Progress& progress);

  /// Unexplained pixels of these tracings of the chosen graph, if they are kept; empty otherwise.
  Explanation explanationOf(const std::vector<CurveTrace>* curves, const ChosenGraph& choice);

 private:
  struct Tracing {
    std::uint64_t locatedAs = 0;
    int graph = 0;
    TraceHints hints;
    double spacing_px = 0;
    std::vector<CurveTrace> traces;
    std::optional<trace::PlotScene> scene = {};  // of the latest tracing, until its remainders are explained
    // computed on request, because names and colours do not need it
    std::optional<Explanation> explanation = {};
  };

  StepSeconds& seconds_;
  std::list<Tracing> tracings_;  // the latest is last
};

}  // namespace detent::importer
