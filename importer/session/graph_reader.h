// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One reading of a graph on a page: from its choice to a report.

#include <optional>
#include <string>
#include <vector>

#include "importer/session/chosen_graph.h"
#include "importer/session/kept_tracings.h"

namespace detent::importer {

/// An attempt at a reading, and the place of the graph that it chose.
struct PlacedAttempt {
  ImportAttempt attempt;
  std::optional<GraphPlace> place = {};  ///< empty if no graph was found
};

/// Reads graphs of an open document. Repeats only the steps whose inputs have changed. One thread at a time.
class GraphReader {
 public:
  /// `fileName` is used in messages and as the button's name.
  GraphReader(Document document, std::string fileName);
  GraphReader(const GraphReader&) = delete;
  GraphReader& operator=(const GraphReader&) = delete;

  KeptPages& pages() { return pages_; }
  KeptGraphs& graphs() { return graphs_; }

  void startTiming() { seconds_.clear(); }
  const StepSeconds& seconds() const { return seconds_; }  ///< since startTiming

  /// Reads the graph that the request asks for at a magnification of its page; with a place, the graph there.
  PlacedAttempt read(const ImportRequest& request, double magnification,
                     const std::optional<GraphPlace>& place, const Progress& progress);

  /// The switches that the requested graph shows.
  Result<std::vector<PlotSwitch>> switches(const ImportRequest& request, const Progress& progress);

 private:
  /// The graph in a wider frame, which its curves leave otherwise.
  struct Wider {
    LocatedGraph graph;
    std::vector<CurveTrace> curves;
    Result<Found<StrokePair>> strokes;
    Explanation explanation;
  };

  Result<ChosenGraph> choose(const ImportRequest& request, double magnification,
                             const std::optional<GraphPlace>& place, const Progress& progress);
  ImportAttempt readChosen(ChosenGraph& choice, const ImportRequest& request, double magnification,
                           const Progress& untimed, const Progress& progress);
  std::optional<Wider> readWider(const LocatedGraph& graph, const std::vector<CurveTrace>& curves,
                                 const ImportRequest& request, const TraceOptions& options,
                                 const Progress& progress);
  PageClass classOf(const ChosenGraph& choice, const StrokePair& strokes, const Progress& progress);
  ImportAttempt stopped(Failure why, const ChosenGraph& choice, const std::vector<CurveTrace>& curves,
                        Explanation explanation) const;

  StepSeconds seconds_;
  KeptPages pages_;
  KeptGraphs graphs_;
  KeptTracings tracings_;
};

}  // namespace detent::importer
