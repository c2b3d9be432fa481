// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Number of significant digits of a value: a value read off a page has an error, a typed one has none.

#include <optional>
#include <QString>

#include "editor/quantity/quantity.h"
#include "model/button.h"

namespace detent::editor {

/// Units of the axes of the page from which the button was read; empty for other buttons.
std::optional<DisplayUnits> unitsOfPage(const Button& button);

/// Standard errors of values that were read from a page.
struct ReadingError {
  double mm, N;  ///< > 0
};

/// From the button's file: the residuals of the fit and of the axes' ticks, together, over the size of the
/// plot frame. Empty for buttons that were not read off a page.
std::optional<ReadingError> readingErrorOf(const Button& button);

/// A value (mm, N, N/mm) in the shown unit, without that unit. It has as many digits as the error allows, or
/// as were typed since, but at most `significant`.
QString readText(double value, Quantity quantity, const DisplayUnits& units,
                 const std::optional<ReadingError>& error, int significant = 5);

}  // namespace detent::editor
