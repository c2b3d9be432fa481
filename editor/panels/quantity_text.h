// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers as people type them: with a comma or a point, with a unit or without.

#include <optional>
#include <QString>

#include "editor/document/display_units.h"

namespace detent::editor {

enum class Quantity { length, force, slope };

/// In mm, N or N/mm: a number in the shown unit ("1.25", "1,25"), or with a unit of its own ("60 gf", "0.1
/// in"; slopes have none). nullopt: no number, not finite, or a unit that is not known.
std::optional<double> parseQuantity(const QString& text, Quantity quantity, const DisplayUnits& units);

/// In the shown unit, without it; `digits` significant ones.
QString quantityText(double value, Quantity quantity, const DisplayUnits& units, int digits = 5);

}  // namespace detent::editor
