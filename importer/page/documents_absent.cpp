// SPDX-License-Identifier: GPL-3.0-or-later
// For builds without DETENT_WITH_MUPDF: PDF, SVG and BMP are recognised and refused; no words are drawn.

#include "importer/page/drawn_words.h"
#include "importer/page/page_source.h"
#include "importer/page/stored_picture.h"

namespace detent::importer {
namespace {

Failure absent(const SourceFile& file, const std::string& kind) {
  return unreadable(file.name, "",
                    Message("this build of Detent cannot read %1 files (it was built without MuPDF)", kind),
                    Message("Export the page as a PNG of at least 300 dpi and import that, or install a "
                            "build of Detent with MuPDF"));
}

}  // namespace

OpenedSource openBmpSource(const SourceFile& file) { return absent(file, "BMP"); }
OpenedSource openPdfSource(const SourceFile& file) { return absent(file, "PDF"); }
OpenedSource openSvgSource(const SourceFile& file) { return absent(file, "SVG"); }

std::optional<StoredPicture> decodeBmp(std::span<const unsigned char>, int, int) { return {}; }
std::optional<Raster> wordsDrawn(const std::string&, int) { return {}; }

}  // namespace detent::importer
