// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Step 2: where the graphs stand on the page. In: Page. Out: one PlotFrame per graph, reading order.
// "Frame" here is the rectangle in which curves are drawn, not the picture's edge and not the box around
// everything.

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
  double position_px =
      0;  ///< view pixels along the axis at the frame's edge where the axis stands, sub-pixel centre
  double width_px = 1;
  bool spansFrame = false;  ///< a gridline; else a tick mark only
};

/// The plot frame in its own view (view pixels).
struct PlotFrame {
  std::array<Point, 4> corners;  ///< top left, top right, bottom right, bottom left, of the upright graph
  std::vector<GridLine>
      xLines;  ///< vertical gridlines and ticks, left to right (position = x at the bottom edge)
  std::vector<GridLine> yLines;  ///< horizontal ones, top to bottom (position = y at the left edge)
  /// Drawn minus meant place of frame, gridlines and ticks: programs that round lines to whole pixels but not
  /// curves shift them (docs/develop/decisions/0401-finding-plot-frames.md). Corners and lines here are where they
  /// are drawn.
  Point drawnOffset_px;
  PaperBy paper = PaperBy::page;  ///< what its lines and numbers stand out of
  Box box() const;                ///< bounding box of the corners
};

/// A graph found on a page: where, which way up. The view that later steps use is made from it.
struct FrameCandidate {
  Box pageBox;  ///< around the frame, in page units
  Homography
      levelToPage;  ///< of a picture askew: the page stood level, where the frame is upright, to the page
  Box uprightBox;   ///< the frame itself on the level page; pageBox where nothing leans
  Box regionBox;    ///< frame with tick labels, titles and legend, on the level page
  int quarterTurns = 0;             ///< clockwise turns that make it upright
  std::vector<Point> givenCorners;  ///< tl, tr, br, bl in page units if the user gave the frame, else empty
  PaperBy paper = PaperBy::page;    ///< what its lines and numbers stand out of
  bool byNumbers = false;           ///< found without lines: edges that are not drawn speak against nothing
};

/// How a page is looked at.
struct FrameSearch {
  PaperBy paper = PaperBy::page;
  std::optional<Homography>
      levelToPage;  ///< how a photograph shows its sheet; empty: a lean of the page's own lines is
                    ///< looked for
  double magnification =
      1;  ///< the picture is looked at so many times its size, (0, 8]; documents as they are
};

/// All frames that could hold a force graph, reading order (top to bottom, left to right). Empty is an
/// answer, not an error.
std::vector<Found<FrameCandidate>> findPlotFrames(const Page& page, const FrameSearch& search = {},
                                                  const Progress& progress = {});

/// Places between a row and a column of evenly spaced numbers, whatever lines stand there. Upright plots only; boxes end
/// at the outermost numbers. Asked where no rectangle of lines holds a graph; paper is told by region.
/// `search.paper` is not asked.
std::vector<Found<FrameCandidate>> findPlotsByNumbers(const Page& page, const FrameSearch& search = {},
                                                      const Progress& progress = {});

/// The candidate as it stands on a level page so many times its size; its view is as much larger. Pictures only.
FrameCandidate magnified(FrameCandidate candidate, double magnification);

/// From the level sheet to the picture that a camera took of it: lines of the page run towards two vanishing points. Empty
/// for documents, and where too few lines agree. The middle of the page stays where it is, at its size.
std::optional<Homography> photographedSheet(const Page& page);

/// The same from the corners of an upright frame on the sheet (tl, tr, br, bl, page units). Empty where they stand level
/// already, and where no camera shows a frame so.
std::optional<Homography> sheetOfCorners(const std::vector<Point>& corners, const Page& page);

/// The frame a user gave: 2 opposite corners or 4 (tl, tr, br, bl), page units. Confidence 1, decided by
/// `given`. Failure wrongUsage: other counts, corners outside the page, no area.
Result<Found<FrameCandidate>> frameFromCorners(const std::vector<Point>& corners, const Page& page);

/// Sub-pixel frame, gridlines and ticks in the candidate's view.
Result<Found<PlotFrame>> locatePlotFrame(const PageView& view, const Page& page,
                                         const FrameCandidate& candidate, const Progress& progress = {});

}  // namespace detent::importer
