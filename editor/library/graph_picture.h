// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small pictures of force graphs for lists.

#include <QImage>

#include "editor/document/graph_colors.h"
#include "model/button.h"

namespace detent::editor {

/// All states of a button, press solid and release dashed, without axes. `size_px` in logical pixels, at
/// least 16 x 16; `devicePixelRatio` > 0. Any thread.
QImage graphPicture(const Button& button, QSize size_px, double devicePixelRatio, const GraphColors& colors);

}  // namespace detent::editor
