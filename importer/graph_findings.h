// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Results of the steps for one graph, gathered for judgement.

#include <optional>
#include <vector>

#include "importer/callouts/callouts.h"
#include "importer/fit/fit_stroke.h"
#include "importer/locate_graphs.h"
#include "importer/refine/refine_axes.h"
#include "importer/specs/printed_spec.h"
#include "importer/strokes/stroke_pair.h"
#include "importer/trace/explanation.h"

namespace detent::importer {

struct FittedStrokes {
  FittedStroke press;
  std::optional<FittedStroke> release;
};

/// Results of the previous steps for one graph.
struct GraphFindings {
  const LocatedGraph& graph;
  const std::vector<CurveTrace>& traces;
  Found<StrokePair> strokes;
  FittedStrokes fitted;
  double pressNoise_px = 0, releaseNoise_px = 0;
  std::vector<Callout> callouts;
  std::vector<PrintedSpec> specs;
  PageClass pageClass = PageClass::picture;
  Explanation explanation = {};
  std::optional<RefinedAxes> refined = {};  ///< only at levels that refine the axes
};

}  // namespace detent::importer
