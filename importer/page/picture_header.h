// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Size and format of a picture file, read before any pixel is decoded;
// docs/develop/decisions/0301-input-limits.md. Private to importer/page.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "importer/page/raster.h"
#include "model/message.h"

namespace detent::importer {

enum class FileKind { unknown, png, jpeg, bmp, tiff, webp, pdf, svg, gif, heic, avif, jpeg2000 };

/// Determines the kind from the content, never from the name. Any bytes.
FileKind sniffFileKind(std::span<const unsigned char> bytes);

/// "PNG picture", "PDF document", ...
Message kindName(FileKind kind);

/// The kind that the file name's extension stands for; unknown for other extensions.
FileKind kindOfName(const std::string& name);

/// Returns true for pictures that this build reads.
bool isPicture(FileKind kind);

/// Returns true for known picture formats that are not read.
bool isForeignPicture(FileKind kind);

/// One picture of the file (TIFF may hold several). Sizes as stored, before any orientation.
struct PictureHeader {
  long long width_px = 0, height_px = 0;
  int orientation = 1;              ///< EXIF, 1..8
  std::optional<double> dpi;        ///< the horizontal one
  bool complete = true;             ///< false: the file ends before its end mark or before its last pixel
  std::size_t directoryOffset = 0;  ///< TIFF: offset of this picture's directory
};

/// All pictures of the file, first one first; empty if the header cannot be understood. At most
/// `maxPictures`.
std::vector<PictureHeader> readPictureHeaders(std::span<const unsigned char> bytes, FileKind kind,
                                              int maxPictures);

}  // namespace detent::importer
