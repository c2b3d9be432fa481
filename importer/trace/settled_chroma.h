// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// JPEG and WebP with 4:2:0 store colour at half resolution. Every coloured line then has a pale halo of its
// hue and weaker colour itself. Brightness is sharp and shows how much of a pixel the line covers; the colour
// is derived from it.

#include "importer/page/raster.h"

namespace detent::importer::trace {

struct ChromaOptions {
  double leastChroma = 12;    ///< colour levels from the paper's own; less is coding noise
  double leastContrast = 10;  ///< brightness levels of a line's core; paler colours stay as they are
  int reach_px =
      static_cast<int>(3);  ///< px by which colour spreads: two blocks of 2 x 2 pixels, less the line's own
  double sameHue = 0.8;     ///< cosine between the colours of a halo and its line's core
  /// Sharpness of colour relative to brightness: 0.73 to 0.84 at 4:2:0; 0.99 to 1.2 at full resolution on
  /// white paper (sub-pixel text included), but 0.80 to 0.86 for thin lines on dark paper, which correction
  /// would move by 0.2 px. Sharper colour is left alone.
  double sharpness = 0.80;
};

/// Moves spread colour back to its line; leaves pictures with full-resolution colour alone. `paper`: the
/// area's own colour. Returns true if anything was moved.
bool settleChroma(Raster& raster, Rgb paper, const ChromaOptions& options = {});

}  // namespace detent::importer::trace
