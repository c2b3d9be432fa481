// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page behind a button's curves as stored in the button's file
// (docs/develop/decisions/1064-page-behind-a-button.md).

#include <optional>

#include "editor/document/button_document.h"
#include "model/file/page_cutout.h"

namespace detent::editor {

/// PNG of the page, reduced if the whole would exceed largestCutout_bytes; nullopt if even a small one would.
/// 50 to 300 ms. Any thread.
std::optional<PageCutout> cutoutOf(const PlacedPage& page);
/// nullopt for a picture that cannot be read. Any thread.
std::optional<PlacedPage> placedFrom(const PageCutout& cutout);

/// The plot frame of the page in mm and N, y upwards; empty for a button that was not read off a page.
std::optional<QRectF> frameOf(const Provenance& from);

}  // namespace detent::editor
