// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Settings of draft, standard and precise: one documented set each. docs/measurements/bench-importer.md has
// the measured trade.

#include "importer/fit/fit_options.h"
#include "importer/page/page.h"
#include "importer/trace/curve_trace.h"
#include "model/named_values.h"

namespace detent::importer {

enum class Quality { draft, standard, precise };

inline constexpr auto qualities = named<Quality>(
    {{"draft", Quality::draft}, {"standard", Quality::standard}, {"precise", Quality::precise}});
inline const char* nameOf(Quality quality) { return qualities.word(quality); }

/// Settings of one quality level, for all steps.
struct QualitySettings {
  ViewOptions view;
  TraceOptions trace;
  FitEffort fit = FitEffort::standard;
  double traceNoise_px = 0;      ///< expected noise of a traced point across the curve, raster
  bool secondOpinion = false;    ///< pages are read again at another size (importer/second_opinion.h)
  bool refineAxes = false;       ///< refines the axes from whole lines (importer/refine); pictures only
  double vectorNoise_share = 0;  ///< the same for vector curves, as a share of the plot frame's size
};

QualitySettings settingsFor(Quality quality);

}  // namespace detent::importer
