// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The page of a button, laid behind its curves by what its file says of frame and axes: nothing is read or
// traced anew.

#include <optional>

#include "editor/document/button_document.h"

namespace detent::editor {

/// How much of the press curve must lie on ink of the page, 0..1: a dashed line has more than its gaps, a
/// page that lies wrongly only where gridlines cross, a curve that was reshaped by hand what is left of it.
/// Not yet counted over many sheets (docs/develop/decisions/1064-page-behind-a-button.md).
constexpr double leastOnInk = 0.5;

/// The part of the sheet around the button's plot frame. Turned pages are laid by quarters so that the ink
/// lies under the press curve; nothing where it does not (the curve was reshaped, the page lies askew), where
/// the file keeps no frame or axes, and where the sheet cannot be read. Any thread.
std::optional<PlacedPage> placedPage(const Button& button, const importer::Document& sheet,
                                     const importer::Progress& progress);

}  // namespace detent::editor
