// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Icons of the import dialogue, drawn in the window's text colour: sharp on every screen, right in light and
// dark.

#include <QIcon>
#include <QPalette>

#include "editor/importing/page_view.h"

namespace detent::editor {

enum class ViewIcon { undo, redo, fitGraph, fitPage, zoomIn, zoomOut };

QIcon toolIcon(ToolKind kind, const QPalette& palette);
QIcon viewIcon(ViewIcon kind, const QPalette& palette);

}  // namespace detent::editor
