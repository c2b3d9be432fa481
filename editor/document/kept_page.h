// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page behind a button's curves as the button's file keeps it (docs/develop/decisions/1064-page-behind-a-button.md).

#include <optional>

#include "editor/document/button_document.h"
#include "model/file/page_cutout.h"

namespace detent::editor {

/// A PNG of the page, smaller than it is shown where the whole would be above largestCutout_bytes; nothing where
/// even a small one would be. 50 to 300 ms. Any thread.
std::optional<PageCutout> cutoutOf(const PlacedPage& page);
/// Nothing for a picture that cannot be read. Any thread.
std::optional<PlacedPage> placedFrom(const PageCutout& cutout);

}  // namespace detent::editor
