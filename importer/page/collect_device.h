// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A MuPDF device that collects the paths and images of a page while it records the page for later rendering.
// Private to importer/page.

#include <vector>

#include "importer/page/mupdf_context.h"
#include "importer/page/page.h"
#include "importer/page/seen_text.h"

namespace detent::importer {

/// An image with the map from its pixel corners (0..width, 0..height) to page units.
struct ImagePlacement {
  PlacedImage image;
  Affine pixelsToPage;
};

/// Result of the device: everything drawn on a page. Coordinates in page units.
struct CollectedPage {
  std::vector<VectorPath> paths;
  std::vector<ImagePlacement> images;
  Visibility visibility;  ///< visibility of its letters
};

enum class CollectStop {
  none,
  tooManyPoints,
  tooManyOperations,
  tooDense,
  tooSlow,
  imageTooLarge,
  cancelled,
  outOfMemory
};

/// Limits of one page, and the reason if the device stopped.
struct CollectControl {
  std::size_t maxPathPoints = 0;
  std::size_t maxOperations = 0;
  double maxImagePixels = 0;
  /// Largest summed vertical extent of one object's lines, page units. It bounds the time of drawing one
  /// object, which MuPDF cannot interrupt.
  double maxRise = 0;
  fz_cookie* cookie = nullptr;
  CollectStop stop = CollectStop::none;
  int imageWidth_px = 0, imageHeight_px = 0;  ///< size of the image that was too large
};

VectorPath transformedPath(const VectorPath& path, const Affine& map);

/// Device that fills `page`, and forwards everything to `recorder` (kept). `bounds`: the page in page units.
/// `page` and `control` outlive the device. Throws as MuPDF does; FZ_ERROR_ABORT after `control.stop` was
/// set.
fz_device* newCollectDevice(fz_context* context, fz_device* recorder, const Box& bounds, CollectedPage* page,
                            CollectControl* control);

}  // namespace detent::importer
