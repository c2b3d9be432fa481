// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From encoded bytes to upright opaque 8-bit sRGB. Private to importer/page.

#include <optional>
#include <span>

#include "importer/page/picture_header.h"

namespace detent::importer {

/// Decodes the picture that `header` describes: palette, grey, 16-bit and CMYK become 8-bit RGB, the EXIF
/// orientation is applied, transparency is laid on white, or on black where the visible lines would vanish on
/// white. Nothing if the decoder refuses the bytes or gives a size other than the header's. May take hundreds
/// of milliseconds.
std::optional<Raster> decodePicture(std::span<const unsigned char> bytes, FileKind kind,
                                    const PictureHeader& header);

}  // namespace detent::importer
