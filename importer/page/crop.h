// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Native pixels of a region, turned upright. Private to importer/page.

#include <optional>

#include "importer/page/page.h"

namespace detent::importer {

/// Whole pixels: left, top inclusive; width and height > 0.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

/// The pixels that a region (in pixel-centre coordinates, where pixel i covers i-0.5 .. i+0.5) touches,
/// clipped to the raster; nothing if it touches none.
std::optional<PixelRect> touchedPixels(const Box& region, int width_px, int height_px);

/// Copy of a rectangle, turned clockwise by quarterTurns * 90°. `rect` lies inside the raster (checked).
Raster turnedCrop(const Raster& raster, const PixelRect& rect, int quarterTurns);

/// A raster of the given size. `toSource` maps its pixels to those of `source`, which is interpolated
/// bicubically (Catmull-Rom). Pixels outside of `source` get the most frequent colour of its border.
Raster resampled(const Raster& source, const Homography& toSource, int width_px, int height_px);

/// Map from the turned crop's pixels back to the raster's.
Affine turnedCropToRaster(const PixelRect& rect, int quarterTurns);

/// The rectangle with `factor` by `factor` pixels averaged into one (fewer at its right and lower edge); > 0.
Raster reducedCrop(const Raster& raster, const PixelRect& rect, int factor);

/// Map from the reduced crop's pixels back to the raster's.
Affine reducedCropToRaster(const PixelRect& rect, int factor);

}  // namespace detent::importer
