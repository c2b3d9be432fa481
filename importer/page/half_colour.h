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

/// Computes red, green and blue from brightness, Cb and Cr (JFIF's, full range, in the picture's first three
/// channels; the colour is constant within a block). Within a block colour is assumed to follow brightness as
/// in its surroundings, so that a line keeps its colour and the paper beside it has none
/// (docs/develop/decisions/0500-colours-of-curves.md).
void colourByBrightness(StoredPicture& picture, ColourBlock block);

}  // namespace detent::importer
