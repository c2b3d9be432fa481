// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which inks draw curves, which only letter, frame and annotate; whether one ink draws both strokes.

#include <optional>
#include <vector>

#include "importer/trace/follow_curve.h"
#include "importer/trace/ink_coverage.h"

namespace detent::importer::trace {

/// An ink that draws a curve.
struct CurveInk {
  int ink = 0;           ///< index into the palette
  bool neutral = false;  ///< the ink of text and frame
  CoarseCurve course;    ///< on planes pooled by `pooling`
  int pooling = 1;
  double thickness_px = 1;
  bool dashed = false;      ///< found with its dashes joined, see dashesJoined
  double secondStrand = 0;  ///< columns with ink far from the course, as a share of the course's own
  std::vector<int> shades;  ///< other inks of the palette that draw the same line
};

struct CurveChoiceOptions {
  double minSpan = 0.12;             ///< of the frame's width, of a line that may be a curve
  double minInkShare = 0.5;          ///< of its visible course: dashes have about this much
  double minInkShareNeutral = 0.85;  ///< the same in the ink of text and frame
  double ownInk = 0.6;               ///< of that ink's mass: a line with more of it has the ink for its own
  /// Of its visible course: with more a line is solid, whatever compression makes of it; dotted ones have 0.83 at most.
  double solidInk = 0.9;
  double minOwnColumns = 0.4;  ///< of the columns spanned; the rest may be bridged
  double minExplained = 0.3;   ///< of the ink's mass outside text and legend
  double minOfBest = 0.3;      ///< of the best curve's gain: less is a rest of something
  double minStrength = 0.22;   ///< of the best curve's contrast: less is shaded paper
  double strandsApart = 0.02;  ///< of the frame's height, between two strokes in one ink
  /// Above this share of its columns a second line runs in the ink: dashes have about half, and strokes touch.
  double secondStrand = 0.18;
  double haloStrength = 0.6;  ///< of the line's contrast: a paler one along it is its halo
  double tintStrength = 0.8;  ///< the same for a halo of the line's own hue
  double fillWidth = 0.02;    ///< of the frame's smaller side: what is wider all along is no line
  double fillShare = 0.5;     ///< of an ink's mass in places so wide: a band or a filled area
  double haloAlong = 0.9;     ///< share of a halo's course that lies on its line
};

/// A legend's sample line: a short level piece of one ink, alone, beside a text row.
struct LegendSample {
  Box box;
  int ink = 0;  ///< index into the coverage
  Box text;     ///< of the row beside it
};

/// The scene's ink parted among a palette. Refers to the scene.
struct PlotInks {
  PlotInks(const PlotScene& itsScene, std::vector<Ink> itsPalette);

  const PlotScene& scene;
  std::vector<Ink> palette;
  Coverage coverage;
  std::vector<LegendSample> samples;
  CurveChoiceOptions options = {};

  const PlotArea& area() const { return scene.area(); }
  const Ink& ink(int index) const { return palette[static_cast<std::size_t>(index)]; }
  Rgb colorOf(const Ink& its) const { return rgbOf(scene.paper() + its.difference()); }
};

/// What ink `index` looks like to the follower. `curveInks`: inks that may lie over it as curves; other inks
/// are clutter.
CurveField fieldOf(const PlotInks& plot, int index, const std::vector<int>& curveInks);

/// The field to look for a dashed line's course on; nothing where the ink is not drawn in dashes.
std::optional<CurveField> dashesJoined(const CurveField& field);

/// The field of a dashed line in which other curves hide its dashes alone: beside a gap a neighbour hides nothing.
CurveField besideDashesOnly(const CurveField& field);

/// Ink of text, frame and grid: its direction is theirs, or its colour is grey.
bool isNeutral(const PlotInks& plot, int index);

/// Palette for the final unmixing: the curves' inks, and of the others those that are not mere mixtures of
/// two curves' inks and the paper. `curves` are renumbered.
std::vector<Ink> reducedPalette(const PlotInks& plot, std::vector<CurveInk>& curves);

/// Curves in differently coloured inks, best first. A neutral ink is among them only beside exactly one
/// coloured curve, or as one more switch.
std::vector<CurveInk> chooseCurveInks(const PlotInks& plot);

/// A line of an ink's own strength and one of its paler shade, both along the travel; nothing where not both are curves.
std::vector<CurveInk> curvesInShades(const PlotInks& plot, int stronger, int paler);

/// A curve in the ink of frame and text beside one coloured ink that draws both strokes: another switch's.
std::optional<CurveInk> neutralCurveBeside(const PlotInks& plot, const CurveInk& loop);

/// The best line in each of these inks, however weak its claim; -1 and repeated ones are skipped.
std::vector<CurveInk> curvesOfInks(const PlotInks& plot, const std::vector<int>& inks);

}  // namespace detent::importer::trace
