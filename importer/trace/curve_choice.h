// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which inks draw curves, which only letter, frame and annotate; whether one ink draws both strokes.

#include <optional>
#include <vector>

#include "importer/trace/follow_curve.h"
#include "importer/trace/plot_text.h"

namespace detent::importer::trace {

/// An ink that draws a curve.
struct CurveInk {
  int ink = 0;           ///< index into the palette
  bool neutral = false;  ///< the ink of text and frame
  CoarseCurve course;    ///< on planes pooled by `pooling`
  int pooling = 1;
  double thickness_px = 1;
  double secondStrand = 0;  ///< columns with ink far from the course, as a share of the course's own
};

/// Above this share a second line runs in the same ink (dashes have about half the columns, and strokes touch
/// in places).
inline constexpr double kSecondStrand = 0.18;

/// Everything measured on one plot area.
struct PlotInks {
  const PlotArea& area;
  const Backdrop& backdrop;
  const std::vector<Ink>& palette;
  const Coverage& coverage;
  const PlotText& text;
  std::vector<LegendSample> samples;
};

/// What ink `index` looks like to the follower. `curveInks`: inks that may lie over it as curves; other inks
/// are clutter.
CurveField fieldOf(const PlotInks& plot, int index, const std::vector<int>& curveInks);

/// Ink of text, frame and grid: its direction is theirs, or its colour is grey.
bool isNeutral(const PlotInks& plot, int index);

/// Palette for the final unmixing: the curves' inks, and of the others those that are not mere mixtures of
/// two curves' inks and the paper. `curves` are renumbered.
std::vector<Ink> reducedPalette(const PlotInks& plot, std::vector<CurveInk>& curves);

/// Curves in differently coloured inks, best first. Neutral inks are among them only beside exactly one
/// coloured curve.
std::vector<CurveInk> chooseCurveInks(const PlotInks& plot);

/// The best line in each of these inks, however weak its claim; -1 and repeated ones are skipped.
std::vector<CurveInk> curvesOfInks(const PlotInks& plot, const std::vector<int>& inks);

}  // namespace detent::importer::trace
