// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The graphs of a document's pages: searched on request and kept, with their axes read by the present hints.

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "importer/locate_graphs.h"
#include "importer/session/kept_pages.h"
#include "importer/session/step_clock.h"

namespace detent::importer {

/// The inputs on which the graphs of a page and the first reading of their axes depend.
struct LocateKey {
  ViewOptions view;
  AxisHints axes;
  std::vector<Point> frame;
  double magnification = 1;
  bool operator==(const LocateKey&) const = default;
};

LocateKey locateKeyOf(Quality quality, const ImportHints& hints, double magnification = 1);

/// The axis hints of the latest reading of one graph.
struct GraphAxes {
  AxisHints hints;
  std::optional<AxesFound>
      asLocated;  ///< of the search of the page; empty if `hints` are those of the search
};

/// The graphs of one page.
struct PageGraphs {
  LocateKey key;
  LocatedPage located;
  std::vector<GraphAxes> axes;  ///< per graph
  PageUnit unit = PageUnit::pixel;
  std::uint64_t serial = 0;  ///< a new number each time the page is searched
  std::uint64_t usedAt = 0;

  /// The graph as found in the search of the page, even if its axes were read with other hints since.
  ListedGraph listed(int page, std::size_t index) const;
};

/// Graphs of the pages searched so far. The memory of their views is bounded. One thread at a time.
class KeptGraphs {
 public:
  /// Both must outlive this object.
  KeptGraphs(KeptPages& pages, StepSeconds& seconds) : pages_(pages), seconds_(seconds) {}

  KeptPages& pages() { return pages_; }
  const KeptPages& pages() const { return pages_; }

  /// The graphs of a page, searched with these hints. Valid until the page is searched with others.
  Result<PageGraphs*> located(int page, const LocateKey& key, const Progress& progress);

  /// The graphs of a page to which axis hints apply: those found without axis hints, or that of the given
  /// frame.
  Result<PageGraphs*> locatedBeforeHints(int page, LocateKey key, const Progress& progress);

  /// Reads the axes of one graph again if its hints changed; its frame and texts stay as they are.
  Result<Done> readAxesWith(const AxisHints& hints, PageGraphs& onPage, std::size_t index,
                            const Progress& progress);

  /// Reads legend, callouts and titles of a graph, once. Listing graphs does not need them.
  void readAllTexts(LocatedGraph& graph, const Progress& progress);

  /// Renders the view of a graph again if it was freed.
  Result<Done> restoreView(int page, PageGraphs& onPage, std::size_t index, const Progress& progress);

  /// Frees views, those of the least recently used pages first, until the rest is within the bound; never the
  /// view of `keep`, which may be null. Findings on freed views are kept.
  void freeViews(const LocatedGraph* keep);

 private:
  using Key = std::tuple<int, bool, double>;  // page, whether its plot frame is given, magnification

  KeptPages& pages_;
  StepSeconds& seconds_;
  std::map<Key, PageGraphs> graphs_;
  std::uint64_t clock_ = 0;
};

/// Graphs of one page, or of all without a number. An unreadable page among several becomes a remark.
Result<GraphList> listGraphs(KeptGraphs& graphs, std::optional<int> page, const LocateKey& key,
                             const Progress& progress);

}  // namespace detent::importer
