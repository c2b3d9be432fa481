// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The program's colours: light, dark, or like the system's.

#include <QPalette>

#include "editor/document/view_settings.h"

class QStyle;

namespace detent::editor {

/// Palettes for Qt's Fusion style; text on every background has a contrast of 4.5 : 1 or more.
QPalette lightPalette();
QPalette darkPalette();

/// Qt's Fusion style with outlines of fields, boxes and buttons that have a contrast of 3 : 1 or more to
/// every background (Fusion derives them from the window's colour: on a dark background they cannot be seen).
/// The caller owns it.
QStyle* outlinedStyle();

/// The palette for a choice. `system`: the palette that the desktop gave the program at its start; only
/// whether it is dark matters, its colours are not used.
QPalette paletteFor(Appearance appearance, const QPalette& system);

}  // namespace detent::editor
