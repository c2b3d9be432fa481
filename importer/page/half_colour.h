// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pictures stored with colour at half resolution (JPEG and lossy WebP as most tools write them). Private to
// importer/page.

#include "importer/page/stored_picture.h"

namespace detent::importer {

/// Number of pixels that share one colour.
struct ColourBlock {
  int across_px = 2, down_px = 2;
};

/// Makes red, green and blue of brightness, Cb and Cr (JFIF's, full range, in the picture's first three
/// channels; colour the same all over a block). Within a block colour follows brightness as it does around
/// it, so that a line keeps its colour and the paper beside it has none
/// (docs/develop/decisions/0500-colours-of-curves.md).
void colourByBrightness(StoredPicture& picture, ColourBlock block);

}  // namespace detent::importer
