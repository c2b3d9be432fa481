// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Step 2: finds the plot frames of a page. In: Page. Out: one PlotFrame per graph, in reading order. "Frame"
// is the rectangle in which curves are drawn, neither the picture's edge nor the box around everything.

#include <array>
#include <optional>
#include <vector>

#include "importer/frame/paper.h"
#include "importer/page/found.h"
#include "importer/page/page.h"
#include "importer/page/progress.h"

namespace detent::importer {

/// A line of the grid, or a tick, at one position along an axis.
struct GridLine {
  double position_px = 0;  ///< view pixels along the axis at the frame's edge, sub-pixel centre
  double width_px = 1;
  bool spansFrame = false;  ///< true for a gridline; false for a tick mark
};

/// The plot frame in its own view (view pixels).
struct PlotFrame {
  std::array<Point, 4> corners;  ///< top left, top right, bottom right, bottom left, of the upright graph
  std::vector<GridLine>
      xLines;  ///< vertical gridlines and ticks, left to right (position = x at the bottom edge)
  std::vector<GridLine> yLines;  ///< horizontal ones, top to bottom (position = y at the left edge)
  /// Drawn minus intended position of frame, gridlines and ticks. Programs that round lines to whole pixels,
  /// but not curves, shift them (docs/develop/decisions/0401-finding-plot-frames.md). Corners and lines here
  /// are as drawn.
  Point drawnOffset_px;
  PaperBy paper = PaperBy::page;  ///< reference for lines and labels
  Box box() const;                ///< bounding box of the corners
};

/// A graph found on a page with its orientation. The view of later steps is made from it.
struct FrameCandidate {
  Box pageBox;  ///< around the frame, in page units
  Homography
      levelToPage;  ///< map to the page from the levelled page, on which the frame of a tilted picture is
                    ///< upright
  Box uprightBox;   ///< the frame on the levelled page; pageBox without tilt
  Box regionBox;    ///< frame with tick labels, titles and legend, on the levelled page
  int quarterTurns = 0;             ///< clockwise turns that make it upright
  std::vector<Point> givenCorners;  ///< tl, tr, br, bl in page units if given by the user, else empty
  PaperBy paper = PaperBy::page;    ///< reference for lines and labels
  bool byNumbers = false;           ///< found without lines, so missing edges are no evidence against it
};

/// Options of a frame search.
struct FrameSearch {
  PaperBy paper = PaperBy::page;
  std::optional<Homography>
      levelToPage;  ///< map of a photographed sheet; nullopt: the tilt of the page's lines is measured
  double magnification = 1;  ///< scale of the picture, (0, 8]; documents are not scaled
};

/// Returns all frames that could hold a force graph, in reading order (top to bottom, left to right). May be
/// empty.
std::vector<Found<FrameCandidate>> findPlotFrames(const Page& page, const FrameSearch& search = {},
                                                  const Progress& progress = {});

/// Returns regions between a row and a column of evenly spaced labels, regardless of lines. Upright plots
/// only; boxes end at the outermost labels. Used if no rectangle of lines holds a graph; paper is by region,
/// `search.paper` is ignored.
std::vector<Found<FrameCandidate>> findPlotsByNumbers(const Page& page, const FrameSearch& search = {},
                                                      const Progress& progress = {});

/// The candidate on a levelled page scaled by `magnification`. Pictures only.
FrameCandidate magnified(FrameCandidate candidate, double magnification);

/// Map from the level sheet to the camera picture, by the vanishing points of its lines. nullopt for
/// documents, and if too few lines agree. The middle of the page keeps its place and size.
std::optional<Homography> photographedSheet(const Page& page);

/// The same from the corners of an upright frame on the sheet (tl, tr, br, bl, page units). nullopt if they
/// are level already, or if no camera shows a frame so.
std::optional<Homography> sheetOfCorners(const std::vector<Point>& corners, const Page& page);

/// The frame given by the user: 2 opposite corners or 4 (tl, tr, br, bl), page units. Confidence 1, decided
/// by `given`. Failure wrongUsage: another number of corners, corners outside the page, or no area.
Result<Found<FrameCandidate>> frameFromCorners(const std::vector<Point>& corners, const Page& page);

/// Sub-pixel frame, gridlines and ticks in the candidate's view.
Result<Found<PlotFrame>> locatePlotFrame(const PageView& view, const Page& page,
                                         const FrameCandidate& candidate, const Progress& progress = {});

}  // namespace detent::importer
