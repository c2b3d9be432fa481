// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pictures that store colour at half resolution (JPEG and WebP with 4:2:0) surround every coloured line with a
// pale halo of its hue and thin its own colour out. Their brightness is sharp: it says how much of a pixel the
// line covers, and the colour follows.

#include "importer/page/raster.h"

namespace detent::importer::trace {

struct ChromaOptions {
  double leastChroma = 12;    ///< colour levels from the paper's own; less is noise of the coding
  double leastContrast = 10;  ///< brightness levels of a line's core; paler inks keep their colour as it is
  int reach_px =
      static_cast<int>(3);  ///< how far colour spreads: two blocks of 2 x 2 pixels, less the line's own
  double sameHue = 0.8;     ///< cosine between the colours of a halo and of its line's core
  /// How sharply colour changes from pixel to pixel, against brightness: 0.73 to 0.84 at 4:2:0, 0.99 to 1.2 at full
  /// resolution on white paper (letters smoothed by sub-pixels included), but 0.80 to 0.86 for thin lines on dark paper, which
  /// settling would move by 0.2 px. Colour sharper than this is left alone.
  double sharpness = 0.80;
};

/// Moves spread colour back to where the brightness shows its line; leaves pictures alone whose colour is at
/// full resolution. `paper`: the area's own colour. Whether anything was moved.
bool settleChroma(Raster& raster, Rgb paper, const ChromaOptions& options = {});

}  // namespace detent::importer::trace
