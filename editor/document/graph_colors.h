// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Colours drawn over a graph, for light and dark windows.

#include <cstddef>
#include <QColor>
#include <QPalette>

namespace detent::editor {

/// Colours that people with the usual colour vision deficiencies can tell apart (Okabe & Ito, "Color
/// Universal Design", 2008; lightened for dark backgrounds). Strokes differ in dashes too, so no meaning
/// depends on colour alone. Plain value.
struct GraphColors {
  QColor background, grid, axis, text;
  QColor press, release;
  QColor tactilePoint, operatingPoint, resetPoint, bottomOut;
  QColor slopeSection, jumpSection, bottomOutSection;  ///< with alpha, under the curves
  QColor tracedPoint, residual;
  QColor selection, refused;  ///< for selected items; for a forbidden move
};

GraphColors graphColors(bool dark);
/// Colour of the compared buttons, first to sixth, then repeated.
QColor seriesColor(std::size_t index, bool dark);
/// Returns true if the window's background is darker than its text.
bool isDark(const QPalette& palette);

}  // namespace detent::editor
