// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Colours of everything drawn over a graph, for light and dark windows.

#include <cstddef>
#include <QColor>
#include <QPalette>

namespace detent::editor {

/// A set that people with any of the usual colour vision deficiencies can tell apart (Okabe & Ito, "Color
/// Universal Design", 2008; lightened for dark ground). Strokes differ in dash too, so no meaning hangs on
/// colour alone. Plain value.
struct GraphColors {
  QColor background, grid, axis, text;
  QColor press, release;
  QColor tactilePoint, operatingPoint, resetPoint, wall;
  QColor slopeSection, jumpSection, bottomOutSection;  ///< with alpha: laid under the curves
  QColor tracedPoint, residual;
  QColor selection, refused;  ///< what is selected; a move that a rule forbids
};

GraphColors graphColors(bool dark);
/// Of buttons that are compared, the first to the sixth; then they begin anew.
QColor seriesColor(std::size_t index, bool dark);
/// Dark where the window's background is darker than its text.
bool isDark(const QPalette& palette);

}  // namespace detent::editor
