// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Chooses the pixel grid on which a region of a document page is drawn: that of its embedded image, or a new
// one. docs/develop/decisions/0300-page-views-and-large-pictures.md. Private to importer/page.

#include <optional>
#include <vector>

#include "importer/page/collect_device.h"
#include "importer/page/crop.h"
#include "importer/page/page.h"

namespace detent::importer {

/// A grid over the upright page: pixel (i,j) covers origin + (i..i+1)*pitchX, (j..j+1)*pitchY in page units.
struct ViewGrid {
  Point origin;
  double pitchX = 1, pitchY = 1;  ///< page units per pixel, > 0
  PixelRect rect;                 ///< the pixels of the region
  bool nativePixels = false;      ///< the grid is that of the image that fills the region

  /// Page units to pixel corners of the whole grid (not of rect).
  Affine pageToUprightCorners() const;
  /// Pixel centres of the turned view of `rect` to page units.
  Affine viewToPage(int quarterTurns) const;
};

/// The whole page at `scale` pixels per unit, or less so that no side exceeds maxSide_px.
ViewGrid overviewGrid(double width, double height, double scale, double maxSide_px);

/// Nothing if the region lies outside the page. `images`: the page's.
std::optional<ViewGrid> chooseGrid(const Box& region, int quarterTurns, const Page& page,
                                   const std::vector<ImagePlacement>& images, const ViewOptions& options,
                                   double maxPixels);

/// Adds the texts and paths of the page that touch the region to its view, in view pixels.
void carryContent(const Page& page, const Box& region, int quarterTurns, const Affine& pageToView,
                  PageView& view);

}  // namespace detent::importer
