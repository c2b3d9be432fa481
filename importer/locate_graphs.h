// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From pages to graphs with two calibrated axes: runs the frame and axes steps on every candidate of a page.

#include <vector>

#include "importer/axes/axis_calibration.h"
#include "importer/frame/plot_frame.h"
#include "importer/importer.h"
#include "importer/page/document.h"
#include "importer/page/progress.h"

namespace detent::importer {

/// A graph with everything the tracing needs.
struct LocatedGraph {
  Found<FrameCandidate> candidate;
  PageView view;
  Found<PlotFrame> frame;
  AxesFound axes;
  bool textsComplete = false;  ///< readGraphTexts has run
  /// Confidence that this is a force graph read with the right axes; 0..1.
  double confidence() const;
  /// Findings of the two steps so far: plot frame and axes.
  std::vector<StepFinding> findings() const;
};

/// The region of a candidate, as it is read.
Result<PageView> viewOf(const Document& document, const Page& page, const FrameCandidate& candidate,
                        const ViewOptions& options, const Progress& progress = {});

/// Result for one page: graphs in reading order, rejected frames, and the reason why the most promising of
/// these was rejected.
struct LocatedPage {
  std::vector<LocatedGraph> graphs;
  std::vector<RejectedFrame> rejected;
  std::optional<Failure> bestRejection;
};

struct LocateOptions {
  ViewOptions view;
  AxisHints axes;
  std::vector<Point> frameCorners;  ///< empty, 2 or 4, page units: the frame is given
  double magnification = 1;         ///< pictures are read at so many times their size, (0, 8]
};

/// A candidate whose axes cannot be read is not a force graph, unless its frame was given by hand.
Result<LocatedPage> locateGraphs(const Document& document, const Page& page, const LocateOptions& options,
                                 const Progress& progress = {});

}  // namespace detent::importer
