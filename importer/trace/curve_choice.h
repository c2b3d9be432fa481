// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Decides which colours draw curves, and which only letters, frame and annotations; and whether one colour
// draws both strokes.

#include <optional>
#include <vector>

#include "importer/trace/colour_coverage.h"
#include "importer/trace/follow_curve.h"

namespace detent::importer::trace {

/// A colour that draws a curve.
struct CurveColour {
  int entryIndex = 0;    ///< index into the palette
  bool neutral = false;  ///< colour of text and frame
  CoarseCurve path;      ///< on planes pooled by `pooling`
  int pooling = 1;
  double thickness_px = 1;
  bool dashed = false;      ///< found after joining its dashes, see dashesJoined
  double secondStrand = 0;  ///< columns with this colour far from the path, as a share of the path's own
  std::vector<int> shades;  ///< other colours of the palette that draw the same line
};

struct CurveChoiceOptions {
  double minSpan = 0.12;                 ///< share of the frame's width; shorter lines are no curves
  double minCoveredShare = 0.5;          ///< of its visible path; dashes have about this share
  double minCoveredShareNeutral = 0.85;  ///< the same in the colour of text and frame
  double minOwnShare = 0.6;              ///< share of that colour's pixels; a line with more owns the colour
  /// Share of its visible path above which a line is solid, even after compression; dotted ones have 0.83 at
  /// most.
  double solidColour = 0.9;
  double minOwnColumns = 0.4;  ///< share of the spanned columns; the rest may be bridged
  double minExplained = 0.3;   ///< of the colour's pixels outside text and legend
  double minOfBest = 0.3;      ///< of the best curve's gain; less is a remainder of something else
  double minStrength = 0.22;   ///< of the best curve's contrast; less is shaded paper
  double strandsApart = 0.02;  ///< share of the frame's height, between two strokes of one colour
  /// Share of its columns above which a second line has the same colour; dashes have about half, and strokes
  /// touch.
  double secondStrand = 0.18;
  double haloStrength = 0.6;  ///< of the line's contrast; a paler line along it is its halo
  double tintStrength = 0.8;  ///< the same for a halo of the line's own hue
  double fillWidth = 0.02;  ///< share of the frame's smaller side; a mark that is wider everywhere is no line
  double fillShare = 0.5;   ///< of a colour's pixels in such wide places; more is a band or a filled area
  double haloAlong = 0.9;   ///< share of a halo's path that lies on its line
};

/// A legend key: a short horizontal line of one colour, isolated, beside a row of text.
struct LegendSample {
  Box box;
  int entryIndex = 0;  ///< index into the coverage
  Box text;            ///< of the text beside it
};

/// The scene's pixels separated by the colours of a palette. Refers to the scene.
struct PlotColours {
  PlotColours(const PlotScene& itsScene, std::vector<PaletteColour> itsPalette);

  const PlotScene& scene;
  std::vector<PaletteColour> palette;
  Coverage coverage;          ///< without the error bars
  std::size_t errorBars = 0;  ///< erased from it
  std::vector<LegendSample> samples;
  CurveChoiceOptions options = {};

  const PlotArea& area() const { return scene.area(); }
  const PaletteColour& entry(int index) const { return palette[static_cast<std::size_t>(index)]; }
  Rgb colorOf(const PaletteColour& colour) const { return rgbOf(scene.paper() + colour.difference()); }
};

/// Field in which colour `index` is followed. `curveColours`: colours that may cover it as curves; other
/// colours are clutter.
CurveField fieldOf(const PlotColours& plot, int index, const std::vector<int>& curveColours);

/// Field for a dashed line's path; nullopt if the colour is not drawn in dashes.
std::optional<CurveField> dashesJoined(const CurveField& field);

/// Field of a dashed line in which other curves hide only its dashes: beside a gap a neighbour hides nothing.
CurveField besideDashesOnly(const CurveField& field);

/// Returns true for a colour of text, frame and grid: grey, or with their direction.
bool isNeutral(const PlotColours& plot, int index);

/// Palette for the final separation: the curves' colours, and other colours that are not mere mixtures of two
/// curves' colours and the paper. `curves` are renumbered.
std::vector<PaletteColour> reducedPalette(const PlotColours& plot, std::vector<CurveColour>& curves);

/// Curves in different colours, best first. A neutral colour is included only beside exactly one coloured
/// curve, or as one more switch.
std::vector<CurveColour> chooseCurveColours(const PlotColours& plot);

/// A line of a colour's full strength and one of its paler shade, both along the travel; empty unless both
/// are curves.
std::vector<CurveColour> curvesInShades(const PlotColours& plot, int stronger, int paler);

/// A curve in the colour of frame and text beside one colour that draws both strokes: another switch.
std::optional<CurveColour> neutralCurveBeside(const PlotColours& plot, const CurveColour& loop);

/// The best line of each of these colours, however weak; -1 and duplicates are skipped.
std::vector<CurveColour> curvesOfColours(const PlotColours& plot, const std::vector<int>& colours);

}  // namespace detent::importer::trace
