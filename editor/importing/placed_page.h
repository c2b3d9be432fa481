// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page of a button, placed behind its curves by the frame and axes that its file states; nothing is read
// or traced again.

#include <optional>

#include "editor/document/button_document.h"

namespace detent::editor {

/// Share of the press curve that must lie on marks of the page, 0..1: a dashed line covers more than its
/// gaps; on a wrongly placed page only crossings with gridlines are covered; a curve reshaped by hand keeps
/// its unchanged part. Not yet counted over many sheets
/// (docs/develop/decisions/1064-page-behind-a-button.md).
constexpr double leastOnCurve = 0.5;

/// The part of the sheet around the button's plot frame. Turned pages are laid by quarters so that marks lie
/// under the press curve; nothing if they do not (the curve was reshaped, the page is tilted), if the file
/// keeps no frame or axes, or if the sheet cannot be read. Any thread.
std::optional<PlacedPage> placedPage(const Button& button, const importer::Document& sheet,
                                     const importer::Progress& progress);

}  // namespace detent::editor
